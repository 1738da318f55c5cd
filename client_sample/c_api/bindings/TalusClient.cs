// A client for C# and Unity (C# 7, .NET Standard 2.0) over the calls of Talus.cs. An object that is not disposed of is freed by its
// finalizer, none is freed twice, and its use afterwards throws an ObjectDisposedException. A call that fails throws a TalusException.
using System;
using System.Runtime.InteropServices;
using System.Threading;

/// <summary>A client, unconnected at first. One thread at a time may use it, not always the same. In Unity: make and Connect() one in
/// OnEnable(), while (client.Poll(0, next)) in Update(), Dispose() in OnDisable(); the finalizer is only a net.</summary>
public sealed class TalusClient : IDisposable
{
    static Talus.talus_event none = new Talus.talus_event { uniform_material = -1 };

    readonly Handle handle;
    Talus.talus_event raw = Talus.talus_event.Create();
    TalusEvent current; // has the chunk of `raw`
    volatile bool open, disposed;

    public TalusClient()
    {
        uint major = Talus.talus_api_version() >> 16;
        if (major != Talus.TALUS_API_MAJOR)
            throw new TalusException(TalusStatus.Unsupported, "libtalus has interface " + major + ", not " + Talus.TALUS_API_MAJOR);
        handle = new Handle();
    }

    /// <summary>From Connect() to Closed or Disconnect(), also while it connects and reconnects. Otherwise Poll() returns false at once,
    /// and no event will come.</summary>
    public bool IsOpen { get { return open && !disposed; } }

    /// <summary>Closes the connection and frees the client, once a call in another thread has ended. Retained chunks stay. May wait for
    /// a pending look-up of a host name.</summary>
    public void Dispose()
    {
        disposed = true;
        handle.Dispose();
    }

    /// <summary>Begins to connect and returns at once. Joined or Closed reports the result.</summary>
    public void Connect(TalusOptions options)
    {
        if (options == null) throw new ArgumentNullException("options");
        using (Call call = Enter())
        using (var arguments = new TalusArguments())
        {
            Talus.talus_connect_options connect = options.Raw(arguments);
            current = null;
            call.Check(Talus.talus_connect(call.Client, ref connect));
            open = true;
        }
    }

    /// <summary>Closes the connection. Queued events and open answers are dropped, and Closed is not sent. No effect without a
    /// connection. May wait for a pending look-up of a host name.</summary>
    public void Disconnect()
    {
        using (Call call = Enter())
        {
            open = false;
            call.Check(Talus.talus_disconnect(call.Client));
        }
    }

    /// <summary>Writes the next event into `into`; false: none in time, or none can come (IsOpen is false), or another thread disposed of
    /// the client; `into` is then empty. Waits at most timeoutMs; 0: not at all, negative: without limit. Allocates nothing, but for
    /// errors (their text) and Heights (arrays). All work is done in here: call it at least every few seconds, each time until it returns
    /// false.</summary>
    public bool Poll(int timeoutMs, TalusEvent into)
    {
        if (into == null) throw new ArgumentNullException("into");
        using (Call call = Enter())
        {
            current = null;
            int status = Talus.talus_poll(call.Client, ref raw, timeoutMs);
            if (status < 0 || status == Talus.TALUS_OK && raw.type == Talus.TALUS_EVENT_CLOSED) open = false;
            // The chunk of an event that arrives during Dispose() goes with the client, at the end of this call.
            if (disposed || status == Talus.TALUS_NO_EVENT || status == Talus.TALUS_NOT_CONNECTED)
            {
                into.Set(null, ref none);
                return false;
            }
            call.Check(status);
            into.Set(this, ref raw);
            current = into;
            return true;
        }
    }

    /// <summary>After Joined.</summary>
    public TalusWorld GetWorld()
    {
        using (Call call = Enter()) return TalusWorld.Of(call.Client);
    }

    /// <summary>Replaces the View. Cheap: every frame is fine.</summary>
    public void SetView(TalusView view)
    {
        if (view == null) throw new ArgumentNullException("view");
        Talus.talus_view sent = view.Raw();
        using (Call call = Enter()) call.Check(Talus.talus_set_view(call.Client, ref sent));
    }

    /// <summary>Number of chunks of the View, for a progress bar.</summary>
    public ulong CountView(TalusView view)
    {
        if (view == null) throw new ArgumentNullException("view");
        ulong chunks;
        Talus.talus_view counted = view.Raw();
        using (Call call = Enter()) call.Check(Talus.talus_count_view(call.Client, ref counted, out chunks));
        return chunks;
    }

    // ---- Requests: each returns the number that its answer has as TalusEvent.Request ----

    /// <summary>Answered by ChunkAnswer. `known`: the hash of the caller's copy.</summary>
    public uint GetChunk(int x, int y, int z, uint level, TalusHash? known = null)
    {
        uint request;
        ulong[] halves = known.HasValue ? new[] { known.Value.Low, known.Value.High } : null;
        using (Call call = Enter()) call.Check(Talus.talus_get_chunk(call.Client, x, y, z, level, halves, out request));
        return request;
    }

    /// <summary>Answered by Heights. x and z of each base column.</summary>
    public uint GetHeights(long[] columns)
    {
        uint request;
        UIntPtr count = CountColumns(columns);
        using (Call call = Enter()) call.Check(Talus.talus_get_heights(call.Client, columns, count, out request));
        return request;
    }

    /// <summary>Answered by Heights with Looks, and Values of these of TalusWorld.Fields, at most 16.</summary>
    public uint GetPlaces(long[] columns, params string[] fields)
    {
        uint request;
        UIntPtr count = CountColumns(columns);
        if (fields == null) throw new ArgumentNullException("fields");
        using (Call call = Enter())
        using (var arguments = new TalusArguments())
        {
            var names = new IntPtr[fields.Length];
            for (int i = 0; i < names.Length; ++i) names[i] = arguments.Text(fields[i], "fields[" + i + "]");
            call.Check(Talus.talus_get_places(call.Client, columns, count, names, (UIntPtr)(uint)names.Length, out request));
        }
        return request;
    }

    /// <summary>Answered by Edited, once the edit is stored or rejected.</summary>
    public uint SendEdit(TalusEdit edit)
    {
        if (edit == null) throw new ArgumentNullException("edit");
        uint request;
        using (Call call = Enter())
        using (var arguments = new TalusArguments())
        {
            Talus.talus_edit sent = edit.Raw(arguments);
            call.Check(Talus.talus_send_edit(call.Client, ref sent, out request));
        }
        return request;
    }

    /// <summary>Answered by Pong.</summary>
    public uint Ping()
    {
        uint request;
        using (Call call = Enter()) call.Check(Talus.talus_ping(call.Client, out request));
        return request;
    }

    /// <summary>Cancels a GetChunk(). It is still answered: with TalusStatus.Cancelled, or with the chunk if it was in flight.</summary>
    public void Cancel(uint request)
    {
        using (Call call = Enter()) call.Check(Talus.talus_cancel(call.Client, request));
    }

    /// <summary>Running totals since Connect().</summary>
    public TalusStats GetStats()
    {
        var stats = Talus.talus_stats.Create();
        using (Call call = Enter()) call.Check(Talus.talus_get_stats(call.Client, ref stats));
        return new TalusStats(ref stats);
    }

    /// <summary>The chunk of this event. While the call lives, no Poll() and no Dispose() frees it.</summary>
    internal Call HoldChunk(TalusEvent of, out IntPtr chunk)
    {
        Call call = Enter();
        chunk = raw.chunk;
        if (current == of) return call;
        call.Dispose();
        throw new ObjectDisposedException("TalusEvent",
            "its client polled or connected again; Retain() a chunk to keep it longer than its event");
    }

    Call Enter()
    {
        if (disposed) throw new ObjectDisposedException("TalusClient");
        return handle.Enter();
    }

    static UIntPtr CountColumns(long[] columns)
    {
        if (columns == null) throw new ArgumentNullException("columns");
        if (columns.Length % 2 != 0) throw new ArgumentException(columns.Length + " numbers; a column has two, x and z", "columns");
        return (UIntPtr)(uint)(columns.Length / 2);
    }

    internal sealed class Handle : SafeHandle
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
    internal struct Call : IDisposable
    {
        readonly Handle handle;
        internal readonly IntPtr Client;

        internal Call(Handle handle, IntPtr client)
        {
            this.handle = handle;
            Client = client;
        }

        internal void Check(int status) { TalusException.Check(status, Client); }
        public void Dispose() { handle.Leave(true); }
    }
}
