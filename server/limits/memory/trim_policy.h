// When memory that was freed is worth giving back to the system: the allocator keeps it, since giving back
// costs more than an answer does. Not at once, as the next load would take it again; and not while much is
// still being freed or taken. One thread's.
#pragma once

#include <algorithm>
#include <cstdint>

namespace talus::server {

class TrimPolicy {
 public:
  /// So much less in use than at most since the last trim makes one worth its time.
  static constexpr std::uint64_t kWorthBytes = std::uint64_t{16} << 20;
  /// A change of so much between two calls is no quiet moment.
  static constexpr std::uint64_t kQuietBytes = std::uint64_t{1} << 20;

  /// Call it every second or so with the bytes in use. Whether to trim now.
  [[nodiscard]] bool due(std::uint64_t used_bytes) {
    const std::uint64_t change = used_bytes > last_ ? used_bytes - last_ : last_ - used_bytes;
    last_ = used_bytes;
    most_ = std::max(most_, used_bytes);
    if (most_ - used_bytes < kWorthBytes || change >= kQuietBytes) return false;
    most_ = used_bytes;
    return true;
  }

 private:
  std::uint64_t last_ = 0;
  std::uint64_t most_ = 0;  // since the last trim
};

}  // namespace talus::server
