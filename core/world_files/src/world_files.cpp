#include <talus/world_files/world_files.h>

#include <algorithm>
#include <vector>

#include <talus/files/path_text.h>
#include <talus/files/read_file.h>

#include "decoders.h"

namespace talus::world_files {
namespace {

// The largest map at eight bytes per sample, and a header.
constexpr std::size_t kMaxHeightMapBytes = terrain::kMaxHeightMapSamples * 8 + (std::size_t{1} << 20);

// Models of the largest sizes; .vox files also contain palettes and scene graphs.
constexpr std::size_t kMaxModelFileBytes = std::size_t{1} << 22;

tl::expected<std::filesystem::path, std::string> path_of(const std::filesystem::path& folder,
                                                         const std::string& name) {
  const auto is_control = [](unsigned char c) { return c < 32 || c == 127; };
  if (std::any_of(name.begin(), name.end(), is_control)) return refused("has control characters in its name");
  // Worlds may be untrusted, and the files that they name are read.
  const std::filesystem::path path = files::to_path(name);
  if (path.has_root_path() || std::find(path.begin(), path.end(), "..") != path.end()) {
    return refused("is not below the world file's folder; a path from there without .. is needed");
  }
  return folder / path;
}

tl::expected<std::vector<terrain::VoxelModel>, std::string> models_of(std::span<const std::byte> bytes) {
  return decode_vox(bytes);
}

}  // namespace

tl::expected<terrain::HeightMap, std::string> read_height_map(const std::filesystem::path& file) {
  const auto bytes = files::read_regular_file(file, kMaxHeightMapBytes);
  if (!bytes) return refused(bytes.error().reason);
  return decode_height_map(std::as_bytes(std::span{*bytes}));
}

terrain::WorldFiles beside(const std::filesystem::path& world_file, const TakeFile& take) {
  const auto loader = [&]<class Result>(FileKind kind, std::size_t max_bytes,
                                        Result (*decode)(std::span<const std::byte>)) {
    return [folder = world_file.parent_path(), take, kind, max_bytes,
            decode](const std::string& name) -> Result {
      const auto file = path_of(folder, name);
      if (!file) return refused(file.error());
      auto bytes = files::read_regular_file(*file, max_bytes);
      if (!bytes) return refused(bytes.error().reason);
      Result decoded = decode(std::as_bytes(std::span{*bytes}));
      if (decoded && take) take(kind, name, *std::move(bytes));
      return decoded;
    };
  };
  return {terrain::LoadHeightMap{loader(FileKind::height_map, kMaxHeightMapBytes, decode_height_map)},
          terrain::LoadModels{loader(FileKind::model, kMaxModelFileBytes, models_of)}};
}

BytesOfFile bytes_beside(const std::filesystem::path& world_file) {
  return [folder = world_file.parent_path()](
             const std::string& name) -> tl::expected<std::vector<std::byte>, std::string> {
    const auto file = path_of(folder, name);
    if (!file) return refused(file.error());
    const auto text = files::read_regular_file(*file, kMaxHeightMapBytes);
    if (!text) return refused(text.error().reason);
    const auto bytes = std::as_bytes(std::span{*text});
    return std::vector<std::byte>{bytes.begin(), bytes.end()};
  };
}

}  // namespace talus::world_files
