#include "section.h"

#include <algorithm>
#include <string>

#include <talus/terrain/stacks.h>
#include <catch2/catch.hpp>

#include "column_rows.h"
#include "worlds.h"

using namespace talus;
using namespace talus::tools;

namespace {

Image section_of(const terrain::Region& line, const SectionOptions& options = {}) {
  Progress progress{"section", "columns"};
  auto image = render_section(terrain::default_world(), line, options, progress);
  REQUIRE(image);
  return std::move(*image);
}

}  // namespace

TEST_CASE("The rows of a column are those of its chunks, caves and all") {
  struct Place {
    std::string world;
    std::int32_t chunk_x;
    std::int32_t chunk_z;
  };
  for (const Place& place : {Place{"default", -10, 20}, Place{"features", 11, -5}}) {
    const terrain::World& world = test::sample_world(place.world);
    const terrain::Stacks stacks =
        generate_stacks(world, {place.chunk_x * kChunkSize, place.chunk_z * kChunkSize, 32, 32, Lod{}});
    CHECK(stacks.caves.none() == (place.world == "default"));
    for (std::int32_t chunk_y = 0; chunk_y <= 3; ++chunk_y) {
      const Chunk chunk = extract_chunk(world, stacks, {place.chunk_x, chunk_y, place.chunk_z});
      for (int z = 0; z < kChunkSize; ++z) {
        for (int x = 0; x < kChunkSize; ++x) {
          std::vector<MaterialId> rows(kChunkSize, kAir);
          const std::int32_t bottom = chunk_y * kChunkSize;
          visit_column_rows(world, stacks, x, z, bottom, bottom + kChunkSize,
                            [&](MaterialId material, std::int32_t from, std::int32_t to) {
                              std::fill(rows.begin() + (from - bottom), rows.begin() + (to - bottom),
                                        material);
                            });
          for (int y = 0; y < kChunkSize; ++y) {
            const LocalPos pos{static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(y),
                               static_cast<std::uint8_t>(z)};
            REQUIRE(rows[static_cast<std::size_t>(y)] == chunk.at(pos));
          }
        }
      }
    }
  }
}

TEST_CASE("A section's scale enlarges voxels and nothing else") {
  const terrain::Region line{-40, 7, 80, 1, Lod{}};
  const Image plain = section_of(line);
  const Image large = section_of(line, {.scale = 3});
  REQUIRE(large.width == plain.width * 3);
  REQUIRE(large.height == plain.height * 3);
  // The lowest row is rock in both; the sky's gradient may differ.
  for (int x = 0; x < large.width; ++x) {
    CHECK(large.at(x, large.height - 1) == plain.at(x / 3, plain.height - 1));
  }
}

TEST_CASE("Sections along x and z through one column show the same column") {
  const Image along_x = section_of({100, 200, 1, 1, Lod{}});
  const Image along_z = section_of({100, 200, 1, 1, Lod{}}, {.threads = 2});
  CHECK(along_x.rgb == along_z.rgb);
  const Image southward = section_of({100, 190, 1, 20, Lod{}});
  const Image eastward = section_of({90, 200, 20, 1, Lod{}});
  for (int up = 1; up <= 8; ++up) {
    CHECK(southward.at(10, southward.height - up) == eastward.at(10, eastward.height - up));
  }
}
