// A height map made by a formula, so that no file has to lie beside the tests that use it.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <talus/terrain/height_map.h>
#include <talus/terrain/lattice_hash.h>
#include <talus/terrain/world_files.h>

namespace talus::test {

/// Two hills, a cliff and a little roughness.
inline terrain::HeightMap made_height_map(int width = 29, int depth = 23) {
  std::vector<std::uint16_t> samples;
  for (int z = 0; z < depth; ++z) {
    for (int x = 0; x < width; ++x) {
      const auto hill = [&](int at_x, int at_z, int height) {
        return height / (1 + (x - at_x) * (x - at_x) + (z - at_z) * (z - at_z));
      };
      const std::uint32_t rough = terrain::mix32(static_cast<std::uint32_t>(z * width + x)) % 2500;
      const int height = 9000 + hill(width / 4, depth / 3, 200'000) / 5 +
                         hill(width / 2, depth / 2, 90'000) / 3 + (x + z > width ? 14000 : 0) +
                         static_cast<int>(rough);
      samples.push_back(static_cast<std::uint16_t>(height < 65535 ? height : 65535));
    }
  }
  terrain::HeightMap map;
  map.width = width;
  map.depth = depth;
  map.samples = std::move(samples);
  return map;
}

/// Gives the same map whatever the spec calls it.
inline terrain::LoadHeightMap made_height_maps() {
  return
      [](const std::string&) -> tl::expected<terrain::HeightMap, std::string> { return made_height_map(); };
}

}  // namespace talus::test
