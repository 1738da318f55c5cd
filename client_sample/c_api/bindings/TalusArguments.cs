using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;

/// <summary>Memory that one call reads. It may go afterwards: libtalus copies its arguments before it returns.</summary>
internal sealed class TalusArguments : IDisposable
{
    readonly List<IntPtr> strings = new List<IntPtr>();
    readonly List<GCHandle> pinned = new List<GCHandle>();

    /// <summary>UTF-8; null is libtalus's empty string. An error names the text and never quotes it: it may be a token.</summary>
    internal IntPtr Text(string text, string name)
    {
        if (string.IsNullOrEmpty(text)) return IntPtr.Zero;
        if (text.IndexOf('\0') >= 0)
            throw new TalusException(TalusStatus.InvalidArgument,
                name + " contains a zero character, at which libtalus's strings end");
        IntPtr copy = Talus.Allocate(text);
        strings.Add(copy);
        return copy;
    }

    /// <summary>The address of an array, which stays there until this is disposed of; IntPtr.Zero without `count` elements.</summary>
    internal IntPtr Pin(Array numbers, int count)
    {
        if (numbers == null || count == 0) return IntPtr.Zero;
        GCHandle pin = GCHandle.Alloc(numbers, GCHandleType.Pinned);
        pinned.Add(pin);
        return pin.AddrOfPinnedObject();
    }

    public void Dispose()
    {
        foreach (IntPtr copy in strings) Marshal.FreeHGlobal(copy);
        foreach (GCHandle pin in pinned) pin.Free();
        strings.Clear();
        pinned.Clear();
    }
}
