#include "runtime/random_number.h"

#include <random>

namespace talus::server {

std::uint64_t random_number() {
  std::random_device device;
  return (std::uint64_t{device()} << 32U) | device();
}

}  // namespace talus::server
