#include <string_view>

#include <talus/local/local.h>
#include <talus/world_files/world_files.h>

namespace talus::local {
namespace {

// Decodes what `files` reads.
template <class Result>
auto decoded(const FileReader& files,
             tl::expected<Result, std::string> (*decode)(std::span<const std::byte>)) {
  return [files, decode](const std::string& name) -> tl::expected<Result, std::string> {
    const auto bytes = files(name);
    if (!bytes) return tl::unexpected(bytes.error());
    return decode(*bytes);
  };
}

tl::expected<std::vector<terrain::VoxelModel>, std::string> models_of(std::span<const std::byte> bytes) {
  return world_files::decode_vox(bytes);
}

}  // namespace

tl::expected<std::shared_ptr<const World>, SpecProblem> open_world(std::span<const std::byte> toml,
                                                                   const FileReader& files) {
  terrain::WorldFiles readers;
  if (files) readers = {decoded(files, world_files::decode_height_map), decoded(files, models_of)};
  auto world = World::parse({reinterpret_cast<const char*>(toml.data()), toml.size()}, "world.toml", readers);
  if (!world) return tl::unexpected(std::move(world).error());
  return std::make_shared<const World>(*std::move(world));
}

}  // namespace talus::local
