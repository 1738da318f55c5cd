using System;
using System.Runtime.InteropServices;

/// <summary>One event, into which Poll() writes: make one and poll into it again and again. It is a copy, and stays as it is, but its
/// chunk's voxels belong to the client until its next Poll(), Connect() or Dispose(). Talus.cs says which fields a type has; the others
/// are 0, null, or "" for strings.</summary>
public sealed class TalusEvent
{
    TalusClient client;

    /// <summary>Ignore types that are unknown. 0: no event.</summary>
    public TalusEventType Type { get; private set; }
    /// <summary>Ok or an error, which is below 0.</summary>
    public TalusStatus Status { get; private set; }
    /// <summary>One line for humans, if the status is an error.</summary>
    public string Message { get; private set; } = "";
    /// <summary>Delay that the server asks for; 0: no delay.</summary>
    public uint RetryAfterMs { get; private set; }
    /// <summary>The request that this answers, as its call returned it.</summary>
    public uint Request { get; private set; }
    /// <summary>The chunk's coordinates, in chunks of Level.</summary>
    public int X { get; private set; }
    public int Y { get; private set; }
    public int Z { get; private set; }
    public uint Level { get; private set; }
    public ulong Revision { get; private set; }
    public TalusHash Hash { get; private set; }
    /// <summary>There are voxels to Decode() or Retain(). False in an answer: unchanged since the hash that the caller knew, or an
    /// error.</summary>
    public bool HasChunk { get; private set; }
    /// <summary>The material of all voxels; -1: they differ, or there is no chunk.</summary>
    public int UniformMaterial { get; private set; } = -1;
    /// <summary>Ground of each column, in 1/256 voxel above y = 0. A new array for each answer.</summary>
    public int[] HeightsFx { get; private set; }
    /// <summary>Of each column, an index of TalusWorld.Looks.</summary>
    public byte[] Looks { get; private set; }
    /// <summary>FieldCount values of each column, in the order of the request.</summary>
    public float[] Values { get; private set; }
    public uint ColumnCount { get; private set; }
    public uint FieldCount { get; private set; }
    public ulong RoundTripNs { get; private set; }
    public uint ChangedVoxels { get; private set; }

    /// <summary>All voxels, index Talus.TALUS_VOXEL_INDEX(x, y, z); room for Talus.TALUS_CHUNK_VOLUME of them. Allocates nothing. It is a
    /// call of the client: another thread Retain()s the chunk instead.</summary>
    public void Decode(ushort[] voxels)
    {
        if (voxels == null) throw new ArgumentNullException("voxels");
        IntPtr chunk;
        using (Hold(out chunk)) TalusException.Check(Talus.talus_decode(chunk, voxels, (UIntPtr)(uint)voxels.Length), IntPtr.Zero);
    }

    /// <summary>The same into native memory, such as a NativeArray's. It must have room for `count` voxels: nothing checks that.</summary>
    public void Decode(IntPtr voxels, int count)
    {
        IntPtr chunk;
        using (Hold(out chunk))
            TalusException.Check(Talus.talus_decode(chunk, voxels, (UIntPtr)(uint)Math.Max(count, 0)), IntPtr.Zero);
    }

    /// <summary>An owner that keeps the voxels beyond this event and its client, for any thread; Dispose() of it.</summary>
    public TalusChunk Retain()
    {
        IntPtr chunk;
        using (Hold(out chunk)) return new TalusChunk(chunk);
    }

    /// <summary>Throws what the status says, if it is an error.</summary>
    public void ThrowIfFailed()
    {
        if (Status < 0) throw new TalusException(Status, Message, RetryAfterMs);
    }

    TalusClient.Call Hold(out IntPtr chunk)
    {
        if (!HasChunk) throw new InvalidOperationException("TalusEvent: it has no chunk; HasChunk says so");
        return client.HoldChunk(this, out chunk);
    }

    /// <summary>Takes what libtalus wrote. Allocates for errors (their text) and Heights (arrays) only.</summary>
    internal void Set(TalusClient from, ref Talus.talus_event raw)
    {
        client = from;
        Type = (TalusEventType)raw.type;
        Status = (TalusStatus)raw.status;
        Message = Status < 0 ? Talus.Text(raw.message) : "";
        RetryAfterMs = raw.retry_after_ms;
        Request = raw.request;
        X = raw.x;
        Y = raw.y;
        Z = raw.z;
        Level = raw.level;
        Revision = raw.revision;
        Hash = new TalusHash(raw.hash_low, raw.hash_high);
        HasChunk = raw.chunk != IntPtr.Zero;
        UniformMaterial = raw.uniform_material;
        ColumnCount = raw.column_count;
        FieldCount = raw.field_count;
        int columns = (int)ColumnCount, values = columns * (int)FieldCount;
        HeightsFx = raw.heights_fx == IntPtr.Zero ? null : new int[columns];
        if (HeightsFx != null) Marshal.Copy(raw.heights_fx, HeightsFx, 0, columns);
        Looks = raw.looks == IntPtr.Zero ? null : new byte[columns];
        if (Looks != null) Marshal.Copy(raw.looks, Looks, 0, columns);
        Values = raw.values == IntPtr.Zero ? null : new float[values];
        if (Values != null) Marshal.Copy(raw.values, Values, 0, values);
        RoundTripNs = raw.round_trip_ns;
        ChangedVoxels = raw.changed_voxels;
    }
}
