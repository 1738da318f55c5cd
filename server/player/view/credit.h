// Flow control of chunks: the number of bytes of Chunk frames that a client accepts before it gives more
// credit.
#pragma once

#include <cstdint>
#include <string>

#include <tl/expected.hpp>

namespace talus::server {

/// An impossible total; the connection must close.
struct CreditError {
  std::string message;
};

/// Invariant: taken <= sent. Both only grow.
class Credit {
 public:
  explicit Credit(std::uint64_t window_bytes) : window_bytes_{window_bytes} {}

  /// Returns true if a frame of any size may begin; it may overdraw the window.
  [[nodiscard]] bool may_send() const { return sent_bytes_ - taken_bytes_ < window_bytes_; }
  /// Removes the limit, as the client can no longer give credit.
  void lift() { window_bytes_ = UINT64_MAX; }
  void sent(std::uint64_t frame_bytes) { sent_bytes_ += frame_bytes; }

  /// The client's running total of bytes taken since the connection began.
  [[nodiscard]] tl::expected<void, CreditError> taken(std::uint64_t total_bytes);

 private:
  std::uint64_t window_bytes_;
  std::uint64_t sent_bytes_ = 0;
  std::uint64_t taken_bytes_ = 0;
};

}  // namespace talus::server
