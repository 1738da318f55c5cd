#include "config/secret_layers.h"

#include <utility>

#include <fmt/format.h>

namespace talus::server {

tl::expected<std::optional<KeyFile>, std::string> load_secret_key(const SecretLayers& settings) {
  if (settings.key_file.empty() && settings.layers.empty()) return std::nullopt;
  if (settings.key_file.empty()) {
    return tl::make_unexpected(
        std::string{"secret.layers: is set and key_file is not; set both, or neither"});
  }
  if (settings.layers.empty()) {
    return tl::make_unexpected(
        std::string{"secret.key_file: is set and layers is not; set both, or neither"});
  }
  auto key = read_key_file(settings.key_file, {kSecretLayersKeyBytes, kSecretLayersKeyBytes,
                                               "\"head -c 32 /dev/urandom\" prints", true});
  if (!key) return tl::make_unexpected(fmt::format("secret.key_file: {}", key.error()));
  return std::optional{*std::move(key)};
}

}  // namespace talus::server
