// What can go wrong between a client and its server. Errors are values; each has one clear line.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

#include <tl/expected.hpp>

namespace talus::client {

enum class ErrorKind : std::uint8_t {
  unreachable,      // the name does not resolve, or nobody answers there
  refused,          // the server will not have this client: version, token, too many connections
  untrusted,        // by TLS: the server could not prove that it is who it should be
  disconnected,     // the connection broke, or the server closed it
  timed_out,        // no answer in time while connecting, or silence afterwards
  world_changed,    // a reconnect met a server with another world
  broken_protocol,  // the server sent what the protocol does not allow; the connection was dropped
  bad_chunk,        // a chunk that does not decode, or whose content is not what its hash says
  out_of_range,     // a coordinate, radius, list or edit beyond the world's or the server's limits
  overloaded,       // the server asks to come back after `retry_after`
  cancelled,        // cancel() was faster than the answer
  server_failed,    // the server could not answer; repeating may help
  not_connected,    // asked before connect(), or after close()
  conflict,         // a guard of the edit does not hold; nothing happened
  not_applied,      // the edit did not happen, and a later one did
  outcome_unknown,  // the edit may have happened: the server has forgotten who sent it
};

struct ClientError {
  ErrorKind kind{};
  std::string message;                       // one line, for people
  std::chrono::milliseconds retry_after{0};  // 0: no hint
  /// Of an edit that close() ended while it waited, as the server had asked: why that has not taken it. One
  /// line, or empty.
  std::string waited_for{};
};

template <typename T>
using Result = tl::expected<T, ClientError>;

}  // namespace talus::client
