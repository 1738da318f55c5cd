// Of which formats the messages of a stream may be. It is for whoever may change the stream to say, and not
// for those who write messages: else any of them could stop all servers by one of a format to come.
// FORMAT.md. Pure.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace talus::server::cluster {

/// Of messages, their kinds, entries, their kinds, and codecs of what they paste, all together: that which
/// this talusd reads.
inline constexpr std::uint32_t kLogFormat = 1;

/// Messages from `from` on may be of this format, and of all before it.
struct EnabledFormat {
  std::uint32_t number = 1;
  std::uint64_t from = 0;
  bool operator==(const EnabledFormat&) const = default;
};

struct EnabledFormats {
  static constexpr std::uint64_t kNever = std::numeric_limits<std::uint64_t>::max();

  std::vector<EnabledFormat> list;  // beside format 1; number and message rise
  bool understood = true;           // else it speaks of formats in another way, and any message may be newer
  bool operator==(const EnabledFormats&) const = default;

  /// The first message that may be of a format which this talusd does not read; kNever: none may.
  [[nodiscard]] std::uint64_t newer_from() const;
  [[nodiscard]] bool has_newer() const { return newer_from() != kNever; }
  /// Whether one that this talusd cannot read may be one for a newer talusd.
  [[nodiscard]] bool is_newer_at(std::uint64_t sequence) const { return sequence >= newer_from(); }
};

/// What a stream's description says: "log format 2 from message 1000, 3 from message 5000". What begins so
/// and goes on otherwise is not understood; any other text says format 1.
[[nodiscard]] EnabledFormats enabled_formats(std::string_view description);

/// As the description has it; "log format 1" where nothing else is enabled. REQUIRES: it is understood.
[[nodiscard]] std::string to_string(const EnabledFormats& enabled);

}  // namespace talus::server::cluster
