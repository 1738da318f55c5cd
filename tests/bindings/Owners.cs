// Owners PORT: clients and chunks of Talus*.cs are freed once, also if a program forgets them or frees them twice, and errors are
// exceptions with libtalus's words. Needs the libtalus.so of owners.c, which counts owners.
using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using System.Runtime.InteropServices;
using System.Threading;

static class Owners
{
    [DllImport("talus", CallingConvention = CallingConvention.Cdecl)]
    static extern int owned_clients();
    [DllImport("talus", CallingConvention = CallingConvention.Cdecl)]
    static extern int owned_chunks();

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

    /// In a thread of its own: afterwards no stack refers to what it made.
    static void Forget(Action action)
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
        thread.Start();
        thread.Join();
        if (thrown != null) throw new Exception(thrown.ToString());
        for (int i = 0; i < 3; ++i)
        {
            GC.Collect();
            GC.WaitForPendingFinalizers();
        }
    }

    static TalusEvent Wait(TalusClient client, uint type)
    {
        TalusEvent next;
        while (client.Poll(60000, out next))
        {
            if (next.Type == type) return next;
            if (next.Type == Talus.TALUS_EVENT_CLOSED) next.ThrowIfFailed();
        }
        throw new Exception("no event of type " + type);
    }

    static TalusClient Joined()
    {
        var client = new TalusClient();
        client.Connect(new TalusOptions { Host = "127.0.0.1", Port = port });
        Wait(client, Talus.TALUS_EVENT_JOINED);
        return client;
    }

    static TalusClient Viewing()
    {
        TalusClient client = Joined();
        TalusWorld world = client.GetWorld();
        var view = new Talus.talus_view { centre_x = world.SpawnX, centre_y = world.SpawnY, centre_z = world.SpawnZ, horizontal_radius = 2 };
        client.SetView(view);
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
        TalusEvent next;
        Throws<ObjectDisposedException>(() => client.Poll(0, out next), "TalusClient");
        Forget(() => { for (int i = 0; i < 10; ++i) Joined(); });
        Owned(0, 0, "clients that are forgotten");
    }

    static void Chunks()
    {
        TalusClient client = Viewing();
        TalusChunk first = Wait(client, Talus.TALUS_EVENT_CHUNK).Chunk;
        first.Decode(voxels);
        TalusChunk kept = first.Retain(), other = kept.Retain();
        Owned(1, 3, "a chunk, retained twice");
        Wait(client, Talus.TALUS_EVENT_VIEW_COMPLETE);
        Throws<ObjectDisposedException>(() => first.Decode(voxels), "Retain() a chunk to keep it longer than its event");
        Throws<ObjectDisposedException>(() => first.Retain(), "Retain()");
        Owned(1, 2, "after its event");
        kept.Dispose();
        kept.Dispose();
        Owned(1, 1, "an owner that is disposed of twice");
        client.Dispose();
        other.Decode(voxels);
        other.Dispose();
        Owned(0, 0, "a chunk beyond its client");

        client = Viewing();
        TalusChunk last = Wait(client, Talus.TALUS_EVENT_CHUNK).Chunk;
        client.Dispose();
        Throws<ObjectDisposedException>(() => last.Decode(voxels), "Retain()");
        Owned(0, 0, "the last event's chunk");

        Forget(() =>
        {
            using (TalusClient each = Viewing())
                for (int i = 0; i < 10; ++i) Wait(each, Talus.TALUS_EVENT_CHUNK).Chunk.Retain();
        });
        Owned(0, 0, "retained chunks that are forgotten");
    }

    /// Chunks that threads decode while their owners are disposed of.
    static void ChunksOfThreads()
    {
        TalusClient client = Viewing();
        var chunks = new List<TalusChunk>();
        for (int i = 0; i < 20; ++i) chunks.Add(Wait(client, Talus.TALUS_EVENT_CHUNK).Chunk.Retain());
        Thread[] threads = Enumerable.Range(0, 3).Select(_ => new Thread(() =>
        {
            var own = new ushort[Talus.TALUS_CHUNK_VOLUME];
            foreach (TalusChunk chunk in chunks)
            {
                try
                {
                    chunk.Decode(own);
                }
                catch (ObjectDisposedException)
                {
                }
            }
        })).ToArray();
        foreach (Thread thread in threads) thread.Start();
        foreach (TalusChunk chunk in chunks) chunk.Dispose();
        client.Dispose();
        foreach (Thread thread in threads) thread.Join();
        Owned(0, 0, "chunks that threads decode");
    }

    static void Threads()
    {
        TalusClient client = Joined();
        TalusEvent next;
        bool found = true;
        var thread = new Thread(() => found = client.Poll(3000, out next));
        thread.Start();
        Thread.Sleep(1000);
        Throws<InvalidOperationException>(() => client.Ping(), "another thread is in a call");
        client.Dispose();
        Owned(1, 0, "a client in a call of another thread");
        thread.Join();
        Equal(found, false, "an event");
        Owned(0, 0, "after that call");
    }

    static void Errors()
    {
        using (var client = new TalusClient())
        {
            TalusEvent next;
            Equal(client.Poll(0, out next), false, "an event without a connection");
            TalusException error = Throws<TalusException>(() => client.Ping(), "talus_ping");
            Equal(error.Status, Talus.TALUS_NOT_CONNECTED, "without a connection");
            var zero = new TalusOptions { Host = "local\0host" };
            error = Throws<TalusException>(() => client.Connect(zero), "\"local\\0host\" contains a zero");
            Equal(error.Status, Talus.TALUS_INVALID_ARGUMENT, "a zero in a name");
            Throws<TalusException>(() => client.Connect(new TalusOptions { Host = "" }), "host");
            Throws<ArgumentException>(() => client.GetHeights(new long[3]), "3 numbers; a column has two");
            Throws<ArgumentException>(() => new TalusEdit().Paste(0, 0, 0, new ushort[7]), "7 voxels; a paste has 32768");
            client.Connect(new TalusOptions { Host = "größe.invalid" });
            Equal(client.Poll(60000, out next), true, "CLOSED");
            Equal(next.Type, Talus.TALUS_EVENT_CLOSED, "the event");
            error = Throws<TalusException>(next.ThrowIfFailed, "größe.invalid");
            Equal(error.Status, Talus.TALUS_UNREACHABLE, "a name that is none");
        }
        using (TalusClient client = Viewing())
        {
            TalusChunk chunk = Wait(client, Talus.TALUS_EVENT_CHUNK).Chunk;
            Throws<TalusException>(() => chunk.Decode(new ushort[7]), "count is not TALUS_CHUNK_VOLUME, 32768");
            Throws<TalusException>(() => chunk.Decode(null), "voxels is NULL");
            Throws<TalusException>(() => client.SetView(new Talus.talus_view { horizontal_radius = 60000 }), "60000");
        }
        Owned(0, 0, "after errors");
    }

    /// A field that talus.h gains is missing in no class.
    static void Fields()
    {
        var of = new Dictionary<Type, Type> {
            { typeof(Talus.talus_connect_options), typeof(TalusOptions) }, { typeof(Talus.talus_event), typeof(TalusEvent) },
            { typeof(Talus.talus_world), typeof(TalusWorld) }, { typeof(Talus.talus_material), typeof(TalusMaterial) } };
        foreach (var pair in of)
        {
            foreach (FieldInfo field in pair.Key.GetFields().Where(each => each.Name != "size" && each.Name != "reserved"))
            {
                string name = field.Name.Replace("_low", "").Replace("_high", "");
                if (pair.Value == typeof(TalusWorld)) name = name.Replace("_count", "s");
                name = string.Concat(name.Split('_').Select(word => char.ToUpperInvariant(word[0]) + word.Substring(1)));
                if (pair.Value.GetField(name) == null) throw new Exception(pair.Value.Name + " has no " + name);
            }
        }
        var options = new TalusOptions();
        foreach (FieldInfo field in typeof(TalusOptions).GetFields())
            field.SetValue(options, field.FieldType == typeof(string) ? "x" : Convert.ChangeType(1, field.FieldType));
        using (var arguments = new TalusArguments())
        {
            Passed(options.Raw(arguments));
            var edit = new TalusEdit { Subject = "x" }.Guard(0, 0, 0, 0).Write(0, 0, 0, 0).Fill(0, 0, 0, 0, 0, 0, 0);
            Passed(edit.Paste(1, 1, 1, voxels, true).Raw(arguments));
        }
    }

    static void Passed(ValueType raw)
    {
        foreach (FieldInfo field in raw.GetType().GetFields())
            if (field.Name != "reserved" && field.GetValue(raw).Equals(Activator.CreateInstance(field.FieldType)))
                throw new Exception(raw.GetType().Name + "." + field.Name + " is not passed on");
    }

    static int Main(string[] arguments)
    {
        port = uint.Parse(arguments[0]);
        foreach (Action test in new Action[] { Fields, Clients, Chunks, ChunksOfThreads, Threads, Errors })
        {
            try
            {
                test();
            }
            catch (Exception error)
            {
                Console.Error.WriteLine("{0}: {1}", test.Method.Name, error);
                return 1;
            }
        }
        return 0;
    }
}
