// Dig PORT: as dig.py, by Talus*.cs.
using System;
using System.Linq;
using System.Runtime.InteropServices;

static class Dig
{
    static readonly TalusEvent next = new TalusEvent();

    static TalusEvent Wait(TalusClient client, TalusEventType type, uint asked)
    {
        while (client.Poll(60000, next))
        {
            if (next.Type == type && next.Request == asked) return next;
            if (next.Type == TalusEventType.Closed) next.ThrowIfFailed();
        }
        throw new Exception("no event within a minute");
    }

    static void Edit(TalusClient client, TalusEdit edit)
    {
        TalusEvent edited = Wait(client, TalusEventType.Edited, client.SendEdit(edit));
        Console.WriteLine("edited: {0} {1}", (int)edited.Status, edited.ChangedVoxels);
    }

    static void Main(string[] arguments)
    {
        using (var client = new TalusClient())
        {
            client.Connect(new TalusOptions { Host = "127.0.0.1", Port = uint.Parse(arguments[0]) });
            Wait(client, TalusEventType.Joined, 0);
            TalusWorld world = client.GetWorld();
            TalusMaterial material = world.Materials.First(each => each.Phase == TalusPhase.Solid);
            long x = world.SpawnX, y = world.SpawnY, z = world.SpawnZ;

            TalusEdit build = new TalusEdit().Guard(x, y, z, 0).Write(x, y, z, material.Id);
            Edit(client, build);
            Edit(client, build);

            Func<TalusHash?, uint> getChunk = known => client.GetChunk((int)(x >> 5), (int)(y >> 5), (int)(z >> 5), 0, known);
            TalusEvent answer = Wait(client, TalusEventType.ChunkAnswer, getChunk(null));
            int index = Talus.TALUS_VOXEL_INDEX((int)(x & 31), (int)(y & 31), (int)(z & 31));
            var voxels = new ushort[Talus.TALUS_CHUNK_VOLUME];
            answer.Decode(voxels);
            Console.WriteLine("built: {0} of {1} {2}", voxels[index], material.Name, material.Id);
            IntPtr memory = Marshal.AllocHGlobal(voxels.Length * sizeof(ushort));
            answer.Decode(memory, voxels.Length);
            for (int i = 0; i < voxels.Length; ++i)
                if ((ushort)Marshal.ReadInt16(memory, i * sizeof(ushort)) != voxels[i])
                    throw new Exception("native memory has other voxels");
            Marshal.FreeHGlobal(memory);
            answer = Wait(client, TalusEventType.ChunkAnswer, getChunk(answer.Hash));
            Console.WriteLine("known: {0} {1}", (int)answer.Status, !answer.HasChunk);
            uint unwanted = getChunk(null);
            client.Cancel(unwanted);
            answer = Wait(client, TalusEventType.ChunkAnswer, unwanted);
            Console.WriteLine("cancelled: {0}", answer.Status == TalusStatus.Ok || answer.Status == TalusStatus.Cancelled);

            answer = Wait(client, TalusEventType.Heights, client.GetPlaces(new[] { x, z }, world.Fields[0]));
            Console.WriteLine("place: {0} {1} {2} {3}", answer.HeightsFx[0], world.Looks[answer.Looks[0]], world.Fields[0],
                (int)((double)answer.Values[0] * 100));

            Edit(client, new TalusEdit().Fill(x, y, z, x, y, z, Talus.TALUS_AS_GENERATED));

            var view = new TalusView { HorizontalRadius = 8, VerticalRadius = 4 };
            view.FillRings(256);
            Console.WriteLine("rings: {0} {1}", string.Join(" ", view.RingRadius), client.CountView(view));
        }
    }
}
