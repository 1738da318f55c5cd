#include "app/world_file.h"

#include <system_error>

#include <fmt/format.h>

#include <talus/height_files/height_files.h>
#include <talus/terrain/toml_bounds.h>

#include "store/read_file.h"

namespace talus::server {

tl::expected<std::shared_ptr<const terrain::World>, std::string> load_world(
    const std::filesystem::path& file) {
  if (file.empty()) return std::make_shared<const terrain::World>(terrain::default_world());

  const auto text = read_file(file, terrain::kMaxTomlBytes);
  if (!text) {
    return tl::make_unexpected(fmt::format("{}: cannot read the world: {}; give --world a readable TOML file",
                                           file.string(), std::generic_category().message(text.error())));
  }
  auto world = terrain::World::parse(*text, file.string(), height_files::beside(file));
  if (!world) return tl::make_unexpected(world.error().message);
  return std::make_shared<const terrain::World>(*std::move(world));
}

}  // namespace talus::server
