// How many bytes of Chunk frames a client has room for.
#pragma once

#include <cstdint>
#include <string>

#include <tl/expected.hpp>

namespace talus::server {

/// A total that cannot be: the connection cannot go on.
struct CreditError {
  std::string message;
};

class Credit {
 public:
  explicit Credit(std::uint64_t window_bytes) : window_bytes_{window_bytes} {}

  /// Whether one more frame may go out, of any size: the last one may overdraw the window.
  [[nodiscard]] bool may_send() const { return sent_bytes_ - taken_bytes_ < window_bytes_; }
  void sent(std::uint64_t frame_bytes) { sent_bytes_ += frame_bytes; }

  /// The client says how many bytes it has taken since the connection began.
  [[nodiscard]] tl::expected<void, CreditError> taken(std::uint64_t total_bytes);

 private:
  std::uint64_t window_bytes_;
  std::uint64_t sent_bytes_ = 0;
  std::uint64_t taken_bytes_ = 0;  // never more than sent_bytes_
};

}  // namespace talus::server
