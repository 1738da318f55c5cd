using System;

/// <summary>An edit: if all guards hold, its writes, its fills and its paste are applied in this order, completely or not at all.
/// Coordinates are those of base voxels.</summary>
public sealed class TalusEdit
{
    // Arrays that double, and not lists: SendEdit() passes their addresses, and copies nothing.
    long[] guardVoxels = new long[3], writeVoxels = new long[3], fillCorners = new long[6];
    ushort[] guardMaterials = new ushort[1], writeMaterials = new ushort[1];
    int[] fillMaterials = new int[1], fillOnly = new int[1];
    int guards, writes, fills;
    ushort[] paste;
    long pasteX, pasteY, pasteZ;
    bool pasteAir;

    /// <summary>Player for whom a game server with the right "gateway" edits; empty: the token's own subject.</summary>
    public string Subject;

    /// <summary>Nothing is applied unless the voxel has this material.</summary>
    public TalusEdit Guard(long x, long y, long z, ushort material)
    {
        Add(ref guardVoxels, guards, x, y, z);
        Add(ref guardMaterials, guards++, material);
        return this;
    }

    public TalusEdit Write(long x, long y, long z, ushort material)
    {
        Add(ref writeVoxels, writes, x, y, z);
        Add(ref writeMaterials, writes++, material);
        return this;
    }

    /// <summary>A box, both corners included. The material may be Talus.TALUS_AS_GENERATED, which undoes edits; `only` is the one
    /// material that it fills, or Talus.TALUS_ANY.</summary>
    public TalusEdit Fill(long lowX, long lowY, long lowZ, long highX, long highY, long highZ, int material, int only = Talus.TALUS_ANY)
    {
        Add(ref fillCorners, fills * 2, lowX, lowY, lowZ);
        Add(ref fillCorners, fills * 2 + 1, highX, highY, highZ);
        Add(ref fillMaterials, fills, material);
        Add(ref fillOnly, fills++, only);
        return this;
    }

    /// <summary>Talus.TALUS_CHUNK_VOLUME voxels, index Talus.TALUS_VOXEL_INDEX(x, y, z), of which (0, 0, 0) comes to this place;
    /// their air only if asked for. SendEdit() reads them. An edit has one paste: the last.</summary>
    public TalusEdit Paste(long x, long y, long z, ushort[] voxels, bool air = false)
    {
        if (voxels == null) throw new ArgumentNullException("voxels");
        if (voxels.Length != Talus.TALUS_CHUNK_VOLUME)
            throw new ArgumentException(voxels.Length + " voxels; a paste has " + Talus.TALUS_CHUNK_VOLUME, "voxels");
        paste = voxels;
        pasteX = x;
        pasteY = y;
        pasteZ = z;
        pasteAir = air;
        return this;
    }

    internal Talus.talus_edit Raw(TalusArguments arguments)
    {
        var raw = Talus.talus_edit.Create();
        raw.flags = pasteAir ? Talus.TALUS_PASTE_AIR : 0;
        raw.guard_voxels = arguments.Pin(guardVoxels, guards);
        raw.guard_materials = arguments.Pin(guardMaterials, guards);
        raw.guard_count = (uint)guards;
        raw.write_voxels = arguments.Pin(writeVoxels, writes);
        raw.write_materials = arguments.Pin(writeMaterials, writes);
        raw.write_count = (uint)writes;
        raw.fill_corners = arguments.Pin(fillCorners, fills);
        raw.fill_materials = arguments.Pin(fillMaterials, fills);
        raw.fill_only = arguments.Pin(fillOnly, fills);
        raw.fill_count = (uint)fills;
        raw.paste_voxels = arguments.Pin(paste, (int)Talus.TALUS_CHUNK_VOLUME);
        raw.paste_x = pasteX;
        raw.paste_y = pasteY;
        raw.paste_z = pasteZ;
        raw.subject = arguments.Text(Subject, "TalusEdit.Subject");
        return raw;
    }

    static void Add(ref long[] voxels, int index, long x, long y, long z)
    {
        if (voxels.Length < (index + 1) * 3) Array.Resize(ref voxels, voxels.Length * 2);
        voxels[index * 3] = x;
        voxels[index * 3 + 1] = y;
        voxels[index * 3 + 2] = z;
    }

    static void Add<T>(ref T[] materials, int index, T material)
    {
        if (index == materials.Length) Array.Resize(ref materials, index * 2);
        materials[index] = material;
    }
}
