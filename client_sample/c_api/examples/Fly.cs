// fly.c in C#, with ../bindings/Talus*.cs: Fly [HOST [PORT [TOKEN]]]
using System;
using System.Globalization;

public static class Fly
{
    static void Run(TalusClient client, TalusOptions options)
    {
        var view = new TalusView { HorizontalRadius = 8, VerticalRadius = 4 };
        var next = new TalusEvent(); // written by each Poll()
        var voxels = new ushort[Talus.TALUS_CHUNK_VOLUME];
        ulong chunks = 0, uniform = 0, solid = 0;
        bool complete = false, heights = false;
        string server = "";

        client.Connect(options);

        while (client.IsOpen && (!complete || !heights))
        {
            if (!client.Poll(10000, next)) continue;
            switch (next.Type)
            {
                case TalusEventType.Joined:
                    TalusWorld world = client.GetWorld();
                    server = world.Server;
                    view.CentreX = world.SpawnX;
                    view.CentreY = world.SpawnY;
                    view.CentreZ = world.SpawnZ;
                    client.SetView(view);
                    client.GetHeights(new[] { world.SpawnX, world.SpawnZ });
                    break;
                case TalusEventType.Chunk:
                    ++chunks;
                    if (next.UniformMaterial >= 0)
                    {
                        ++uniform; // nothing to mesh inside
                        break;
                    }
                    next.Decode(voxels); // next.Retain() would keep the chunk longer than this event
                    foreach (ushort voxel in voxels) if (voxel > 1) ++solid; // 0 is air, 1 water
                    break;
                case TalusEventType.Heights:
                    next.ThrowIfFailed();
                    double ground = next.HeightsFx[0] / 256.0;
                    Console.WriteLine(string.Format(CultureInfo.InvariantCulture, "ground at spawn: {0:F2} voxels", ground));
                    heights = true;
                    break;
                case TalusEventType.ViewComplete:
                    complete = true;
                    break;
                case TalusEventType.Closed:
                    next.ThrowIfFailed();
                    break;
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
