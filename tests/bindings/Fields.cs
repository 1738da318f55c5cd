// Fields: each field of talus.h has one in its class of Talus*.cs, with the same value. Needs no libtalus.
using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using System.Runtime.InteropServices;

static class Fields
{
    const BindingFlags Public = BindingFlags.Public | BindingFlags.Instance;

    static readonly string[] alone = { "size", "reserved" };
    static readonly Dictionary<string, string> otherNames = new Dictionary<string, string> {
        { "talus_event.chunk", "HasChunk" }, { "talus_view.flags", "Horizon" }, { "talus_world.material_count", "Materials" },
        { "talus_world.look_count", "Looks" }, { "talus_world.field_count", "Fields" } };
    static int numbers = 100;

    static object Distinct(Type type)
    {
        ++numbers;
        if (type == typeof(bool)) return true;
        if (type == typeof(string)) return "text " + numbers;
        return type.IsEnum ? Enum.ToObject(type, numbers) : Convert.ChangeType(numbers, type);
    }

    /// A struct of talus.h in which every value is another. `given` has those that are not any number: what pointers point to.
    static T Raw<T>(Dictionary<string, object> given) where T : struct
    {
        object raw = default(T);
        foreach (FieldInfo field in typeof(T).GetFields(Public).Where(each => !alone.Contains(each.Name)))
        {
            if (!given.ContainsKey(field.Name)) given[field.Name] = Distinct(field.FieldType);
            object value = given[field.Name];
            if (field.FieldType == typeof(IntPtr))
                value = value is string ? Talus.Allocate((string)value) : value is Array ? Pinned(value) : (IntPtr)1;
            field.SetValue(raw, Convert.ChangeType(value, field.FieldType));
        }
        return (T)raw;
    }

    static IntPtr Pinned(object array) { return GCHandle.Alloc(array, GCHandleType.Pinned).AddrOfPinnedObject(); }

    static string Plain(object value)
    {
        if (value is string) return (string)value;
        if (value is IntPtr) return Talus.Text((IntPtr)value);
        if (value is Array) return string.Join(" ", ((Array)value).Cast<object>());
        return Convert.ToDecimal(value).ToString();
    }

    /// What an object of a class has for this field of the struct.
    static object Of(object of, string type, string field)
    {
        string name;
        if (!otherNames.TryGetValue(type + "." + field, out name))
        {
            IEnumerable<string> words = field.Split('_').Where(word => word != "low" && word != "high" && !char.IsDigit(word[0]));
            name = string.Concat(words.Select(word => char.ToUpperInvariant(word[0]) + word.Substring(1)));
        }
        PropertyInfo property = of.GetType().GetProperty(name);
        FieldInfo member = of.GetType().GetField(name);
        if (property == null && member == null) throw new Exception(of.GetType().Name + " has no " + name + " for " + type + "." + field);
        object value = property != null ? property.GetValue(of, null) : member.GetValue(of);
        if (value is TalusHash) return field.EndsWith("_low") ? ((TalusHash)value).Low : ((TalusHash)value).High;
        return char.IsDigit(field[field.Length - 1]) ? ((Array)value).GetValue(field[field.Length - 1] - '1') : value;
    }

    static void Same(object found, object expected, string what)
    {
        if (Plain(found) != Plain(expected)) throw new Exception(what + ": " + Plain(found) + ", not " + Plain(expected));
    }

    static void Received(string type, Dictionary<string, object> given, object of)
    {
        foreach (var pair in given) Same(Of(of, type, pair.Key), pair.Value, of.GetType().Name + " for " + type + "." + pair.Key);
    }

    static T Filled<T>(T of)
    {
        foreach (FieldInfo field in typeof(T).GetFields(Public).Where(each => !each.FieldType.IsArray))
            field.SetValue(of, Distinct(field.FieldType));
        return of;
    }

    static void Sent(object of, ValueType raw)
    {
        string type = raw.GetType().Name;
        foreach (FieldInfo field in raw.GetType().GetFields(Public).Where(each => !alone.Contains(each.Name)))
            Same(field.GetValue(raw), Of(of, type, field.Name), type + "." + field.Name);
    }

    static void Events()
    {
        var given = new Dictionary<string, object> {
            { "status", -17 }, { "message", "why" }, { "chunk", true }, { "column_count", 2 }, { "field_count", 3 },
            { "heights_fx", new[] { 51, 52 } }, { "looks", new byte[] { 53, 54 } }, { "values", new float[] { 1, 2, 3, 4, 5, 6 } } };
        Talus.talus_event raw = Raw<Talus.talus_event>(given);
        var of = new TalusEvent();
        of.Set(null, ref raw);
        Received("talus_event", given, of);
    }

    static void Worlds()
    {
        var given = new Dictionary<string, object> { { "name", "rock" } };
        Talus.talus_material rawMaterial = Raw<Talus.talus_material>(given);
        var material = new TalusMaterial(ref rawMaterial);
        Received("talus_material", given, material);

        TalusMaterial[] materials = { material };
        string[] looks = { "", "desert" }, fields = { "temperature" };
        given = new Dictionary<string, object> { { "server", "talusd" }, { "has_horizon", 1 } };
        Talus.talus_world raw = Raw<Talus.talus_world>(given);
        given["material_count"] = materials;
        given["look_count"] = looks;
        given["field_count"] = fields;
        Received("talus_world", given, new TalusWorld(ref raw, materials, looks, fields));
    }

    static void Stats()
    {
        var given = new Dictionary<string, object>();
        Talus.talus_stats raw = Raw<Talus.talus_stats>(given);
        Received("talus_stats", given, new TalusStats(ref raw));
    }

    static void Options()
    {
        TalusOptions of = Filled(new TalusOptions());
        using (var arguments = new TalusArguments()) Sent(of, of.Raw(arguments));
    }

    static void Views()
    {
        TalusView of = Filled(new TalusView());
        for (int i = 0; i < of.RingRadius.Length; ++i) of.RingRadius[i] = (ushort)Distinct(typeof(ushort));
        Sent(of, of.Raw());
    }

    /// Three of each, so that arrays grow.
    static void Edits()
    {
        var of = new TalusEdit { Subject = "player" };
        var voxels = new ushort[Talus.TALUS_CHUNK_VOLUME];
        voxels[1] = 7;
        for (int i = 0; i < 3; ++i)
        {
            of.Guard(i, 10 + i, 20 + i, (ushort)(30 + i)).Write(100 + i, 110 + i, 120 + i, (ushort)(130 + i));
            of.Fill(200 + i, 210 + i, 220 + i, 230 + i, 240 + i, 250 + i, 260 + i, 270 + i);
        }
        of.Paste(301, 302, 303, voxels, true);
        using (var arguments = new TalusArguments())
        {
            Talus.talus_edit raw = of.Raw(arguments);
            Same(raw.flags, Talus.TALUS_PASTE_AIR, "flags");
            Same(new[] { raw.guard_count, raw.write_count, raw.fill_count }, new[] { 3, 3, 3 }, "counts");
            Same(Longs(raw.guard_voxels, 9), new[] { 0, 10, 20, 1, 11, 21, 2, 12, 22 }, "guard_voxels");
            Same(Shorts(raw.guard_materials, 3), new[] { 30, 31, 32 }, "guard_materials");
            Same(Longs(raw.write_voxels, 9), new[] { 100, 110, 120, 101, 111, 121, 102, 112, 122 }, "write_voxels");
            Same(Shorts(raw.write_materials, 3), new[] { 130, 131, 132 }, "write_materials");
            int[] corners = { 200, 210, 220, 230, 240, 250, 201, 211, 221, 231, 241, 251, 202, 212, 222, 232, 242, 252 };
            Same(Longs(raw.fill_corners, 18), corners, "fill_corners");
            Same(Ints(raw.fill_materials, 3), new[] { 260, 261, 262 }, "fill_materials");
            Same(Ints(raw.fill_only, 3), new[] { 270, 271, 272 }, "fill_only");
            Same(Shorts(raw.paste_voxels, 3), new[] { 0, 7, 0 }, "paste_voxels");
            Same(new[] { raw.paste_x, raw.paste_y, raw.paste_z }, new[] { 301, 302, 303 }, "paste");
            Same(raw.subject, "player", "subject");
            raw = new TalusEdit().Raw(arguments);
            raw.size = 0;
            Same(raw.Equals(default(Talus.talus_edit)), true, "an empty edit");
        }
    }

    static long[] Longs(IntPtr from, int count)
    {
        var copy = new long[count];
        Marshal.Copy(from, copy, 0, count);
        return copy;
    }

    static int[] Ints(IntPtr from, int count)
    {
        var copy = new int[count];
        Marshal.Copy(from, copy, 0, count);
        return copy;
    }

    static short[] Shorts(IntPtr from, int count)
    {
        var copy = new short[count];
        Marshal.Copy(from, copy, 0, count);
        return copy;
    }

    static int Main()
    {
        foreach (Action test in new Action[] { Events, Worlds, Stats, Options, Views, Edits })
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
