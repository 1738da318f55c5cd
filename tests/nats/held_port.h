// A TCP port of 127.0.0.1 that stays a test's own.
#pragma once

#include <cstdint>

namespace talus::nats_test {

/// While it lives the system gives the port to nobody, and nobody else who looks for a free one finds it. A
/// server that is told to listen there does, as nats-server and talusd let addresses be used again (Linux'
/// SO_REUSEADDR), and does so once more after it was killed.
class HeldPort {
 public:
  /// One that nobody has now. Throws std::runtime_error.
  HeldPort();
  ~HeldPort();
  HeldPort(HeldPort&& other) noexcept;
  HeldPort& operator=(HeldPort&& other) noexcept;

  [[nodiscard]] std::uint16_t number() const { return number_; }

 private:
  int fd_ = -1;  // bound, and does not listen
  std::uint16_t number_ = 0;
};

}  // namespace talus::nats_test
