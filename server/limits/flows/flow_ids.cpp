#include "limits/flows/flow_ids.h"

#include <algorithm>
#include <limits>
#include <random>

#include <xxhash.h>

namespace talus::server {

FlowIds::FlowIds() {
  static_assert(kKeyBytes >= XXH3_SECRET_SIZE_MIN);
  std::random_device device;
  std::uniform_int_distribution<unsigned> byte{0, std::numeric_limits<unsigned char>::max()};
  std::generate(key_.begin(), key_.end(), [&] { return static_cast<unsigned char>(byte(device)); });
}

FlowId FlowIds::of_address(std::span<const unsigned char> counted) const {
  return hash(0, counted.data(), counted.size());
}

FlowId FlowIds::of_subject(std::string_view subject) const {
  return hash(1, subject.data(), subject.size());
}

// An address and a subject of the same bytes are two flows: each kind begins at a place of its own in the
// key.
FlowId FlowIds::hash(std::uint8_t kind, const void* data, std::size_t size) const {
  constexpr std::size_t kStep = 8;
  return FlowId{XXH3_64bits_withSecret(data, size, key_.data() + kind * kStep, kKeyBytes - kStep)};
}

}  // namespace talus::server
