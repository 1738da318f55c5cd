// Decides when memory that was freed is given back to the system: the allocator keeps it, since giving back
// costs more than an answer does. Not at once, as the next load would take it again; and not while much is
// still being freed or taken. For one thread.
#pragma once

#include <algorithm>
#include <cstdint>

namespace talus::server {

class TrimPolicy {
 public:
  /// A trim pays if this much less is in use than the maximum since the last one.
  static constexpr std::uint64_t kWorthBytes = std::uint64_t{16} << 20;
  /// A change of this much between two calls: the moment is not quiet.
  static constexpr std::uint64_t kQuietBytes = std::uint64_t{1} << 20;

  /// Call it about every second with the bytes in use. Returns true if it is time to trim.
  [[nodiscard]] bool due(std::uint64_t used_bytes) {
    const std::uint64_t change = used_bytes > last_ ? used_bytes - last_ : last_ - used_bytes;
    last_ = used_bytes;
    max_used_ = std::max(max_used_, used_bytes);
    if (max_used_ - used_bytes < kWorthBytes || change >= kQuietBytes) return false;
    max_used_ = used_bytes;
    return true;
  }

 private:
  std::uint64_t last_ = 0;
  std::uint64_t max_used_ = 0;  // since the last trim
};

}  // namespace talus::server
