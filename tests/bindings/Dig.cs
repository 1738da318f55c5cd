// Dig PORT: as dig.py, by Talus*.cs.
using System;
using System.Linq;
using System.Runtime.InteropServices;

static class Dig
{
    static TalusEvent Wait(TalusClient client, uint type, uint asked)
    {
        TalusEvent next;
        while (client.Poll(60000, out next))
        {
            if (next.Type == type && next.Request == asked) return next;
            if (next.Type == Talus.TALUS_EVENT_CLOSED) next.ThrowIfFailed();
        }
        throw new Exception("no event within a minute");
    }

    static void Edit(TalusClient client, TalusEdit edit)
    {
        TalusEvent edited = Wait(client, Talus.TALUS_EVENT_EDITED, client.SendEdit(edit));
        Console.WriteLine("edited: {0} {1}", edited.Status, edited.ChangedVoxels);
    }

    static void Main(string[] arguments)
    {
        using (var client = new TalusClient())
        {
            client.Connect(new TalusOptions { Host = "127.0.0.1", Port = uint.Parse(arguments[0]) });
            Wait(client, Talus.TALUS_EVENT_JOINED, 0);
            TalusWorld world = client.GetWorld();
            TalusMaterial material = world.Materials.First(each => each.Phase == Talus.TALUS_SOLID);
            long x = world.SpawnX, y = world.SpawnY, z = world.SpawnZ;

            TalusEdit build = new TalusEdit().Guard(x, y, z, 0).Write(x, y, z, material.Id);
            Edit(client, build);
            Edit(client, build);

            Func<TalusHash?, uint> getChunk = known => client.GetChunk((int)(x >> 5), (int)(y >> 5), (int)(z >> 5), 0, known);
            TalusEvent answer = Wait(client, Talus.TALUS_EVENT_CHUNK_ANSWER, getChunk(null));
            int index = Talus.TALUS_VOXEL_INDEX((int)(x & 31), (int)(y & 31), (int)(z & 31));
            var voxels = new ushort[Talus.TALUS_CHUNK_VOLUME];
            answer.Chunk.Decode(voxels);
            Console.WriteLine("built: {0} of {1} {2}", voxels[index], material.Name, material.Id);
            IntPtr memory = Marshal.AllocHGlobal(voxels.Length * sizeof(ushort));
            answer.Chunk.Decode(memory, voxels.Length);
            for (int i = 0; i < voxels.Length; ++i)
                if ((ushort)Marshal.ReadInt16(memory, i * sizeof(ushort)) != voxels[i])
                    throw new Exception("native memory has other voxels");
            Marshal.FreeHGlobal(memory);
            answer = Wait(client, Talus.TALUS_EVENT_CHUNK_ANSWER, getChunk(answer.Hash));
            Console.WriteLine("known: {0} {1}", answer.Status, answer.Chunk == null);
            uint unwanted = getChunk(null);
            client.Cancel(unwanted);
            answer = Wait(client, Talus.TALUS_EVENT_CHUNK_ANSWER, unwanted);
            Console.WriteLine("cancelled: {0}", answer.Status == Talus.TALUS_OK || answer.Status == Talus.TALUS_CANCELLED);

            answer = Wait(client, Talus.TALUS_EVENT_HEIGHTS, client.GetPlaces(new[] { x, z }, world.Fields[0]));
            Console.WriteLine("place: {0} {1} {2} {3}", answer.HeightsFx[0], world.Looks[answer.Looks[0]], world.Fields[0],
                (int)((double)answer.Values[0] * 100));

            Edit(client, new TalusEdit().Fill(x, y, z, x, y, z, Talus.TALUS_AS_GENERATED));

            var view = Talus.talus_view.Create();
            view.horizontal_radius = 8;
            view.vertical_radius = 4;
            TalusClient.FillRings(ref view, 256);
            Console.WriteLine("rings: {0} {1} {2} {3} {4} {5} {6}", view.ring_radius_1, view.ring_radius_2, view.ring_radius_3,
                view.ring_radius_4, view.ring_radius_5, view.ring_radius_6, client.CountView(view));
        }
    }
}
