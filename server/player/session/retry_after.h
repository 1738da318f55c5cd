// When a refused client should try again: the one table of such times.
#pragma once

#include <chrono>

namespace talus::server::retry_after {

using std::chrono::milliseconds;

inline constexpr milliseconds kNever{0};       // trying again does not help
inline constexpr milliseconds kBusy{1000};     // a queue, memory or the limit of requests in flight is full
inline constexpr milliseconds kFailed{1000};   // a chunk or heights could not be generated
inline constexpr milliseconds kLeaving{1000};  // this session takes no more requests
inline constexpr milliseconds kServerFull{5000};  // no connection or handshake is admitted
inline constexpr milliseconds kShutdown{5000};    // the server ends

}  // namespace talus::server::retry_after
