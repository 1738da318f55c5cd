#include "app/world_file.h"

#include <fmt/format.h>

#include <talus/files/secret_file.h>
#include <talus/toml/toml_bounds.h>
#include <talus/world_files/world_files.h>

namespace talus::server {

tl::expected<std::shared_ptr<const terrain::World>, std::string> load_world(
    const std::filesystem::path& file) {
  if (file.empty()) return std::make_shared<const terrain::World>(terrain::default_world());

  // Never blocks, even on a pipe.
  const auto read = files::SecretFile::read(file, kMaxTomlBytes);
  if (!read) {
    return tl::make_unexpected(
        fmt::format("world: {}: {}; give a TOML file that may be read", file.string(), read.error().reason));
  }
  auto world = terrain::World::parse(read->text(), file.string(), world_files::beside(file));
  if (!world) return tl::make_unexpected(world.error().message);
  return std::make_shared<const terrain::World>(*std::move(world));
}

}  // namespace talus::server
