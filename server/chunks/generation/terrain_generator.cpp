#include "chunks/generation/terrain_generator.h"

#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <talus/map/tile_painting.h>
#include <talus/pictures/png.h>
#include <talus/terrain/places.h>

namespace talus::server {
namespace {

class MutexLock final : public terrain::GroundLock {
 public:
  void lock() override { mutex_.lock(); }
  void unlock() override { mutex_.unlock(); }

 private:
  std::mutex mutex_;
};

MixedRows rows_of(const terrain::MixedRange& range) {
  return {range.first, range.last, range.below};
}

}  // namespace

TerrainGenerator::TerrainGenerator(std::shared_ptr<const terrain::World> world, int patch_tiles,
                                   std::size_t max_idle, std::size_t ground_bytes)
    : world_{std::move(world)},
      patch_tiles_{patch_tiles},
      max_idle_{max_idle},
      ground_{ground_bytes == 0
                  ? nullptr
                  : std::make_shared<terrain::GroundCache>(ground_bytes, std::make_unique<MutexLock>())},
      place_names_{terrain::place_names(*world_)} {
  idle_.reserve(max_idle);  // so that giving back never fails
  // Every request checks this first, and computing it costs as much as one cache lookup.
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

class TerrainGenerator::PatchOfWorld final : public PatchBuild {
 public:
  PatchOfWorld(const TerrainGenerator& owner, const PatchKey& patch, terrain::Stacks memory)
      : owner_{owner}, generator_{owner.take_generator()} {
    generator_->start(terrain::region_of_stacks(*owner.world_, region_of(patch, owner.patch_tiles_)),
                      std::move(memory));
  }
  [[nodiscard]] bool step() override { return generator_->step(); }
  // Work that is given up frees its memory: the next work belongs to another client.
  [[nodiscard]] terrain::Stacks take() override {
    terrain::Stacks stacks = generator_->take();
    owner_.give_back(std::move(generator_));
    return stacks;
  }

 private:
  const TerrainGenerator& owner_;
  std::unique_ptr<terrain::Generator> generator_;
};

class TerrainGenerator::HeightsOfWorld final : public HeightsBuild {
 public:
  HeightsOfWorld(const TerrainGenerator& owner, HeightsQuery query)
      : owner_{owner}, query_{std::move(query)}, work_{*owner.world_, query_.columns} {}
  [[nodiscard]] bool step() override { return work_.step(); }
  [[nodiscard]] HeightsResult take() override {
    HeightsResult found{.heights_fx = work_.take()};
    if (query_.looks || !query_.fields.empty()) add_places(found);
    return found;
  }

 private:
  void add_places(HeightsResult& found) const {
    std::vector<std::string> names;
    for (const std::uint8_t field : query_.fields) names.push_back(owner_.place_names_.at(field));
    terrain::PlaceValues places = terrain::places_at(*owner_.world_, query_.columns, names);
    if (query_.looks) found.looks = std::move(places.looks);
    found.values = std::move(places.values);
  }

  const TerrainGenerator& owner_;
  const HeightsQuery query_;
  terrain::HeightsWork work_;
};

class TerrainGenerator::MapOfWorld final : public HeightsBuild {
 public:
  MapOfWorld(const terrain::World& world, const map::Tile& tile) : painting_{std::in_place, world, tile} {}
  [[nodiscard]] bool step() override {
    if (painting_) {
      if (painting_->step()) return true;
      image_.emplace(painting_->take());
      painting_.reset();
      return true;
    }
    if (image_) {
      // The PNG takes as long as a step.
      auto png = pictures::encode_png({.width = image_->width, .height = image_->height, .rgb = image_->rgb});
      if (!png) throw std::runtime_error{png.error()};
      found_.picture =
          std::make_shared<const Picture>(Picture{{reinterpret_cast<const char*>(png->data()), png->size()}});
      image_.reset();
    }
    return false;
  }
  [[nodiscard]] HeightsResult take() override { return std::move(found_); }

 private:
  std::optional<map::TilePainting> painting_;
  std::optional<map::Image> image_;
  HeightsResult found_;
};

std::unique_ptr<PatchBuild> TerrainGenerator::start_patch(const PatchKey& patch,
                                                          terrain::Stacks memory) const {
  return std::make_unique<PatchOfWorld>(*this, patch, std::move(memory));
}

std::unique_ptr<HeightsBuild> TerrainGenerator::start_heights(HeightsQuery query) const {
  if (query.tile) return std::make_unique<MapOfWorld>(*world_, *query.tile);
  return std::make_unique<HeightsOfWorld>(*this, std::move(query));
}

std::unique_ptr<terrain::Generator> TerrainGenerator::take_generator() const {
  const std::lock_guard lock{idle_mutex_};
  if (idle_.empty()) return std::make_unique<terrain::Generator>(*world_, ground_);
  auto generator = std::move(idle_.back());
  idle_.pop_back();
  return generator;
}

void TerrainGenerator::give_back(std::unique_ptr<terrain::Generator> generator) const {
  const std::lock_guard lock{idle_mutex_};
  if (idle_.size() < max_idle_) idle_.push_back(std::move(generator));
}

EncodedChunkPtr TerrainGenerator::make_chunk(const terrain::Stacks& stacks, ChunkKey key) const {
  // Each chunk is made in the memory of the one before it.
  thread_local Layers memory;
  Chunk chunk = terrain::extract_chunk(*world_, stacks, key.coord, std::move(memory));
  EncodedChunkPtr encoded = chunk.is_uniform() ? uniform(chunk.at({})) : encode_shared(chunk);
  memory = std::move(chunk).take_layers();
  return encoded;
}

}  // namespace talus::server
