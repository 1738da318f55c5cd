using System;
using System.Collections.Generic;

/// <summary>An edit: if all guards hold, its writes, its fills and its paste are applied in this order, completely or not at all.
/// Coordinates are those of base voxels.</summary>
public sealed class TalusEdit
{
    readonly List<long> guardVoxels = new List<long>(), writeVoxels = new List<long>(), fillCorners = new List<long>();
    readonly List<ushort> guardMaterials = new List<ushort>(), writeMaterials = new List<ushort>();
    readonly List<int> fillMaterials = new List<int>(), fillOnly = new List<int>();
    ushort[] paste;
    long pasteX, pasteY, pasteZ;
    bool pasteAir;

    /// <summary>Player for whom a game server with the right "gateway" edits; empty: the token's own subject.</summary>
    public string Subject;

    /// <summary>Nothing is applied unless the voxel has this material.</summary>
    public TalusEdit Guard(long x, long y, long z, ushort material)
    {
        guardVoxels.AddRange(new[] { x, y, z });
        guardMaterials.Add(material);
        return this;
    }

    public TalusEdit Write(long x, long y, long z, ushort material)
    {
        writeVoxels.AddRange(new[] { x, y, z });
        writeMaterials.Add(material);
        return this;
    }

    /// <summary>A box, both corners included. The material may be Talus.TALUS_AS_GENERATED, which undoes edits; `only` is the one
    /// material that it fills, or Talus.TALUS_ANY.</summary>
    public TalusEdit Fill(long lowX, long lowY, long lowZ, long highX, long highY, long highZ, int material, int only = Talus.TALUS_ANY)
    {
        fillCorners.AddRange(new[] { lowX, lowY, lowZ, highX, highY, highZ });
        fillMaterials.Add(material);
        fillOnly.Add(only);
        return this;
    }

    /// <summary>Talus.TALUS_CHUNK_VOLUME voxels, index Talus.TALUS_VOXEL_INDEX(x, y, z), of which (0, 0, 0) comes to this place;
    /// their air only if asked for. SendEdit() reads them. An edit has one paste: the last.</summary>
    public TalusEdit Paste(long x, long y, long z, ushort[] voxels, bool air = false)
    {
        if (voxels == null || voxels.Length != Talus.TALUS_CHUNK_VOLUME)
            throw new ArgumentException((voxels == null ? 0 : voxels.Length) + " voxels; a paste has " + Talus.TALUS_CHUNK_VOLUME,
                "voxels");
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
        raw.guard_voxels = arguments.Pin(guardVoxels.ToArray());
        raw.guard_materials = arguments.Pin(guardMaterials.ToArray());
        raw.guard_count = (uint)guardMaterials.Count;
        raw.write_voxels = arguments.Pin(writeVoxels.ToArray());
        raw.write_materials = arguments.Pin(writeMaterials.ToArray());
        raw.write_count = (uint)writeMaterials.Count;
        raw.fill_corners = arguments.Pin(fillCorners.ToArray());
        raw.fill_materials = arguments.Pin(fillMaterials.ToArray());
        raw.fill_only = arguments.Pin(fillOnly.ToArray());
        raw.fill_count = (uint)fillMaterials.Count;
        raw.paste_voxels = arguments.Pin(paste);
        raw.paste_x = pasteX;
        raw.paste_y = pasteY;
        raw.paste_z = pasteZ;
        raw.subject = arguments.Text(Subject);
        return raw;
    }
}
