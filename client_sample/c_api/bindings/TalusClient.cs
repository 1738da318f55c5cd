// A client for C# and Unity (C# 7, .NET Standard 2.0) over the calls of Talus.cs. An object that is not disposed of is freed by its
// finalizer, none is freed twice, and its use afterwards throws an ObjectDisposedException. A call that fails throws a TalusException.
using System;
using System.Runtime.InteropServices;
using System.Threading;

/// <summary>Options of a connection; null, empty or 0 selects libtalus's default. talus_connect_options in Talus.cs says more.</summary>
public sealed class TalusOptions
{
    /// <summary>Talus.TALUS_TLS, TALUS_TLS_NO_VERIFY, TALUS_WEBSOCKET.</summary>
    public uint Flags;
    public string Host = "localhost", Token, ClientName, TlsCaFile, TlsServerName, MoreServers;
    public uint Port = Talus.TALUS_DEFAULT_PORT;
    public ulong WindowBytes, KeepBytes;
    public uint ConnectTimeoutMs, HandshakeTimeoutMs, PingIntervalMs, SilenceTimeoutMs;
    public uint ReconnectAttempts, ReconnectFirstDelayMs, ReconnectMaxDelayMs;

    internal Talus.talus_connect_options Raw(TalusArguments arguments)
    {
        var raw = Talus.talus_connect_options.Create();
        raw.flags = Flags;
        raw.host = arguments.Text(Host);
        raw.token = arguments.Text(Token);
        raw.client_name = arguments.Text(ClientName);
        raw.tls_ca_file = arguments.Text(TlsCaFile);
        raw.tls_server_name = arguments.Text(TlsServerName);
        raw.more_servers = arguments.Text(MoreServers);
        raw.port = Port;
        raw.window_bytes = WindowBytes;
        raw.keep_bytes = KeepBytes;
        raw.connect_timeout_ms = ConnectTimeoutMs;
        raw.handshake_timeout_ms = HandshakeTimeoutMs;
        raw.ping_interval_ms = PingIntervalMs;
        raw.silence_timeout_ms = SilenceTimeoutMs;
        raw.reconnect_attempts = ReconnectAttempts;
        raw.reconnect_first_delay_ms = ReconnectFirstDelayMs;
        raw.reconnect_max_delay_ms = ReconnectMaxDelayMs;
        return raw;
    }
}

/// <summary>A client, unconnected at first. One thread at a time may use it, not always the same.</summary>
public sealed class TalusClient : IDisposable
{
    static readonly uint ViewSize = (uint)Marshal.SizeOf(typeof(Talus.talus_view));

    readonly Handle handle;
    Talus.talus_event raw = Talus.talus_event.Create();
    TalusChunk delivered;

    public TalusClient()
    {
        uint major = Talus.talus_api_version() >> 16;
        if (major != Talus.TALUS_API_MAJOR)
            throw new TalusException(Talus.TALUS_UNSUPPORTED, "libtalus has interface " + major + ", not " + Talus.TALUS_API_MAJOR);
        handle = new Handle();
    }

    /// <summary>Closes the connection, once a call in another thread has ended, and disposes of the last event's chunk. Retained chunks
    /// stay.</summary>
    public void Dispose()
    {
        handle.Dispose();
        TalusChunk last = Interlocked.Exchange(ref delivered, null);
        if (last != null) last.Dispose();
    }

    /// <summary>Begins to connect and returns at once. JOINED or CLOSED reports the result.</summary>
    public void Connect(TalusOptions options)
    {
        using (Call call = handle.Enter())
        using (var arguments = new TalusArguments())
        {
            Talus.talus_connect_options connect = options.Raw(arguments);
            call.Check(Talus.talus_connect(call.Client, ref connect));
        }
    }

    /// <summary>Closes the connection, without CLOSED. No effect without a connection.</summary>
    public void Disconnect()
    {
        using (Call call = handle.Enter()) call.Check(Talus.talus_disconnect(call.Client));
    }

    /// <summary>The next event; false: none in time, or no connection. Waits at most timeoutMs; 0: not at all, negative: without limit.
    /// All work is done in here: call it at least every few seconds, each time until it returns false.</summary>
    public bool Poll(int timeoutMs, out TalusEvent next)
    {
        next = null;
        using (Call call = handle.Enter())
        {
            TalusChunk last = Interlocked.Exchange(ref delivered, null);
            if (last != null) last.Dispose();
            int status = Talus.talus_poll(call.Client, ref raw, timeoutMs);
            if (status == Talus.TALUS_NO_EVENT || status == Talus.TALUS_NOT_CONNECTED) return false;
            call.Check(status);
            next = new TalusEvent(ref raw);
            delivered = next.Chunk;
            return true;
        }
    }

    /// <summary>After JOINED.</summary>
    public TalusWorld GetWorld()
    {
        using (Call call = handle.Enter()) return new TalusWorld(call.Client);
    }

    /// <summary>Replaces the View. Cheap: every frame is fine.</summary>
    public void SetView(Talus.talus_view view)
    {
        view.size = ViewSize;
        using (Call call = handle.Enter()) call.Check(Talus.talus_set_view(call.Client, ref view));
    }

    /// <summary>Number of chunks of the View, for a progress bar.</summary>
    public ulong CountView(Talus.talus_view view)
    {
        ulong chunks;
        view.size = ViewSize;
        using (Call call = handle.Enter()) call.Check(Talus.talus_count_view(call.Client, ref view, out chunks));
        return chunks;
    }

    /// <summary>Sets rings of levels 1 to 6 from horizontal_radius out to `farthest` base chunks.</summary>
    public static void FillRings(ref Talus.talus_view view, ushort farthest)
    {
        view.size = ViewSize;
        TalusException.Check(Talus.talus_fill_rings(ref view, farthest), IntPtr.Zero);
    }

    // ---- Requests: each returns the number that its answer has as TalusEvent.Request ----

    /// <summary>Answered by CHUNK_ANSWER. `known`: the hash of the caller's copy.</summary>
    public uint GetChunk(int x, int y, int z, uint level, TalusHash? known = null)
    {
        uint request;
        ulong[] halves = known.HasValue ? new[] { known.Value.Low, known.Value.High } : null;
        using (Call call = handle.Enter()) call.Check(Talus.talus_get_chunk(call.Client, x, y, z, level, halves, out request));
        return request;
    }

    /// <summary>Answered by HEIGHTS. x and z of each base column.</summary>
    public uint GetHeights(long[] columns)
    {
        uint request;
        UIntPtr count = CountColumns(columns);
        using (Call call = handle.Enter()) call.Check(Talus.talus_get_heights(call.Client, columns, count, out request));
        return request;
    }

    /// <summary>Answered by HEIGHTS with Looks, and Values of these of TalusWorld.Fields, at most 16.</summary>
    public uint GetPlaces(long[] columns, params string[] fields)
    {
        uint request;
        UIntPtr count = CountColumns(columns);
        using (Call call = handle.Enter())
        using (var arguments = new TalusArguments())
        {
            IntPtr[] names = Array.ConvertAll(fields, arguments.Text);
            call.Check(Talus.talus_get_places(call.Client, columns, count, names, (UIntPtr)(uint)names.Length, out request));
        }
        return request;
    }

    /// <summary>Answered by EDITED, once the edit is stored or rejected.</summary>
    public uint SendEdit(TalusEdit edit)
    {
        uint request;
        using (Call call = handle.Enter())
        using (var arguments = new TalusArguments())
        {
            Talus.talus_edit sent = edit.Raw(arguments);
            call.Check(Talus.talus_send_edit(call.Client, ref sent, out request));
        }
        return request;
    }

    /// <summary>Answered by PONG.</summary>
    public uint Ping()
    {
        uint request;
        using (Call call = handle.Enter()) call.Check(Talus.talus_ping(call.Client, out request));
        return request;
    }

    /// <summary>Cancels a GetChunk(). It is still answered: with TALUS_CANCELLED, or with the chunk if it was in flight.</summary>
    public void Cancel(uint request)
    {
        using (Call call = handle.Enter()) call.Check(Talus.talus_cancel(call.Client, request));
    }

    /// <summary>Running totals since Connect().</summary>
    public Talus.talus_stats GetStats()
    {
        var stats = Talus.talus_stats.Create();
        using (Call call = handle.Enter()) call.Check(Talus.talus_get_stats(call.Client, ref stats));
        return stats;
    }

    static UIntPtr CountColumns(long[] columns)
    {
        if (columns == null || columns.Length % 2 != 0)
            throw new ArgumentException((columns == null ? 0 : columns.Length) + " numbers; a column has two, x and z", "columns");
        return (UIntPtr)(uint)(columns.Length / 2);
    }

    sealed class Handle : SafeHandle
    {
        int calls;

        internal Handle() : base(IntPtr.Zero, true) { TalusException.Check(Talus.talus_create(out handle), IntPtr.Zero); }

        public override bool IsInvalid { get { return handle == IntPtr.Zero; } }

        protected override bool ReleaseHandle()
        {
            Talus.talus_destroy(handle);
            return true;
        }

        internal Call Enter()
        {
            if (IsClosed) throw new ObjectDisposedException("TalusClient");
            if (Interlocked.CompareExchange(ref calls, 1, 0) != 0)
                throw new InvalidOperationException("TalusClient: another thread is in a call of this client; one at a time may use it");
            bool held = false;
            try
            {
                DangerousAddRef(ref held);
            }
            finally
            {
                if (!held) Leave(false);
            }
            return new Call(this, handle);
        }

        internal void Leave(bool held)
        {
            Volatile.Write(ref calls, 0);
            if (held) DangerousRelease();
        }
    }

    /// <summary>While it lives, the client does, and calls of other threads throw. A struct, so that calls allocate nothing.</summary>
    struct Call : IDisposable
    {
        readonly Handle handle;
        internal readonly IntPtr Client;

        internal Call(Handle handle, IntPtr client)
        {
            this.handle = handle;
            Client = client;
        }

        internal int Check(int status) { return TalusException.Check(status, Client); }
        public void Dispose() { handle.Leave(true); }
    }
}
