#include "generation/terrain_generator.h"

#include <utility>

namespace talus::server {
namespace {

MixedRows rows_of(const terrain::MixedRange& range) {
  return {range.first, range.last, range.below};
}

}  // namespace

TerrainGenerator::TerrainGenerator(std::shared_ptr<const terrain::World> world, int patch_tiles)
    : world_{std::move(world)}, patch_tiles_{patch_tiles} {
  // Every request looks here first, and working it out costs as much as a look into the cache.
  for (int level = 0; level <= Lod::kMax; ++level) {
    rows_anywhere_[static_cast<std::size_t>(level)] = rows_of(terrain::mixed_range(*world_, Lod::of(level)));
  }
  for (const terrain::Material& material : world_->materials()) {
    uniform_.push_back(encode_shared(Chunk::uniform(material.id)));
  }
}

EncodedChunkPtr TerrainGenerator::instant(ChunkKey key) const {
  const auto material = mixed_rows_anywhere(key.lod).uniform_at(key.coord.y);
  return material ? uniform(*material) : nullptr;
}

EncodedChunkPtr TerrainGenerator::uniform(MaterialId material) const {
  return uniform_[to_integer(material)];
}

MixedRows TerrainGenerator::mixed_rows_anywhere(Lod lod) const {
  return rows_anywhere_[static_cast<std::size_t>(lod.value())];
}

MixedRows TerrainGenerator::mixed_rows(const terrain::Stacks& stacks, ChunkKey key) const {
  return rows_of(terrain::mixed_range(*world_, stacks, key.coord.x, key.coord.z));
}

bool TerrainGenerator::make_patch(const PatchKey& patch, terrain::Stacks& stacks, const GoOn& go_on) const {
  std::unique_ptr<terrain::Generator> generator = take_generator();
  generator->start(region_of(patch, patch_tiles_), std::move(stacks));
  while (generator->step()) {
    if (!go_on()) return false;  // its memory goes, too: the next work is another's
  }
  stacks = generator->take();
  const std::lock_guard lock{idle_mutex_};
  idle_.push_back(std::move(generator));
  return true;
}

// There are as many as ever worked at once: their memory is worth keeping from patch to patch.
std::unique_ptr<terrain::Generator> TerrainGenerator::take_generator() const {
  const std::lock_guard lock{idle_mutex_};
  if (idle_.empty()) return std::make_unique<terrain::Generator>(*world_);
  auto generator = std::move(idle_.back());
  idle_.pop_back();
  return generator;
}

EncodedChunkPtr TerrainGenerator::make_chunk(const terrain::Stacks& stacks, ChunkKey key) const {
  // Each chunk is made in the memory of the one before it.
  thread_local Layers memory;
  Chunk chunk = terrain::extract_chunk(*world_, stacks, key.coord, std::move(memory));
  EncodedChunkPtr encoded = chunk.is_uniform() ? uniform(chunk.at({})) : encode_shared(chunk);
  memory = std::move(chunk).take_layers();
  return encoded;
}

std::optional<std::vector<std::int32_t>> TerrainGenerator::heights(
    std::span<const terrain::BaseColumn> columns, const GoOn& go_on) const {
  terrain::HeightsWork work{*world_, {columns.begin(), columns.end()}};
  while (work.step()) {
    if (!go_on()) return std::nullopt;
  }
  return work.take();
}

}  // namespace talus::server
