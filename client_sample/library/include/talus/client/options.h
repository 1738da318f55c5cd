// Options of a client: connecting, reconnecting, TLS, WebSocket, and chunks that are made here.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <talus/client/chunk_maker.h>
#include <talus/client/clock.h>

namespace talus::client {

/// After the n-th consecutive failure the client waits for the delay that the server asked for, plus a random
/// time between 0 and min(first_delay * 2^(n-1), max_delay), so that the clients of one server do not return
/// all at once.
struct ReconnectPolicy {
  int max_attempts = 0;  // consecutive failures until the client gives up; 0: never reconnect
  std::chrono::milliseconds first_delay{500};
  std::chrono::milliseconds max_delay{10'000};
  std::optional<std::uint64_t> seed;  // for the random delays; equal seeds give equal delays. Empty: each
                                      // client draws its own
};

/// Maximum delay honoured if a departing or overloaded server asks for one.
inline constexpr std::chrono::milliseconds kLongestRetryAfter{60'000};

/// TLS 1.3 only.
struct TlsOptions {
  bool on = false;
  std::string ca_file;      // PEM file of trusted certificates; empty: the system's
  std::string server_name;  // name that the certificate must have; empty: the host given to connect()
  bool verify = true;       // false: the certificate is not checked, so any server is accepted
};

/// Carries the stream inside a WebSocket, for servers behind an HTTP proxy: connect to talusd's --http
/// address, or to the proxy. Not available in builds without TLS.
struct WebSocketOptions {
  bool on = false;
  std::string path = "/v1/stream";
  std::string host;  // value of the Host header; empty: HOST:PORT as given to connect()
};

/// `port` is a number or a service name.
struct ServerAddress {
  std::string host;
  std::string port;
};

/// Lets the client make a published world's chunks itself and receive only edits
/// (ServerLimits::view_base).
enum class Generate : std::uint8_t {
  never,
  automatic,  // until the world is open, or if it cannot be made here, chunks are streamed
  always,     // if the world cannot be made here, the connection ends by ErrorKind::cannot_generate
};

struct Options {
  std::string token;                          // issued by the server's operator; empty: no token
  std::string client_name = "talus::client";  // for the server's log
  std::uint64_t window_bytes = 1U << 20;      // maximum chunk bytes in flight; 0: the server's default
  /// Maximum bytes of decoded chunks kept after they left the View: if they return unchanged, the server
  /// sends only a few bytes, and on_chunk delivers them again. Keeps only chunks in use when they left. 0:
  /// off.
  std::size_t keep_bytes = 32U << 20;
  TlsOptions tls;
  WebSocketOptions websocket;
  std::chrono::milliseconds connect_timeout{5'000};    // name lookup, TCP, TLS and WebSocket
  std::chrono::milliseconds handshake_timeout{5'000};  // from Hello to Welcome
  std::chrono::milliseconds ping_interval{20'000};  // maximum; a third of the server's idle time-out if less
  std::chrono::milliseconds silence_timeout{60'000};  // without a byte from the server, then it counts as
                                                      // lost
  ReconnectPolicy reconnect;
  /// Other servers of the same world. If one cannot be reached, goes away or disconnects, the next is tried:
  /// first the one given to connect(), then these, then around again. Not needed if a balancer, or a name
  /// with several addresses, covers all servers.
  std::vector<ServerAddress> more_servers;
  Generate generate = Generate::never;
  std::shared_ptr<ChunkMaker> maker;  // needed unless `generate` is `never`; clients may share one
  /// Returns the files of the world with this fingerprint if the caller kept them (Events::on_world_files),
  /// or null: they are fetched from the server. They may be any files: another world is not used.
  std::function<std::shared_ptr<const WorldFiles>(ContentHash fingerprint)> kept_files;
  Clock* clock = &system_clock();  // must outlive the client; tests pass a manual one
};

}  // namespace talus::client
