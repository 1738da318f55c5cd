// Whose traffic counts as one: all sessions of an address, or of a token's subject. Flows take turns at what
// the server has little of, so that nobody gets more by opening more connections.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace talus::server {

/// Stays the same for as long as the process runs, also while the flow has no session.
enum class FlowId : std::uint64_t {};

/// Makes ids by a hash under a key of the process, so that nobody can choose to share another's. Callable
/// from any thread.
class FlowIds {
 public:
  /// With a key of its own, at random.
  FlowIds();

  /// `counted`: the bytes of the address that it counts as (net/admission.h).
  [[nodiscard]] FlowId of_address(std::span<const unsigned char> counted) const;
  /// `subject`: of a signed token, not empty.
  [[nodiscard]] FlowId of_subject(std::string_view subject) const;

 private:
  static constexpr std::size_t kKeyBytes = 192;  // of XXH3
  [[nodiscard]] FlowId hash(std::uint8_t kind, const void* data, std::size_t size) const;

  std::array<unsigned char, kKeyBytes> key_;
};

}  // namespace talus::server
