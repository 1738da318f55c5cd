// fly.c in C#, with ../bindings/Talus*.cs: Fly [HOST [PORT [TOKEN]]]
using System;
using System.Globalization;

public static class Fly
{
    static void Run(TalusClient client, TalusOptions options)
    {
        var view = Talus.talus_view.Create();
        var voxels = new ushort[Talus.TALUS_CHUNK_VOLUME];
        ulong chunks = 0, uniform = 0, solid = 0;
        bool complete = false, heights = false;
        string server = "";
        TalusEvent next;

        client.Connect(options);
        view.horizontal_radius = 8;
        view.vertical_radius = 4;

        while (!complete || !heights)
        {
            if (!client.Poll(10000, out next)) continue;
            switch (next.Type)
            {
                case Talus.TALUS_EVENT_JOINED:
                    TalusWorld world = client.GetWorld();
                    server = world.Server;
                    view.centre_x = world.SpawnX;
                    view.centre_y = world.SpawnY;
                    view.centre_z = world.SpawnZ;
                    client.SetView(view);
                    client.GetHeights(new[] { world.SpawnX, world.SpawnZ });
                    break;
                case Talus.TALUS_EVENT_CHUNK:
                    ++chunks;
                    if (next.UniformMaterial >= 0)
                    {
                        ++uniform; // nothing to mesh inside
                        break;
                    }
                    next.Chunk.Decode(voxels); // next.Chunk.Retain() would keep it longer than this event
                    foreach (ushort voxel in voxels) if (voxel > 1) ++solid; // 0 is air, 1 water
                    break;
                case Talus.TALUS_EVENT_HEIGHTS:
                    next.ThrowIfFailed();
                    double ground = next.HeightsFx[0] / 256.0;
                    Console.WriteLine(string.Format(CultureInfo.InvariantCulture, "ground at spawn: {0:F2} voxels", ground));
                    heights = true;
                    break;
                case Talus.TALUS_EVENT_VIEW_COMPLETE:
                    complete = true;
                    break;
                case Talus.TALUS_EVENT_CLOSED:
                    throw new TalusException(next.Status, next.Message);
            }
        }
        Console.WriteLine("{0}: {1} chunks, {2} of one material; in the others {3} solid voxels", server, chunks, uniform, solid);
    }

    public static int Main(string[] arguments)
    {
        try
        {
            var options = new TalusOptions();
            if (arguments.Length > 0) options.Host = arguments[0];
            if (arguments.Length > 1) options.Port = uint.Parse(arguments[1]);
            if (arguments.Length > 2) options.Token = arguments[2];
            using (var client = new TalusClient()) Run(client, options);
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
    }
}
