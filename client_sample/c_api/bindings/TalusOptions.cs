/// <summary>Options of a connection; null, empty or 0 selects libtalus's default. talus_connect_options in Talus.cs says more.</summary>
public sealed class TalusOptions
{
    public TalusConnectFlags Flags;
    public string Host = "localhost", Token, ClientName, TlsCaFile, TlsServerName, MoreServers;
    public uint Port = Talus.TALUS_DEFAULT_PORT;
    public ulong WindowBytes, KeepBytes;
    public uint ConnectTimeoutMs, HandshakeTimeoutMs, PingIntervalMs, SilenceTimeoutMs;
    public uint ReconnectAttempts, ReconnectFirstDelayMs, ReconnectMaxDelayMs;

    internal Talus.talus_connect_options Raw(TalusArguments arguments)
    {
        var raw = Talus.talus_connect_options.Create();
        raw.flags = (uint)Flags;
        raw.host = arguments.Text(Host, "TalusOptions.Host");
        raw.token = arguments.Text(Token, "TalusOptions.Token");
        raw.client_name = arguments.Text(ClientName, "TalusOptions.ClientName");
        raw.tls_ca_file = arguments.Text(TlsCaFile, "TalusOptions.TlsCaFile");
        raw.tls_server_name = arguments.Text(TlsServerName, "TalusOptions.TlsServerName");
        raw.more_servers = arguments.Text(MoreServers, "TalusOptions.MoreServers");
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
