#include "edits/random_editor.h"

#include <cstdint>
#include <random>

namespace talus::server {

edits::EditorId random_editor() {
  std::random_device device;
  const auto half = [&] { return (std::uint64_t{device()} << 32) | device(); };
  return {half(), half()};
}

}  // namespace talus::server
