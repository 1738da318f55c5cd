// Dig PORT: as dig.py.
using System;
using System.Runtime.InteropServices;

static class Dig
{
    static IntPtr client;
    static uint request;
    static Talus.talus_event answer = Talus.talus_event.Create();

    static void Check(int status)
    {
        if (status < 0) throw new Exception(Talus.Text(Talus.talus_last_error(client)));
    }

    static void Wait(uint type, uint asked)
    {
        while (answer.type != type || answer.request != asked)
        {
            Check(Talus.talus_poll(client, ref answer, 60000));
            if (answer.type == Talus.TALUS_EVENT_CLOSED) throw new Exception(Talus.Text(answer.message));
        }
    }

    static void Edit(Talus.talus_edit edit)
    {
        Check(Talus.talus_send_edit(client, ref edit, out request));
        Wait(Talus.TALUS_EVENT_EDITED, request);
        Console.WriteLine("edited: {0} {1}", answer.status, answer.changed_voxels);
    }

    static IntPtr Pin(Array array) { return GCHandle.Alloc(array, GCHandleType.Pinned).AddrOfPinnedObject(); }

    static void Main(string[] arguments)
    {
        var options = Talus.talus_connect_options.Create();
        var world = Talus.talus_world.Create();
        var material = Talus.talus_material.Create();
        Check(Talus.talus_create(out client));
        options.host = Talus.Allocate("127.0.0.1");
        options.port = uint.Parse(arguments[0]);
        Check(Talus.talus_connect(client, ref options));
        Wait(Talus.TALUS_EVENT_JOINED, 0);
        Check(Talus.talus_get_world(client, ref world));
        while (material.phase != Talus.TALUS_SOLID) Check(Talus.talus_get_material(client, material.id + 1, ref material));
        long x = world.spawn_x, y = world.spawn_y, z = world.spawn_z;

        var build = Talus.talus_edit.Create();
        build.guard_voxels = build.write_voxels = Pin(new[] { x, y, z });
        build.guard_materials = Pin(new ushort[] { 0 });
        build.write_materials = Pin(new[] { (ushort)material.id });
        build.guard_count = build.write_count = 1;
        Edit(build);
        Edit(build);

        Action<ulong[]> getChunk = known =>
            Check(Talus.talus_get_chunk(client, (int)(x >> 5), (int)(y >> 5), (int)(z >> 5), 0, known, out request));
        getChunk(null);
        Wait(Talus.TALUS_EVENT_CHUNK_ANSWER, request);
        int index = Talus.TALUS_VOXEL_INDEX((int)(x & 31), (int)(y & 31), (int)(z & 31));
        var voxels = new ushort[Talus.TALUS_CHUNK_VOLUME];
        Check(Talus.talus_decode(answer.chunk, voxels, (UIntPtr)voxels.Length));
        Console.WriteLine("built: {0} of {1} {2}", voxels[index], Talus.Text(material.name), material.id);
        IntPtr memory = Marshal.AllocHGlobal(voxels.Length * sizeof(ushort));
        Check(Talus.talus_decode(answer.chunk, memory, (UIntPtr)voxels.Length));
        for (int i = 0; i < voxels.Length; ++i)
            if ((ushort)Marshal.ReadInt16(memory, i * sizeof(ushort)) != voxels[i]) throw new Exception("native memory has other voxels");
        getChunk(new[] { answer.hash_low, answer.hash_high });
        Wait(Talus.TALUS_EVENT_CHUNK_ANSWER, request);
        Console.WriteLine("known: {0} {1}", answer.status, answer.chunk == IntPtr.Zero);
        getChunk(null);
        Check(Talus.talus_cancel(client, request));
        Wait(Talus.TALUS_EVENT_CHUNK_ANSWER, request);
        Console.WriteLine("cancelled: {0}", answer.status == Talus.TALUS_OK || answer.status == Talus.TALUS_CANCELLED);

        IntPtr field = Talus.talus_field_name(client, 0);
        Check(Talus.talus_get_places(client, new[] { x, z }, (UIntPtr)1, new[] { field }, (UIntPtr)1, out request));
        Wait(Talus.TALUS_EVENT_HEIGHTS, request);
        var values = new float[1];
        Marshal.Copy(answer.values, values, 0, 1);
        Console.WriteLine("place: {0} {1} {2} {3}", Marshal.ReadInt32(answer.heights_fx),
            Talus.Text(Talus.talus_look_name(client, Marshal.ReadByte(answer.looks))), Talus.Text(field), (int)((double)values[0] * 100));

        var undo = Talus.talus_edit.Create();
        undo.fill_corners = Pin(new[] { x, y, z, x, y, z });
        undo.fill_materials = Pin(new[] { Talus.TALUS_AS_GENERATED });
        undo.fill_count = 1;
        Edit(undo);

        var view = Talus.talus_view.Create();
        view.horizontal_radius = 8;
        view.vertical_radius = 4;
        ulong chunks;
        Check(Talus.talus_fill_rings(ref view, 256));
        Check(Talus.talus_count_view(client, ref view, out chunks));
        Console.WriteLine("rings: {0} {1} {2} {3} {4} {5} {6}", view.ring_radius_1, view.ring_radius_2, view.ring_radius_3, view.ring_radius_4,
            view.ring_radius_5, view.ring_radius_6, chunks);
        Talus.talus_destroy(client);
    }
}
