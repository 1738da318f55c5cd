#include "region_hash.h"

#include <xxhash.h>

#include <array>
#include <cstddef>
#include <memory>
#include <new>
#include <span>
#include <type_traits>
#include <vector>

#include <talus/terrain/extraction.h>
#include <talus/terrain/generator.h>
#include <talus/terrain/stacks.h>
#include <talus/tools/ordered_work.h>
#include <talus/tools/patch_grid.h>
#include <talus/voxel/codec.h>

namespace talus::tools {
namespace {

class Hasher {
 public:
  Hasher() : state_{XXH3_createState()} {
    if (!state_) throw std::bad_alloc{};
    XXH3_128bits_reset(state_.get());
  }

  void add(std::span<const std::byte> bytes) {
    XXH3_128bits_update(state_.get(), bytes.data(), bytes.size());
  }

  template <typename Integer>
  void add_number(Integer number) {
    std::array<std::byte, sizeof(Integer)> bytes{};
    auto rest = static_cast<std::make_unsigned_t<Integer>>(number);
    for (std::byte& byte : bytes) {
      byte = static_cast<std::byte>(rest & 0xFFU);
      rest >>= 8;
    }
    add(bytes);
  }

  [[nodiscard]] ContentHash digest() const {
    const XXH128_hash_t hash = XXH3_128bits_digest(state_.get());
    return {hash.low64, hash.high64};
  }

 private:
  struct Free {
    void operator()(XXH3_state_t* state) const { XXH3_freeState(state); }
  };
  std::unique_ptr<XXH3_state_t, Free> state_;
};

// A region in chunks instead of columns.
terrain::Region chunks_over(const terrain::Region& region) {
  const std::int64_t x = floor_div(region.x, kChunkSize);
  const std::int64_t z = floor_div(region.z, kChunkSize);
  const std::int64_t last_x = floor_div(region.x + region.width - 1, kChunkSize);
  const std::int64_t last_z = floor_div(region.z + region.depth - 1, kChunkSize);
  return {x, z, static_cast<int>(last_x - x + 1), static_cast<int>(last_z - z + 1), region.lod};
}

std::int32_t highest_chunk_row(const terrain::World& world, Lod lod) {
  const std::int64_t highest_voxel = highest_row(world, lod) - 1;
  return static_cast<std::int32_t>(floor_div(highest_voxel, kChunkSize));
}

ContentHash hash_column(const terrain::World& world, const terrain::Stacks& stacks, std::int32_t chunk_x,
                        std::int32_t chunk_z) {
  const Lod lod = stacks.region.lod;
  Hasher hasher;
  std::vector<std::byte> payload;
  const std::int32_t highest = highest_chunk_row(world, lod);
  for (std::int32_t chunk_y = -1; chunk_y <= highest; ++chunk_y) {
    payload.clear();
    encode(extract_chunk(world, stacks, {chunk_x, chunk_y, chunk_z}), payload);
    hasher.add_number(chunk_x);
    hasher.add_number(chunk_y);
    hasher.add_number(chunk_z);
    hasher.add_number(std::int32_t{lod.value()});
    hasher.add_number(static_cast<std::uint32_t>(payload.size()));
    hasher.add(payload);
  }
  return hasher.digest();
}

// z slowest, then x, in the patch.
std::vector<ContentHash> hash_patch(const terrain::World& world, const terrain::Region& chunks) {
  const terrain::Region columns{chunks.x * kChunkSize, chunks.z * kChunkSize, chunks.width * kChunkSize,
                                chunks.depth * kChunkSize, chunks.lod};
  const terrain::Stacks stacks = generate_stacks(world, columns);
  std::vector<ContentHash> hashes;
  for (std::int64_t z = chunks.z; z < chunks.z + chunks.depth; ++z) {
    for (std::int64_t x = chunks.x; x < chunks.x + chunks.width; ++x) {
      hashes.push_back(
          hash_column(world, stacks, static_cast<std::int32_t>(x), static_cast<std::int32_t>(z)));
    }
  }
  return hashes;
}

}  // namespace

ContentHash hash_region(const terrain::World& world, const terrain::Region& region,
                        const HashOptions& options, ProgressBar& progress) {
  const PatchGrid grid{chunks_over(region), options.patch_chunks};
  progress.expect(grid.region().columns());
  Hasher hasher;
  // Patches arrive row by row but the hash needs chunk row by chunk row, so a row of patches is buffered.
  std::vector<std::vector<ContentHash>> waiting;
  const auto feed_waiting = [&](int depth) {
    for (int z = 0; z < depth; ++z) {
      for (const auto& hashes : waiting) {
        const std::size_t width = hashes.size() / static_cast<std::size_t>(depth);
        for (const ContentHash hash : std::span{hashes}.subspan(static_cast<std::size_t>(z) * width, width)) {
          hasher.add_number(hash.low);
          hasher.add_number(hash.high);
        }
      }
    }
    waiting.clear();
  };
  const auto produce = [&](std::size_t index) { return hash_patch(world, grid.patch(index)); };
  work_in_order(grid.count(), thread_count(options.threads), produce,
                [&](std::size_t index, std::vector<ContentHash> hashes) {
                  progress.advance(hashes.size());
                  waiting.push_back(std::move(hashes));
                  if (waiting.size() == grid.across()) feed_waiting(grid.patch(index).depth);
                  return true;
                });
  return hasher.digest();
}

}  // namespace talus::tools
