using System;
using System.Runtime.InteropServices;

/// <summary>One event. All of it is a copy but its chunk. Talus.cs says which fields a type has; the others are 0, null, or "" for
/// strings.</summary>
public sealed class TalusEvent
{
    /// <summary>Talus.TALUS_EVENT_JOINED and so on. Ignore types that are unknown.</summary>
    public readonly uint Type;
    /// <summary>Talus.TALUS_OK or an error.</summary>
    public readonly int Status;
    /// <summary>One line for humans, if the status is an error.</summary>
    public readonly string Message = "";
    public readonly uint RetryAfterMs;
    /// <summary>The request that this answers, as its call returned it.</summary>
    public readonly uint Request;
    public readonly int X, Y, Z;
    public readonly uint Level;
    public readonly ulong Revision;
    public readonly TalusHash Hash;
    /// <summary>The next Poll() disposes of it: Retain() it to keep it. Null in an answer: unchanged, or an error.</summary>
    public readonly TalusChunk Chunk;
    /// <summary>The material of all voxels; -1: they differ, or there is no chunk.</summary>
    public readonly int UniformMaterial;
    /// <summary>Ground of each column, in 1/256 voxel above y = 0.</summary>
    public readonly int[] HeightsFx;
    /// <summary>Of each column, an index of TalusWorld.Looks.</summary>
    public readonly byte[] Looks;
    /// <summary>FieldCount values of each column, in the order of the request.</summary>
    public readonly float[] Values;
    public readonly uint ColumnCount, FieldCount;
    public readonly ulong RoundTripNs;
    public readonly uint ChangedVoxels;

    internal TalusEvent(ref Talus.talus_event raw)
    {
        Type = raw.type;
        Status = raw.status;
        if (Status < 0) Message = Talus.Text(raw.message);
        RetryAfterMs = raw.retry_after_ms;
        Request = raw.request;
        X = raw.x;
        Y = raw.y;
        Z = raw.z;
        Level = raw.level;
        Revision = raw.revision;
        Hash = new TalusHash(raw.hash_low, raw.hash_high);
        if (raw.chunk != IntPtr.Zero) Chunk = new TalusChunk(raw.chunk);
        UniformMaterial = raw.uniform_material;
        ColumnCount = raw.column_count;
        FieldCount = raw.field_count;
        int columns = (int)ColumnCount;
        if (raw.heights_fx != IntPtr.Zero) Marshal.Copy(raw.heights_fx, HeightsFx = new int[columns], 0, columns);
        if (raw.looks != IntPtr.Zero) Marshal.Copy(raw.looks, Looks = new byte[columns], 0, columns);
        int values = columns * (int)FieldCount;
        if (raw.values != IntPtr.Zero) Marshal.Copy(raw.values, Values = new float[values], 0, values);
        RoundTripNs = raw.round_trip_ns;
        ChangedVoxels = raw.changed_voxels;
    }

    /// <summary>Throws what the status says, if it is an error.</summary>
    public void ThrowIfFailed()
    {
        if (Status < 0) throw new TalusException(Status, Message, RetryAfterMs);
    }
}
