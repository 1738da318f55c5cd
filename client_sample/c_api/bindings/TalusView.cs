using System;

/// <summary>The chunks that a player wants around it: level 0 within the radii, coarser levels farther out. Change one and pass it to
/// SetView() every frame: that allocates nothing.</summary>
public sealed class TalusView
{
    /// <summary>Rings include every row in which ground can lie. Requires TalusWorld.HasHorizon.</summary>
    public bool Horizon;
    /// <summary>Base voxels.</summary>
    public long CentreX, CentreY, CentreZ;
    /// <summary>Of sight, any length; 0: no preference.</summary>
    public float DirectionX, DirectionY, DirectionZ;
    /// <summary>Base chunks; a HorizontalRadius of 0: the centre's column alone.</summary>
    public ushort HorizontalRadius, VerticalRadius;
    /// <summary>Levels 1 to 6, in base chunks, each wider than the finer ones; 0: no ring of this level.</summary>
    public readonly ushort[] RingRadius = new ushort[6];

    /// <summary>Sets RingRadius: levels 1 to 6 from HorizontalRadius out to `farthest` base chunks.</summary>
    public void FillRings(ushort farthest)
    {
        Talus.talus_view raw = Raw();
        TalusException.Check(Talus.talus_fill_rings(ref raw, farthest), IntPtr.Zero);
        RingRadius[0] = raw.ring_radius_1;
        RingRadius[1] = raw.ring_radius_2;
        RingRadius[2] = raw.ring_radius_3;
        RingRadius[3] = raw.ring_radius_4;
        RingRadius[4] = raw.ring_radius_5;
        RingRadius[5] = raw.ring_radius_6;
    }

    internal Talus.talus_view Raw()
    {
        var raw = Talus.talus_view.Create();
        raw.flags = Horizon ? Talus.TALUS_VIEW_HORIZON : 0;
        raw.centre_x = CentreX;
        raw.centre_y = CentreY;
        raw.centre_z = CentreZ;
        raw.direction_x = DirectionX;
        raw.direction_y = DirectionY;
        raw.direction_z = DirectionZ;
        raw.horizontal_radius = HorizontalRadius;
        raw.vertical_radius = VerticalRadius;
        raw.ring_radius_1 = RingRadius[0];
        raw.ring_radius_2 = RingRadius[1];
        raw.ring_radius_3 = RingRadius[2];
        raw.ring_radius_4 = RingRadius[3];
        raw.ring_radius_5 = RingRadius[4];
        raw.ring_radius_6 = RingRadius[5];
        return raw;
    }
}
