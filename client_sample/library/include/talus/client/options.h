// How a client connects, and how it behaves when the connection breaks.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <talus/client/clock.h>

namespace talus::client {

/// After the n-th failure in a row the client waits for as long as the server asked, and then for a time
/// between 0 and first_delay * 2^(n-1), at most max_delay, at random: clients of one server do not all return
/// at once.
struct ReconnectPolicy {
  int max_attempts = 0;  // failures in a row before it gives up; 0: never reconnect
  std::chrono::milliseconds first_delay{500};
  std::chrono::milliseconds max_delay{10'000};
  std::optional<std::uint64_t> seed;  // of the random part: the same seed gives the same delays; none: every
                                      // client has its own
};

/// A server that goes away, or has too much to do, may ask for a wait; none is longer than this.
inline constexpr std::chrono::milliseconds kLongestRetryAfter{60'000};

/// Encrypted, and with a server that proves who it is. Only TLS 1.3 is spoken.
struct TlsOptions {
  bool on = false;
  std::string ca_file;      // PEM: certificates to trust, such as one's own; empty: those the system trusts
  std::string server_name;  // that the certificate must be for; empty: the host given to connect()
  bool verify = true;       // false: anybody may pose as the server
};

/// The same stream inside a WebSocket, for servers behind an HTTP proxy: connect to talusd's --http address,
/// or to the proxy. Not in builds without TLS.
struct WebSocketOptions {
  bool on = false;
  std::string path = "/v1/stream";
  std::string host;  // that the server is asked for; empty: HOST:PORT as given to connect()
};

/// Where a server is. `port` is a number or a service name.
struct ServerAddress {
  std::string host;
  std::string port;
};

struct Options {
  std::string token;                          // what the server's operator gave out; empty: none
  std::string client_name = "talus::client";  // for the server's log
  std::uint64_t window_bytes = 1U << 20;      // chunk bytes in flight at most; 0: the server's default
  /// Of decoded chunks that left the View: where they come back the same, the server says so in a few bytes,
  /// and on_chunk brings them again. Only of chunks that somebody still held when they left; 0: none.
  std::size_t keep_bytes = 32U << 20;
  TlsOptions tls;
  WebSocketOptions websocket;
  std::chrono::milliseconds connect_timeout{5'000};    // resolving, connecting, TLS, and the WebSocket
  std::chrono::milliseconds handshake_timeout{5'000};  // from Hello to Welcome
  std::chrono::milliseconds ping_interval{20'000};  // at most; a third of the server's idle time-out if less
  std::chrono::milliseconds silence_timeout{60'000};  // no byte from the server for this long: it is gone
  ReconnectPolicy reconnect;
  /// Other servers of the same world. Where one cannot be reached, goes away or breaks off, the next is
  /// tried: first the one given to connect(), then these, and around again. None are needed where a balancer,
  /// or a name with several addresses, stands for all.
  std::vector<ServerAddress> more_servers;
  Clock* clock = &system_clock();  // outlives the client; tests give one that they move
};

}  // namespace talus::client
