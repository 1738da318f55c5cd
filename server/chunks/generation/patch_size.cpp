#include "chunks/generation/patch_size.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include <talus/terrain/extraction.h>
#include <talus/terrain/generator.h>
#include <talus/terrain/stacks.h>
#include <talus/voxel/codec.h>
#include <talus/voxel/coords.h>

#include "chunks/generation/generator_memory.h"

namespace talus::server {
namespace {

// Tiles that are measured: far apart, since erosion ends early if the ground is level. The first is measured
// again, as the first measurement warms the memory.
struct Place {
  std::int32_t x;
  std::int32_t z;
};
constexpr std::array<Place, 5> kPlaces{{{0, 0}, {0, 0}, {40, 24}, {-56, 72}, {88, -104}}};
constexpr std::chrono::milliseconds kEnough{100};  // of measuring
constexpr int kChunksMeasured = 3;                 // of a tile, from the highest down

std::uint64_t side_of(int tiles, int halo) {
  return static_cast<std::uint64_t>(tiles * kChunkSize + 2 * halo);
}

std::chrono::nanoseconds time_of(int tiles, std::chrono::nanoseconds tile_time, int halo) {
  const double tile = static_cast<double>(side_of(1, halo) * side_of(1, halo));
  const double patch = static_cast<double>(side_of(tiles, halo) * side_of(tiles, halo));
  return std::chrono::nanoseconds{
      static_cast<std::int64_t>(static_cast<double>(tile_time.count()) * patch / tile)};
}

}  // namespace

TileCost measure_tile(const terrain::World& world, const Clock& clock) {
  terrain::Generator generator{world};
  terrain::Stacks stacks;
  std::vector<std::byte> encoded;
  std::chrono::nanoseconds spent{};
  TileCost dearest;
  for (std::size_t i = 0; i < kPlaces.size() && spent < kEnough; ++i) {
    const auto [x, z] = kPlaces[i];
    const auto start = clock.thread_cpu();
    const terrain::Region tile{std::int64_t{x} * kChunkSize, std::int64_t{z} * kChunkSize, kChunkSize,
                               kChunkSize, Lod{}};
    generator.generate(terrain::region_of_stacks(world, tile), stacks);
    const auto made = clock.thread_cpu();
    const std::int32_t top = terrain::mixed_range(world, stacks, x, z).last;
    for (int below = 0; below < kChunksMeasured; ++below) {
      encode(terrain::extract_chunk(world, stacks, {x, top - below, z}), encoded);
    }
    const auto end = clock.thread_cpu();
    spent += end - start;
    if (i == 1) dearest = {};  // only the second measurement counts if it took long enough
    dearest.bytes = std::max(dearest.bytes, stacks.bytes());
    dearest.terrain = std::max(dearest.terrain, made - start);
    dearest.chunk = std::max(dearest.chunk, (end - made) / kChunksMeasured);
  }
  return dearest;
}

std::size_t PatchSize::bytes_in_the_making() const {
  constexpr std::size_t kBytesAColumn = 64;  // measured: 54 with 64 steps of erosion
  return side_of(tiles, halo) * side_of(tiles, halo) * kBytesAColumn;
}

std::size_t PatchSize::bytes_at_work() const {
  const auto each = static_cast<std::size_t>(tiles) * static_cast<std::size_t>(tiles) * tile_bytes;
  return std::max(bytes_in_the_making(), GeneratorMemory::kPatchesAtWork * each);
}

std::uint64_t PatchSize::ns_a_column() const {
  return static_cast<std::uint64_t>(patch_time.count()) / (side_of(tiles, 0) * side_of(tiles, 0));
}

bool PatchSize::chunks_expensive() const {
  return chunk_time > kChunkTime;
}

PatchSize patch_size(int tiles, std::chrono::nanoseconds tile_time, int halo) {
  return {tiles, tile_time, time_of(tiles, tile_time, halo),
          time_of(kMaxChosenTiles, tile_time, halo) > kPatchTime, halo};
}

PatchSize choose_patch_size(std::chrono::nanoseconds tile_time, int halo) {
  const auto allowed = std::max<std::chrono::nanoseconds>(kPatchTime, 2 * tile_time);
  int tiles = kMaxChosenTiles;
  while (tiles > 1 && time_of(tiles, tile_time, halo) > allowed) tiles /= 2;
  return patch_size(tiles, tile_time, halo);
}

PatchSize reduced_to(std::size_t max_bytes, const PatchSize& size) {
  PatchSize reduced = size;
  while (reduced.bytes_at_work() > max_bytes && reduced.tiles > 1) {
    PatchSize fewer = reduced;
    fewer.tiles /= 2;
    fewer.patch_time = time_of(fewer.tiles, size.tile_time, size.halo);
    fewer.reduced = true;
    // If even that does not fit it exceeds the limit by less.
    if (fewer.ns_a_column() > 2 * size.ns_a_column()) break;
    reduced = fewer;
  }
  return reduced;
}

}  // namespace talus::server
