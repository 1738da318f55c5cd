// fly.c in C#, with ../bindings/Talus.cs: Fly [HOST [PORT [TOKEN]]]
using System;
using System.Globalization;
using System.Runtime.InteropServices;

public static class Fly
{
    static IntPtr client;

    static int Check(int status)
    {
        if (status < 0) throw new Exception(Talus.Text(Talus.talus_last_error(client)));
        return status;
    }

    static void Run(string host, uint port, string token)
    {
        var options = Talus.talus_connect_options.Create();
        var talusEvent = Talus.talus_event.Create();
        var world = Talus.talus_world.Create();
        var view = Talus.talus_view.Create();
        var voxels = new ushort[Talus.TALUS_CHUNK_VOLUME];
        ulong chunks = 0, uniform = 0, solid = 0;
        bool complete = false, heights = false;
        uint request;

        uint version = Talus.talus_api_version();
        if (version >> 16 != Talus.TALUS_API_MAJOR) throw new Exception("libtalus has interface " + (version >> 16) + ", not " + Talus.TALUS_API_MAJOR);
        Check(Talus.talus_create(out client));
        options.host = Talus.Allocate(host);
        options.token = Talus.Allocate(token);
        options.port = port;
        Check(Talus.talus_connect(client, ref options));
        Marshal.FreeHGlobal(options.host);
        Marshal.FreeHGlobal(options.token);
        view.horizontal_radius = 8;
        view.vertical_radius = 4;

        while (!complete || !heights)
        {
            if (Check(Talus.talus_poll(client, ref talusEvent, 10000)) == Talus.TALUS_NO_EVENT) continue;
            switch (talusEvent.type)
            {
                case Talus.TALUS_EVENT_JOINED:
                    Check(Talus.talus_get_world(client, ref world));
                    view.centre_x = world.spawn_x;
                    view.centre_y = world.spawn_y;
                    view.centre_z = world.spawn_z;
                    Check(Talus.talus_set_view(client, ref view));
                    Check(Talus.talus_get_heights(client, new[] { world.spawn_x, world.spawn_z }, (UIntPtr)1, out request));
                    break;
                case Talus.TALUS_EVENT_CHUNK:
                    ++chunks;
                    if (talusEvent.uniform_material >= 0)
                    {
                        ++uniform; // nothing to mesh inside
                        break;
                    }
                    Check(Talus.talus_decode(talusEvent.chunk, voxels, (UIntPtr)voxels.Length));
                    foreach (ushort voxel in voxels) if (voxel > 1) ++solid; // 0 is air, 1 water
                    break;
                case Talus.TALUS_EVENT_HEIGHTS:
                    if (talusEvent.status == Talus.TALUS_OK)
                    {
                        double ground = Marshal.ReadInt32(talusEvent.heights_fx) / 256.0;
                        Console.WriteLine(string.Format(CultureInfo.InvariantCulture, "ground at spawn: {0:F2} voxels", ground));
                    }
                    heights = true;
                    break;
                case Talus.TALUS_EVENT_VIEW_COMPLETE:
                    complete = true;
                    break;
                case Talus.TALUS_EVENT_CLOSED:
                    throw new Exception(Talus.Text(talusEvent.message));
            }
        }
        Console.WriteLine("{0}: {1} chunks, {2} of one material; in the others {3} solid voxels", Talus.Text(world.server), chunks, uniform, solid);
    }

    public static int Main(string[] arguments)
    {
        try
        {
            Run(arguments.Length > 0 ? arguments[0] : "localhost",
                arguments.Length > 1 ? uint.Parse(arguments[1]) : Talus.TALUS_DEFAULT_PORT,
                arguments.Length > 2 ? arguments[2] : "");
            return 0;
        }
        catch (DllNotFoundException)
        {
            Console.Error.WriteLine("libtalus is not found: copy libtalus.so (Windows: talus.dll) beside this program, or set LD_LIBRARY_PATH");
            return 1;
        }
        catch (Exception error)
        {
            Console.Error.WriteLine(error.Message);
            return 1;
        }
        finally
        {
            if (client != IntPtr.Zero) Talus.talus_destroy(client);
        }
    }
}
