// Errors between a client and its server. Errors are values; each has a one-line message.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

#include <tl/expected.hpp>

namespace talus::client {

enum class ErrorKind : std::uint8_t {
  unreachable,      // the name does not resolve, or nothing listens there
  refused,          // the server rejects this client: version, token, too many connections
  untrusted,        // TLS: the server's certificate was not accepted
  disconnected,     // the connection broke, or the server closed it
  timed_out,        // no answer in time while connecting, or silence afterwards
  world_changed,    // after a reconnect the server had another world
  broken_protocol,  // the server violated the protocol; the connection was dropped
  bad_chunk,        // a chunk failed to decode, or does not match its hash
  out_of_range,     // a coordinate, radius, list or edit exceeds the world's or the server's limits
  overloaded,       // the server asks for a retry after `retry_after`
  cancelled,        // cancel() came before the answer
  server_failed,    // the server could not answer; a retry may succeed
  not_connected,    // called before connect(), or after close()
  conflict,         // a guard of the edit does not hold; nothing was applied
  not_applied,      // the edit was not applied, but a later one was
  outcome_unknown,  // the edit may have been applied: the server no longer knows the editor
  cannot_generate,  // chunks cannot be made here (Options::generate)
};

struct ClientError {
  ErrorKind kind{};
  std::string message;                       // one line, for humans
  std::chrono::milliseconds retry_after{0};  // 0: no hint
  /// For an edit that close() ended during a wait that the server had asked for: the server's reason. One
  /// line, or empty.
  std::string waited_for{};
};

template <typename T>
using Result = tl::expected<T, ClientError>;

}  // namespace talus::client
