#include "app/secret_world.h"

#include <cstdint>
#include <utility>

#include "app/world_file.h"
#include "config/secret_layers.h"

namespace talus::server {
namespace {

terrain::SecretKey key_of(const KeyFile& file) {
  static_assert(terrain::kSecretKeyBytes == kSecretLayersKeyBytes);
  terrain::SecretKey key;
  for (std::size_t i = 0; i < kSecretLayersKeyBytes; ++i) {
    const std::uint64_t byte = static_cast<unsigned char>(file.secret.bytes()[i]);
    key.words[i / 8] |= byte << i % 8 * 8;
  }
  return key;
}

}  // namespace

tl::expected<std::shared_ptr<const terrain::World>, std::string> with_secrets(
    std::shared_ptr<const terrain::World> world, const std::optional<KeyFile>& key) {
  if (!key) return world;
  auto kept = world->with_secret_veins(key_of(*key));
  if (!kept) {
    return tl::make_unexpected(
        std::string{"secret.layers: the world has no [[veins]]; give its file some, or leave [secret] out"});
  }
  return std::make_shared<const terrain::World>(*std::move(kept));
}

tl::expected<std::shared_ptr<const terrain::World>, std::string> load_secret_world(
    const std::filesystem::path& file, const SecretLayers& settings) {
  const auto key = load_secret_key(settings);
  if (!key) return tl::make_unexpected(key.error());
  auto world = load_world(file);
  if (!world) return world;
  return with_secrets(*std::move(world), *key);
}

}  // namespace talus::server
