using System;
using System.Runtime.InteropServices;

/// <summary>XXH3-128 of a chunk's voxels, or the number of a world or store.</summary>
public struct TalusHash : IEquatable<TalusHash>
{
    public readonly ulong Low, High;

    public TalusHash(ulong low, ulong high)
    {
        Low = low;
        High = high;
    }

    public bool Equals(TalusHash other) { return Low == other.Low && High == other.High; }
    public override bool Equals(object other) { return other is TalusHash && Equals((TalusHash)other); }
    public override int GetHashCode() { return Low.GetHashCode(); }
}

/// <summary>One owner of a chunk's immutable voxels, from TalusEvent.Retain(); any thread may use it. Dispose() of it; the finalizer is
/// only a net.</summary>
public sealed class TalusChunk : SafeHandle
{
    /// <summary>Adds an owner to those that the chunk has.</summary>
    internal TalusChunk(IntPtr chunk) : base(IntPtr.Zero, true)
    {
        Talus.talus_chunk_retain(chunk);
        SetHandle(chunk);
    }

    public override bool IsInvalid { get { return handle == IntPtr.Zero; } }

    protected override bool ReleaseHandle()
    {
        Talus.talus_chunk_release(handle);
        return true;
    }

    /// <summary>Another owner of the same voxels, to be disposed of by itself.</summary>
    public TalusChunk Retain()
    {
        bool held = false;
        try
        {
            Hold(ref held);
            return new TalusChunk(handle);
        }
        finally
        {
            if (held) DangerousRelease();
        }
    }

    /// <summary>As TalusEvent.Decode().</summary>
    public void Decode(ushort[] voxels)
    {
        if (voxels == null) throw new ArgumentNullException("voxels");
        bool held = false;
        try
        {
            Hold(ref held);
            TalusException.Check(Talus.talus_decode(handle, voxels, (UIntPtr)(uint)voxels.Length), IntPtr.Zero);
        }
        finally
        {
            if (held) DangerousRelease();
        }
    }

    /// <summary>As TalusEvent.Decode(): nothing checks that there is room for `count` voxels.</summary>
    public void Decode(IntPtr voxels, int count)
    {
        bool held = false;
        try
        {
            Hold(ref held);
            TalusException.Check(Talus.talus_decode(handle, voxels, (UIntPtr)(uint)Math.Max(count, 0)), IntPtr.Zero);
        }
        finally
        {
            if (held) DangerousRelease();
        }
    }

    /// <summary>Until DangerousRelease() no Dispose() of another thread frees the voxels.</summary>
    void Hold(ref bool held)
    {
        if (IsClosed) throw new ObjectDisposedException("TalusChunk", "disposed of; Retain() another owner to keep the voxels longer");
        DangerousAddRef(ref held);
    }
}
