#include <talus/terrain/secret.h>

#include <algorithm>
#include <memory>
#include <utility>

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
  return hidden;
}

}  // namespace talus::terrain
