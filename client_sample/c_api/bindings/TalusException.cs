using System;

/// <summary>A status below 0, such as Talus.TALUS_REFUSED, and libtalus's line that says why.</summary>
public sealed class TalusException : Exception
{
    public readonly int Status;
    /// <summary>Delay that the server asks for; 0: no delay.</summary>
    public readonly uint RetryAfterMs;

    public TalusException(int status, string message, uint retryAfterMs = 0) : base(message)
    {
        Status = status;
        RetryAfterMs = retryAfterMs;
    }

    /// <summary>Throws if the status of a call is an error. Without a client: IntPtr.Zero.</summary>
    internal static int Check(int status, IntPtr client)
    {
        if (status < 0) throw new TalusException(status, Talus.Text(Talus.talus_last_error(client)));
        return status;
    }
}
