#include <algorithm>
#include <cassert>
#include <optional>
#include <tuple>
#include <utility>

#include <talus/local/local.h>
#include <talus/terrain/generator.h>
#include <talus/terrain/ground_cache.h>
#include <talus/terrain/heights.h>
#include <talus/terrain/stacks.h>

namespace talus::local {
namespace {

bool is_set(const std::atomic<bool>* cancel) {
  return cancel != nullptr && cancel->load(std::memory_order_relaxed);
}

std::int32_t patch_of(std::int32_t tile) {
  return static_cast<std::int32_t>(floor_div(tile, Workspace::kPatchTiles));
}

}  // namespace

struct Workspace::Memory {
  terrain::Generator generator;
  terrain::Stacks stacks;
  std::optional<Tiles> kept;  // that `stacks` holds
};

Workspace::Workspace(std::shared_ptr<const World> world, std::size_t ground_bytes)
    : world_{std::move(world)},
      memory_{new Memory{
          terrain::Generator{*world_, std::make_shared<terrain::GroundCache>(ground_bytes)}, {}, {}}} {
  assert(!world_->has_secrets());  // whose chunks need columns beyond the tiles
}
Workspace::~Workspace() = default;
Workspace::Workspace(Workspace&&) noexcept = default;
Workspace& Workspace::operator=(Workspace&&) noexcept = default;

bool Workspace::prepare(const Tiles& tiles, const std::atomic<bool>* cancel) {
  Memory& memory = *memory_;
  memory.kept.reset();
  const terrain::Region region{std::int64_t{tiles.x} * kChunkSize, std::int64_t{tiles.z} * kChunkSize,
                               tiles.width * kChunkSize, tiles.depth * kChunkSize, tiles.lod};
  memory.generator.start(region, std::move(memory.stacks));
  do {
    if (is_set(cancel)) return false;
  } while (memory.generator.step());
  memory.stacks = memory.generator.take();
  memory.kept = tiles;
  return true;
}

bool Workspace::prepare(ChunkKey key, const std::atomic<bool>* cancel) {
  if (memory_->kept && memory_->kept->holds(key.lod, key.coord.x, key.coord.z)) return true;
  return prepare(Tiles{patch_of(key.coord.x) * kPatchTiles, patch_of(key.coord.z) * kPatchTiles, kPatchTiles,
                       kPatchTiles, key.lod},
                 cancel);
}

terrain::MixedRange Workspace::rows(ChunkKey key) {
  prepare(key);
  return terrain::mixed_range(*world_, memory_->stacks, key.coord.x, key.coord.z);
}

const terrain::Stacks& Workspace::stacks() const {
  return memory_->stacks;
}

std::size_t generate(Workspace& workspace, std::span<const ChunkKey> keys, ChunkSink& sink,
                     const std::atomic<bool>* cancel) {
  std::vector<ChunkKey> ordered{keys.begin(), keys.end()};
  std::stable_sort(ordered.begin(), ordered.end(), [](const ChunkKey& a, const ChunkKey& b) {
    const auto place = [](const ChunkKey& key) {
      return std::tuple{key.lod, patch_of(key.coord.z), patch_of(key.coord.x)};
    };
    return place(a) < place(b);
  });
  std::size_t made = 0;
  Layers memory;  // of the chunk before
  for (const ChunkKey key : ordered) {
    if (is_set(cancel)) break;
    if (const auto material = terrain::uniform_everywhere(workspace.world(), key)) {
      sink.take(key, Chunk::uniform(*material));
    } else {
      if (!workspace.prepare(key, cancel)) break;
      Chunk chunk =
          terrain::extract_chunk(workspace.world(), workspace.stacks(), key.coord, std::move(memory));
      sink.take(key, chunk);
      memory = std::move(chunk).take_layers();
    }
    ++made;
  }
  return made;
}

std::vector<std::int32_t> heights(const World& world, const terrain::Region& region) {
  const terrain::Stacks stacks = terrain::generate_stacks(world, region);
  std::vector<std::int32_t> ground;
  ground.reserve(region.columns());
  for (int z = 0; z < region.depth; ++z) {
    for (int x = 0; x < region.width; ++x) ground.push_back(stacks.ground_fx(x, z));
  }
  return ground;
}

}  // namespace talus::local
