#include "app/world_file.h"

#include <utility>

#include <fmt/format.h>

#include <talus/files/secret_file.h>
#include <talus/toml/toml_bounds.h>
#include <talus/world_files/world_files.h>

namespace talus::server {
namespace {

struct SpecAndWorld {
  std::string spec;
  std::shared_ptr<const terrain::World> world;
};

tl::expected<SpecAndWorld, std::string> read_world(const std::filesystem::path& file,
                                                   const world_files::TakeFile& take = {}) {
  if (file.empty()) {
    return SpecAndWorld{std::string{terrain::default_world_toml()},
                        std::make_shared<const terrain::World>(terrain::default_world())};
  }
  // Never blocks, even on a pipe.
  const auto read = files::SecretFile::read(file, kMaxTomlBytes);
  if (!read) {
    return tl::make_unexpected(
        fmt::format("world: {}: {}; give a TOML file that may be read", file.string(), read.error().reason));
  }
  auto world = terrain::World::parse(read->text(), file.string(), world_files::beside(file, take));
  if (!world) return tl::make_unexpected(world.error().message);
  return SpecAndWorld{std::string{read->text()}, std::make_shared<const terrain::World>(*std::move(world))};
}

}  // namespace

tl::expected<std::shared_ptr<const terrain::World>, std::string> load_world(
    const std::filesystem::path& file) {
  return read_world(file).map([](SpecAndWorld&& read) { return std::move(read.world); });
}

tl::expected<ServedWorld, std::string> load_served_world(const Config& config) {
  ServedWorld served;
  if (config.publish != "public") {
    return load_world(config.world).map([](auto&& world) { return ServedWorld{std::move(world), {}, {}}; });
  }
  PublishedWorld published;
  auto read =
      read_world(config.world, [&](world_files::FileKind kind, const std::string& name, std::string&& bytes) {
        const bool large = kind == world_files::FileKind::height_map && bytes.size() > kMaxSmallMapBytes;
        if (large && !config.publish_files) {
          served.withheld = name;
        } else {
          published.files.emplace(name, std::move(bytes));
        }
      });
  if (!read) return tl::make_unexpected(read.error());
  served.world = std::move(read->world);
  published.spec = std::move(read->spec);
  if (served.withheld.empty())
    served.published = std::make_shared<const PublishedWorld>(std::move(published));
  return served;
}

}  // namespace talus::server
