// Any bytes given as a height map: an error of one line, or a map whose samples fit its shape and scale to
// heights.
#include <cstdlib>
#include <iostream>
#include <optional>
#include <string_view>
#include <vector>

#include <talus/world_files/world_files.h>

#include "surface/scaled_heights.h"

namespace {

void require(bool holds, std::string_view what) {
  if (holds) return;
  std::cerr << "decode_height_map: " << what << '\n';
  std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace talus;
  // An exact copy on the heap, so that a read past the end is one past an allocation too.
  const auto* first = reinterpret_cast<const std::byte*>(data);
  const std::vector<std::byte> file(first, first + size);
  const auto map = world_files::decode_height_map(file);
  if (!map) {
    require(!map.error().empty(), "an error describes itself");
    return 0;
  }
  const std::size_t samples = std::visit([](const auto& all) { return all.size(); }, map->samples);
  require(map->width >= 2 && map->depth >= 2, "a map has two samples a side");
  require(samples == static_cast<std::size_t>(map->width) * static_cast<std::size_t>(map->depth),
          "a map has the samples of its shape");

  constexpr std::int32_t kHighest = 1 << 23;
  std::optional<double> low;
  std::optional<double> high;
  const auto heights = terrain::scaled_heights(*map, kHighest, low, high);
  if (!heights) {
    require(!heights.error().what.empty(), "an error describes itself");
    return 0;
  }
  for (const std::int32_t height : (*heights)->values) {
    require(height >= 0 && height <= kHighest, "a height lies between the floor and the highest summit");
  }
  return 0;
}
