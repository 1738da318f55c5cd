using System;

/// <summary>An error of libtalus: its line that says why, and the status's name, such as TALUS_REFUSED.</summary>
public sealed class TalusException : Exception
{
    public readonly TalusStatus Status;
    /// <summary>Delay that the server asks for; 0: no delay.</summary>
    public readonly uint RetryAfterMs;

    public TalusException(TalusStatus status, string message, uint retryAfterMs = 0)
        : base(message + " (" + Talus.Text(Talus.talus_status_name((int)status)) + ")")
    {
        Status = status;
        RetryAfterMs = retryAfterMs;
    }

    /// <summary>Throws if the status of a call is an error. Without a client: IntPtr.Zero.</summary>
    internal static void Check(int status, IntPtr client)
    {
        if (status < 0) throw new TalusException((TalusStatus)status, Talus.Text(Talus.talus_last_error(client)));
    }
}
