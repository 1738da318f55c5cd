using System;

public sealed class TalusMaterial
{
    /// <summary>As in voxels; 0 is air, 1 water.</summary>
    public readonly ushort Id;
    public readonly string Name;
    /// <summary>0xRRGGBB, sRGB.</summary>
    public readonly uint Colour;
    public readonly TalusPhase Phase;

    internal TalusMaterial(ref Talus.talus_material raw)
    {
        Id = (ushort)raw.id;
        Name = Talus.Text(raw.name);
        Colour = raw.colour;
        Phase = (TalusPhase)raw.phase;
    }
}

/// <summary>The server's description of its world: a copy. After a Reconnected event there may be a newer one.</summary>
public sealed class TalusWorld
{
    /// <summary>Equal fingerprints: equal voxels everywhere.</summary>
    public readonly TalusHash Fingerprint;
    /// <summary>Revisions of one store are comparable.</summary>
    public readonly TalusHash Store;
    /// <summary>As generated: one rock below MinY, air from MaxY up.</summary>
    public readonly long MinY, MaxY;
    /// <summary>Base voxel of the feet: the first free one above dry ground.</summary>
    public readonly long SpawnX, SpawnY, SpawnZ;
    /// <summary>The server's name and version.</summary>
    public readonly string Server;
    /// <summary>Of a View, in base chunks; 2^l times as many horizontally for a ring of level l.</summary>
    public readonly uint MaxHorizontalRadius, MaxVerticalRadius;
    /// <summary>Of all levels in one View.</summary>
    public readonly uint MaxViewChunks;
    /// <summary>In one GetHeights() or GetPlaces().</summary>
    public readonly uint MaxColumns;
    /// <summary>Views may have TalusView.Horizon.</summary>
    public readonly bool HasHorizon;
    public readonly TalusMaterial[] Materials;
    /// <summary>Biomes, by TalusEvent.Looks; the first, "", is no biome.</summary>
    public readonly string[] Looks;
    /// <summary>Quantities that GetPlaces() takes.</summary>
    public readonly string[] Fields;

    internal TalusWorld(ref Talus.talus_world raw, TalusMaterial[] materials, string[] looks, string[] fields)
    {
        Fingerprint = new TalusHash(raw.fingerprint_low, raw.fingerprint_high);
        Store = new TalusHash(raw.store_low, raw.store_high);
        MinY = raw.min_y;
        MaxY = raw.max_y;
        SpawnX = raw.spawn_x;
        SpawnY = raw.spawn_y;
        SpawnZ = raw.spawn_z;
        Server = Talus.Text(raw.server);
        MaxHorizontalRadius = raw.max_horizontal_radius;
        MaxVerticalRadius = raw.max_vertical_radius;
        MaxViewChunks = raw.max_view_chunks;
        MaxColumns = raw.max_columns;
        HasHorizon = raw.has_horizon != 0;
        Materials = materials;
        Looks = looks;
        Fields = fields;
    }

    internal static TalusWorld Of(IntPtr client)
    {
        var raw = Talus.talus_world.Create();
        TalusException.Check(Talus.talus_get_world(client, ref raw), client);
        var materials = new TalusMaterial[raw.material_count];
        var material = Talus.talus_material.Create();
        for (uint i = 0; i < raw.material_count; ++i)
        {
            TalusException.Check(Talus.talus_get_material(client, i, ref material), client);
            materials[i] = new TalusMaterial(ref material);
        }
        var looks = new string[raw.look_count];
        for (uint i = 0; i < raw.look_count; ++i) looks[i] = Talus.Text(Talus.talus_look_name(client, i));
        var fields = new string[raw.field_count];
        for (uint i = 0; i < raw.field_count; ++i) fields[i] = Talus.Text(Talus.talus_field_name(client, i));
        return new TalusWorld(ref raw, materials, looks, fields);
    }
}
