// Reasons for stopping at the log that several components report.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include <fmt/format.h>

namespace talus::server::cluster {

inline constexpr const char* kMadeAnew = "the stream was made anew since this server read it";

inline constexpr const char* kLooking = "this server is looking for its place in the log";
inline constexpr const char* kShorter = "the log that this world's servers share seems to have lost its end";

inline std::string not_applied(std::uint64_t sequence, std::string_view reason) {
  return fmt::format("message {} of the log cannot be applied: {}", sequence, reason);
}

}  // namespace talus::server::cluster
