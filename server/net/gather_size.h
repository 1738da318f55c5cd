// How much is written at once. What is gathered cannot be overtaken any more, so a client that takes it
// slowly soon gets little at a time; for one that takes it all at once, fewer calls of the system are worth
// more.
#pragma once

#include <algorithm>
#include <cstddef>

namespace talus::server {

class GatherSize {
 public:
  static constexpr std::size_t kLeast = std::size_t{16} * 1024;  // as much as the kernel keeps unsent
  static constexpr std::size_t kMost = std::size_t{64} * 1024;

  [[nodiscard]] std::size_t bytes() const { return bytes_; }

  /// So many bytes were written; `at_once`: the kernel took them in one piece.
  void wrote(std::size_t bytes, bool at_once) {
    if (!at_once) {
      bytes_ = std::max(kLeast, bytes_ / 2);
    } else if (bytes >= bytes_) {
      bytes_ = std::min(kMost, bytes_ * 2);
    }
  }

 private:
  std::size_t bytes_ = kLeast;
};

}  // namespace talus::server
