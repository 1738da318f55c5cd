#include "fixtures.h"

#include <algorithm>

void talus_counted_work(const std::function<void()>& work) {
  work();
}

namespace talus::bench {

std::vector<std::int64_t> line(std::int64_t first, int count) {
  std::vector<std::int64_t> columns;
  for (int i = 0; i < count; ++i) columns.push_back(first + i);
  return columns;
}

std::vector<Chunk> mixed_chunks() {
  constexpr int kTiles = 4;
  const terrain::World& world = terrain::default_world();
  std::vector<Chunk> chunks;
  for (const std::int32_t place : {0, 40, 1000, -77}) {
    const terrain::Region patch{std::int64_t{place} * kChunkSize, std::int64_t{place} * kChunkSize,
                                kTiles * kChunkSize, kTiles * kChunkSize, Lod{}};
    const terrain::Stacks stacks = generate_stacks(world, patch);
    for (std::int32_t i = 0; i < kTiles * kTiles; ++i) {
      const std::int32_t x = place + i % kTiles;
      const std::int32_t z = place + i / kTiles;
      const terrain::MixedRange rows = mixed_range(world, stacks, x, z);
      for (std::int32_t y = rows.first; y <= rows.last; ++y) {
        chunks.push_back(extract_chunk(world, stacks, {x, y, z}));
      }
    }
  }
  std::erase_if(chunks, [](const Chunk& chunk) { return chunk.is_uniform(); });
  return chunks;
}

std::vector<terrain::Region> patches_of_view(int radius, int patch_tiles) {
  const int columns = patch_tiles * kChunkSize;
  const auto first = static_cast<int>(floor_div(-radius, patch_tiles));
  const auto last = static_cast<int>(floor_div(radius, patch_tiles));
  std::vector<terrain::Region> patches;
  for (int z = first; z <= last; ++z) {
    for (int x = first; x <= last; ++x) {
      patches.push_back({std::int64_t{x} * columns, std::int64_t{z} * columns, columns, columns, Lod{}});
    }
  }
  std::stable_sort(patches.begin(), patches.end(), [](const terrain::Region& a, const terrain::Region& b) {
    return a.x * a.x + a.z * a.z < b.x * b.x + b.z * b.z;
  });
  return patches;
}

}  // namespace talus::bench
