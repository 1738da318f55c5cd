/// <summary>Running totals since Connect().</summary>
public struct TalusStats
{
    /// <summary>Everything the server sent.</summary>
    public readonly ulong ReceivedBytes;
    public readonly ulong SentBytes;
    public readonly ulong ChunkFrames;
    /// <summary>Of chunk frames.</summary>
    public readonly ulong ChunkBytes;
    /// <summary>Received as whole columns.</summary>
    public readonly ulong UniformChunks;
    /// <summary>Of a View, already held and not sent again.</summary>
    public readonly ulong KeptChunks;
    /// <summary>Failed to decode, or did not match their hash.</summary>
    public readonly ulong BadChunks;
    public readonly ulong Connections;

    internal TalusStats(ref Talus.talus_stats raw)
    {
        ReceivedBytes = raw.received_bytes;
        SentBytes = raw.sent_bytes;
        ChunkFrames = raw.chunk_frames;
        ChunkBytes = raw.chunk_bytes;
        UniformChunks = raw.uniform_chunks;
        KeptChunks = raw.kept_chunks;
        BadChunks = raw.bad_chunks;
        Connections = raw.connections;
    }
}
