// Owners PORT: clients and chunks of Talus*.cs are freed once, also if a program forgets them or frees them twice, and errors are
// exceptions with libtalus's words. Needs the libtalus.so of owners.c, which counts owners and holds calls.
using System;
using System.Runtime.InteropServices;
using System.Threading;

static class Owners
{
    [DllImport("talus", CallingConvention = CallingConvention.Cdecl)]
    static extern int owned_clients();
    [DllImport("talus", CallingConvention = CallingConvention.Cdecl)]
    static extern int owned_chunks();
    [DllImport("talus", CallingConvention = CallingConvention.Cdecl)]
    static extern void gate_close();
    [DllImport("talus", CallingConvention = CallingConvention.Cdecl)]
    static extern int gate_await();
    [DllImport("talus", CallingConvention = CallingConvention.Cdecl)]
    static extern void gate_open();
    [DllImport("talus", CallingConvention = CallingConvention.Cdecl)]
    static extern void repeat_event(int times);

    static uint port;
    static readonly ushort[] voxels = new ushort[Talus.TALUS_CHUNK_VOLUME];

    static void Equal<T>(T found, T expected, string what)
    {
        if (!Equals(found, expected)) throw new Exception(what + ": " + found + ", not " + expected);
    }

    static void Owned(int clients, int chunks, string what)
    {
        Equal(owned_clients() + " clients, " + owned_chunks() + " chunks", clients + " clients, " + chunks + " chunks", what);
    }

    static T Throws<T>(Action action, string part) where T : Exception
    {
        try
        {
            action();
        }
        catch (T error)
        {
            if (!error.Message.Contains(part)) throw new Exception("'" + error.Message + "' is without '" + part + "'");
            return error;
        }
        throw new Exception("no " + typeof(T).Name + " with '" + part + "'");
    }

    static void Null(Action action, string parameter)
    {
        Equal(Throws<ArgumentNullException>(action, parameter).ParamName, parameter, "the parameter");
    }

    /// Begins this in another thread. What it returns waits for the end, and throws what that threw.
    static Action Begin(Action action)
    {
        Exception thrown = null;
        var thread = new Thread(() =>
        {
            try
            {
                action();
            }
            catch (Exception error)
            {
                thrown = error;
            }
        });
        thread.IsBackground = true; // a test that fails leaves it at the gate
        thread.Start();
        return () =>
        {
            thread.Join();
            if (thrown != null) throw new Exception(thrown.ToString());
        };
    }

    /// Begins this and waits until owners.c holds its call.
    static Action Held(Action action, int type)
    {
        gate_close();
        Action end = Begin(action);
        Equal(gate_await(), type, "the event of the call that is held");
        return () =>
        {
            gate_open();
            end();
        };
    }

    /// In a thread of its own: afterwards no stack refers to what it made.
    static void Forget(Action action)
    {
        Begin(action)();
        for (int i = 0; i < 3; ++i)
        {
            GC.Collect();
            GC.WaitForPendingFinalizers();
        }
    }

    static TalusEvent Wait(TalusClient client, TalusEventType type)
    {
        var next = new TalusEvent();
        while (client.Poll(60000, next))
        {
            if (next.Type == type) return next;
            if (next.Type == TalusEventType.Closed) next.ThrowIfFailed();
        }
        throw new Exception("no event of type " + type);
    }

    static TalusClient Joined()
    {
        var client = new TalusClient();
        client.Connect(new TalusOptions { Host = "127.0.0.1", Port = port });
        Wait(client, TalusEventType.Joined);
        return client;
    }

    static TalusClient Viewing()
    {
        TalusClient client = Joined();
        TalusWorld world = client.GetWorld();
        client.SetView(new TalusView { CentreX = world.SpawnX, CentreY = world.SpawnY, CentreZ = world.SpawnZ, HorizontalRadius = 2 });
        return client;
    }

    static void Clients()
    {
        TalusClient client = Joined();
        Owned(1, 0, "a client");
        client.Dispose();
        client.Dispose();
        Owned(0, 0, "a client that is disposed of twice");
        Throws<ObjectDisposedException>(() => client.Ping(), "TalusClient");
        Throws<ObjectDisposedException>(() => client.Poll(0, new TalusEvent()), "TalusClient");
        Forget(() => { for (int i = 0; i < 10; ++i) Joined(); });
        Owned(0, 0, "clients that are forgotten");
    }

    static void Chunks()
    {
        TalusClient client = Viewing();
        TalusEvent first = Wait(client, TalusEventType.Chunk);
        first.Decode(voxels);
        Owned(1, 0, "an event's chunk");
        TalusChunk kept = first.Retain(), other = kept.Retain();
        Owned(1, 2, "a chunk, retained twice");
        Wait(client, TalusEventType.ViewComplete);
        Throws<ObjectDisposedException>(() => first.Decode(voxels), "Retain() a chunk to keep it longer than its event");
        Throws<ObjectDisposedException>(() => first.Retain(), "Retain()");
        kept.Dispose();
        kept.Dispose();
        Owned(1, 1, "an owner that is disposed of twice");
        Throws<ObjectDisposedException>(() => kept.Decode(voxels), "TalusChunk");
        client.Dispose();
        other.Decode(voxels);
        other.Dispose();
        Owned(0, 0, "a chunk beyond its client");

        client = Viewing();
        TalusEvent last = Wait(client, TalusEventType.Chunk);
        client.Disconnect();
        last.Decode(voxels);
        client.Connect(new TalusOptions { Host = "127.0.0.1", Port = port });
        Throws<ObjectDisposedException>(() => last.Decode(voxels), "connected again");
        client.Dispose();
        Throws<ObjectDisposedException>(() => last.Retain(), "TalusClient");
        Throws<InvalidOperationException>(() => new TalusEvent().Decode(voxels), "it has no chunk");
        Owned(0, 0, "the last event's chunk");

        Forget(() =>
        {
            using (TalusClient each = Viewing())
                for (int i = 0; i < 10; ++i) Wait(each, TalusEventType.Chunk).Retain();
        });
        Owned(0, 0, "retained chunks that are forgotten");
    }

    static void DisposedWhileDecoding()
    {
        TalusClient client = Viewing();
        TalusEvent next = Wait(client, TalusEventType.Chunk);
        TalusChunk chunk = next.Retain();
        Action end = Held(() => chunk.Decode(voxels), 0);
        chunk.Dispose();
        Owned(1, 1, "a chunk that another thread decodes");
        end();
        Owned(1, 0, "after that call");

        end = Held(() => next.Decode(voxels), 0);
        Throws<InvalidOperationException>(() => client.Poll(0, next), "another thread is in a call");
        client.Dispose();
        Owned(1, 0, "a client whose event another thread decodes");
        end();
        Owned(0, 0, "after that call");
    }

    static void DisposedWhilePolling()
    {
        TalusClient client = Viewing();
        TalusEvent before = Wait(client, TalusEventType.Chunk), next = new TalusEvent();
        bool found = true;
        Action end = Held(() => found = client.Poll(60000, next), (int)TalusEventType.Chunk);
        Throws<InvalidOperationException>(() => client.Ping(), "another thread is in a call");
        Throws<InvalidOperationException>(() => before.Decode(voxels), "another thread is in a call");
        client.Dispose();
        Throws<ObjectDisposedException>(() => client.Ping(), "TalusClient");
        Owned(1, 0, "a client in a call of another thread");
        end();
        Owned(0, 0, "after that call");
        Equal(found, false, "an event of a client that is disposed of");
        Equal(next.HasChunk, false, "its chunk");
    }

    /// Play allocates nothing: the collector never halts a frame.
    static void Allocations()
    {
        const int times = 1000;
        using (TalusClient client = Viewing(), idle = new TalusClient())
        {
            TalusEvent next = Wait(client, TalusEventType.Chunk), nothing = new TalusEvent();
            TalusWorld world = client.GetWorld();
            var view = new TalusView { CentreX = world.SpawnX, CentreY = world.SpawnY, CentreZ = world.SpawnZ, HorizontalRadius = 2 };
            var edit = new TalusEdit();
            repeat_event(times + 1);
            long before = 0;
            for (int i = 0; i <= times; ++i)
            {
                if (i == 1) before = GC.GetAllocatedBytesForCurrentThread(); // the first call of a function compiles it
                client.Poll(0, next);
                next.Decode(voxels);
                client.SetView(view);
                client.GetStats();
                idle.Poll(0, nothing);
            }
            Equal(GC.GetAllocatedBytesForCurrentThread() - before, 0, "bytes allocated");
            Equal(next.Type, TalusEventType.Chunk, "the event that repeats");
            before = GC.GetAllocatedBytesForCurrentThread();
            for (int i = 0; i < 32768; ++i) edit.Write(i, 0, 0, 1);
            long bytes = GC.GetAllocatedBytesForCurrentThread() - before;
            Equal(bytes < 2 * 32768 * 26 + 4096, true, bytes + " bytes for 32768 voxels of 26 bytes: twice these is enough");
        }
    }

    static void Open()
    {
        var next = new TalusEvent();
        var client = new TalusClient();
        Equal(client.IsOpen, false, "before Connect()");
        Equal(client.Poll(60000, next), false, "an event without a connection");
        client.Connect(new TalusOptions { Host = "127.0.0.1", Port = port });
        Equal(client.IsOpen, true, "while it connects");
        client.Disconnect();
        Equal(client.IsOpen, false, "after Disconnect()");
        client.Connect(new TalusOptions { Host = "127.0.0.1", Port = 1 });
        Equal(client.Poll(60000, next), true, "CLOSED");
        Equal(client.IsOpen, false, "after CLOSED");
        Equal(client.Poll(60000, next), false, "an event after CLOSED");
        Equal(next.Type, (TalusEventType)0, "no event's type");
        Equal(next.UniformMaterial, -1, "no event's material");
        client.Connect(new TalusOptions { Host = "127.0.0.1", Port = port });
        client.Dispose();
        Equal(client.IsOpen, false, "after Dispose()");
    }

    static void Errors()
    {
        using (var client = new TalusClient())
        {
            TalusException error = Throws<TalusException>(() => client.Ping(), "talus_ping");
            Equal(error.Status, TalusStatus.NotConnected, "without a connection");
            Equal(error.Message.EndsWith(" (TALUS_NOT_CONNECTED)"), true, "the name in '" + error.Message + "'");
            error = Throws<TalusException>(() => client.Connect(new TalusOptions { Token = "secret\0" }), "");
            Equal(error.Message, "TalusOptions.Token contains a zero character, at which libtalus's strings end (TALUS_INVALID_ARGUMENT)",
                "a token with a zero");
            Throws<TalusException>(() => client.GetPlaces(new long[2], "height", "slo\0pe"), "fields[1] contains a zero character");
            Throws<TalusException>(() => client.Connect(new TalusOptions { Host = "" }), "host");
            Throws<ArgumentException>(() => client.GetHeights(new long[3]), "3 numbers; a column has two");
            Throws<ArgumentException>(() => new TalusEdit().Paste(0, 0, 0, new ushort[7]), "7 voxels; a paste has 32768");
            Null(() => new TalusEdit().Paste(0, 0, 0, null), "voxels");
            Null(() => client.Connect(null), "options");
            Null(() => client.Poll(0, null), "into");
            Null(() => client.SetView(null), "view");
            Null(() => client.CountView(null), "view");
            Null(() => client.GetHeights(null), "columns");
            Null(() => client.GetPlaces(new long[2], null), "fields");
            Null(() => client.SendEdit(null), "edit");
            client.Connect(new TalusOptions { Host = "größe.invalid" });
            TalusEvent closed = Wait(client, TalusEventType.Closed);
            error = Throws<TalusException>(closed.ThrowIfFailed, "größe.invalid");
            Equal(error.Status, TalusStatus.Unreachable, "a name that is none");
        }
        using (TalusClient client = Viewing())
        {
            TalusEvent next = Wait(client, TalusEventType.Chunk);
            Throws<TalusException>(() => next.Decode(new ushort[7]), "count is not TALUS_CHUNK_VOLUME, 32768");
            Throws<TalusException>(() => next.Decode(IntPtr.Zero, 32768), "voxels is NULL");
            Null(() => next.Decode(null), "voxels");
            using (TalusChunk chunk = next.Retain())
            {
                Throws<TalusException>(() => chunk.Decode(new ushort[7]), "count is not TALUS_CHUNK_VOLUME, 32768");
                Null(() => chunk.Decode(null), "voxels");
            }
            Throws<TalusException>(() => client.SetView(new TalusView { HorizontalRadius = 60000 }), "60000");
        }
        Owned(0, 0, "after errors");
    }

    static int Main(string[] arguments)
    {
        port = uint.Parse(arguments[0]);
        var tests = new Action[] { Clients, Chunks, DisposedWhileDecoding, DisposedWhilePolling, Allocations, Open, Errors };
        foreach (Action test in tests)
        {
            try
            {
                test();
            }
            catch (Exception error)
            {
                Console.Error.WriteLine("{0}: {1}", test.Method.Name, error);
                gate_open(); // Mono ends no process with a thread that is held
                return 1;
            }
        }
        return 0;
    }
}
