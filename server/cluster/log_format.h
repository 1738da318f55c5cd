// Of which format the messages of a stream may be. It is for whoever may change the stream to say, and not
// for those who write messages: else any of them could stop all servers by one of a format to come.
// FORMAT.md. Pure.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace talus::server::cluster {

/// Of messages, their kinds, entries, their kinds, and codecs of what they paste, all together: that which
/// this talusd reads.
inline constexpr std::uint32_t kLogFormat = 1;

/// Messages from `from` on may be of this format.
struct EnabledFormat {
  std::uint32_t number = 1;
  std::uint64_t from = 0;
  bool operator==(const EnabledFormat&) const = default;

  /// Whether one that this talusd cannot read may be one for a newer talusd.
  [[nodiscard]] bool is_newer_at(std::uint64_t sequence) const {
    return number > kLogFormat && sequence >= from;
  }
};

/// What a stream's description says: "log format 2 from message 1000000". Any other text: format 1.
[[nodiscard]] EnabledFormat enabled_format(std::string_view description);

}  // namespace talus::server::cluster
