// A flow: all sessions of an address, or of a token's subject, whose traffic counts as one. Flows share
// scarce resources of the server (fair_queue.h), so that a client gains nothing by opening more connections.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace talus::server {

/// Stays the same while the process runs, also while the flow has no session.
enum class FlowId : std::uint64_t {};

/// Makes ids by a hash under a key of the process, so that a client cannot choose to share another's id.
/// Callable from any thread.
class FlowIds {
 public:
  /// Makes a random key.
  FlowIds();

  /// `counted`: the bytes of the address that count (net/admission.h).
  [[nodiscard]] FlowId of_address(std::span<const unsigned char> counted) const;
  /// `subject`: of a signed token, not empty.
  [[nodiscard]] FlowId of_subject(std::string_view subject) const;

 private:
  static constexpr std::size_t kKeyBytes = 192;  // XXH3's
  [[nodiscard]] FlowId hash(std::uint8_t kind, const void* data, std::size_t size) const;

  std::array<unsigned char, kKeyBytes> key_;
};

}  // namespace talus::server
