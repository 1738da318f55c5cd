#include "world_file.h"

#include <fstream>
#include <iterator>

#include <fmt/format.h>

namespace talus::server {

tl::expected<std::shared_ptr<const terrain::World>, std::string> load_world(
    const std::filesystem::path& file) {
  if (file.empty()) return std::make_shared<const terrain::World>(terrain::default_world());

  std::error_code ignored;
  std::ifstream in{file, std::ios::binary};
  if (!in.is_open() || std::filesystem::is_directory(file, ignored)) {
    return tl::make_unexpected(
        fmt::format("{}: cannot read the world; give --world a readable TOML file", file.string()));
  }
  const std::string text{std::istreambuf_iterator<char>{in}, {}};
  auto world = terrain::World::parse(text, file.string());
  if (!world) return tl::make_unexpected(world.error().message);
  return std::make_shared<const terrain::World>(*std::move(world));
}

}  // namespace talus::server
