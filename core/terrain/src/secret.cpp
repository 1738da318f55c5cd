#include <talus/terrain/secret.h>

#include <algorithm>
#include <memory>
#include <utility>

#include <talus/terrain/boundary_row.h>
#include <talus/terrain/heights.h>
#include <talus/terrain/world.h>

#include "feature.h"
#include "features/sip_hash.h"

namespace talus::terrain {
namespace {

// Materials of the layers of rock, and those that provinces show in their place.
std::vector<bool> rock_of(const World& world) {
  std::vector<bool> rock(world.materials().size());
  for (std::size_t layer = 0; layer < world.spec().stratified.size(); ++layer) {
    const Material& material = world.materials()[2 + layer];
    rock[to_integer(material.id)] = true;
    if (const World::ShownBy* const shown = world.shown_by(material.id)) {
      for (const MaterialId id : shown->by_look) rock[to_integer(id)] = true;
    }
  }
  return rock;
}

// True if objects show rock, above the ground.
bool any_stands(const World& world, const std::vector<bool>& rock) {
  return std::any_of(world.features().begin(), world.features().end(), [&](const auto& feature) {
    for (std::size_t id = 0; id < rock.size(); ++id) {
      if (rock[id] && feature->places(MaterialId{static_cast<std::uint16_t>(id)})) return true;
    }
    return false;
  });
}

// The row of the chunk at which the ground of each column ends (column_index).
std::vector<std::int64_t> ground_rows(const World& world, ChunkCoord chunk) {
  const VoxelPos origin = chunk_origin(chunk);
  std::vector<BaseColumn> columns;
  for (int z = 0; z < kChunkSize; ++z) {
    for (int x = 0; x < kChunkSize; ++x) columns.push_back({origin.x + x, origin.z + z});
  }
  std::vector<std::int64_t> rows;
  for (const std::int32_t height_fx : surface_heights(world, columns)) {
    rows.push_back(boundary_row(height_fx) - origin.y);
  }
  return rows;
}

}  // namespace

std::optional<World> World::with_secret_veins(const SecretKey& key, SecretView view) const {
  const SipHash draw = SipHash{key.words[0], key.words[1]}.with(spec_.seed);
  const SipHash name = SipHash{key.words[2], key.words[3]}.with(fingerprint_.low).with(fingerprint_.high);
  World secret = *this;
  for (std::shared_ptr<const Feature>& feature : secret.features_) {
    auto kept = feature->kept_secret(draw, view);
    if (kept == nullptr) continue;
    feature = std::move(kept);
    secret.has_secrets_ = true;
  }
  if (!secret.has_secrets_) return std::nullopt;
  secret.fingerprint_ = {name.with(0).value(), name.with(1).value()};
  return secret;
}

std::vector<Override> hidden_ore(const World& world, ChunkCoord chunk, const Chunk& shown) {
  if (!world.has_secrets()) return {};
  const auto secret = std::make_unique<DenseVoxels>();
  bool any = false;
  for (const auto& feature : world.features()) any = feature->add_secret(chunk, *secret) || any;
  if (!any) return {};
  const auto voxels = std::make_unique<DenseVoxels>();
  shown.copy_to(*voxels);
  const std::vector<bool> rock = rock_of(world);
  std::vector<Override> hidden;
  for (std::size_t i = 0; i < kChunkVolume; ++i) {
    if ((*secret)[i] == kAir || !rock[to_integer((*voxels)[i])]) continue;
    hidden.push_back({static_cast<std::uint16_t>(i), (*secret)[i]});
  }
  if (hidden.empty() || !any_stands(world, rock)) return hidden;
  const std::vector<std::int64_t> rows = ground_rows(world, chunk);
  std::erase_if(hidden, [&](const Override& ore) {
    const LocalPos at = local_of(ore.index);
    return at.y >= rows[column_index(at.x, at.z)];
  });
  return hidden;
}

}  // namespace talus::terrain
