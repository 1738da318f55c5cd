// Times after which a refused client should retry: the only table of them.
#pragma once

#include <chrono>

namespace talus::server::retry_after {

using std::chrono::milliseconds;

inline constexpr milliseconds kNever{0};       // retrying does not help
inline constexpr milliseconds kBusy{1000};     // a queue, memory or the limit of requests in flight is full
inline constexpr milliseconds kFailed{1000};   // a chunk or heights could not be generated
inline constexpr milliseconds kLeaving{1000};  // this session accepts no more requests
inline constexpr milliseconds kCutOff{2000};   // the shared log cannot be reached
inline constexpr milliseconds kEditorsFull = std::chrono::minutes{2};  // idle editors are removed one by one
inline constexpr milliseconds kServerFull{5000};  // a connection or handshake is not admitted
inline constexpr milliseconds kShutdown{5000};    // the server is ending

}  // namespace talus::server::retry_after
