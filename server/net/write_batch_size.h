// Adapts the number of bytes gathered into one write. Newer output cannot overtake gathered bytes, so a slow
// client soon gets small batches; for a client that takes everything at once, fewer system calls matter more.
#pragma once

#include <algorithm>
#include <cstddef>

namespace talus::server {

class WriteBatchSize {
 public:
  static constexpr std::size_t kMin = std::size_t{16} * 1024;  // what the kernel keeps unsent
  static constexpr std::size_t kMax = std::size_t{64} * 1024;

  [[nodiscard]] std::size_t bytes() const { return bytes_; }

  /// A batch of `bytes` was written; `at_once`: the transport took it without waiting.
  void wrote(std::size_t bytes, bool at_once) {
    if (!at_once) {
      bytes_ = std::max(kMin, bytes_ / 2);
    } else if (bytes >= bytes_) {
      bytes_ = std::min(kMax, bytes_ * 2);
    }
  }

 private:
  std::size_t bytes_ = kMin;
};

}  // namespace talus::server
