// Formats that messages of a stream may have. They are enabled in the stream's settings, not by the writers
// of messages: otherwise any writer could stop all servers with a message of a future format. FORMAT.md.
// Pure.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace talus::server::cluster {

/// Format that this talusd reads. Covers messages, their kinds, entries, their kinds, and codecs of pastes.
inline constexpr std::uint32_t kLogFormat = 1;

/// Messages from `from` on may have this format or any before it.
struct EnabledFormat {
  std::uint32_t number = 1;
  std::uint64_t from = 0;
  bool operator==(const EnabledFormat&) const = default;
};

struct EnabledFormats {
  static constexpr std::uint64_t kNever = std::numeric_limits<std::uint64_t>::max();

  std::vector<EnabledFormat> list;  // in addition to format 1; numbers and messages ascend
  bool understood = true;           // false: the description is unreadable, so any message may be newer
  bool operator==(const EnabledFormats&) const = default;

  /// First message that may have a format unknown to this talusd; kNever if there is not one.
  [[nodiscard]] std::uint64_t newer_from() const;
  [[nodiscard]] bool has_newer() const { return newer_from() != kNever; }
  /// True if an unreadable message may be of a newer format.
  [[nodiscard]] bool is_newer_at(std::uint64_t sequence) const { return sequence >= newer_from(); }
};

/// Parses a stream's description: "log format 2 from message 1000, 3 from message 5000". A malformed text
/// with that beginning is not understood; any other text means format 1.
[[nodiscard]] EnabledFormats enabled_formats(std::string_view description);

/// Formats the description; "log format 1" if nothing else is enabled. REQUIRES: enabled.understood.
[[nodiscard]] std::string to_string(const EnabledFormats& enabled);

}  // namespace talus::server::cluster
