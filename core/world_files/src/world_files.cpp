#include <talus/world_files/world_files.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>
#include <vector>

#include "decoders.h"

namespace talus::world_files {
namespace {

// The largest map at four bytes a sample, and a header.
constexpr std::size_t kMaxHeightMapBytes = terrain::kMaxHeightMapSamples * 4 + (std::size_t{1} << 20);

// Models of the largest sizes; .vox files carry palettes and scene graphs, too.
constexpr std::size_t kMaxModelFileBytes = std::size_t{1} << 22;

tl::expected<std::vector<std::byte>, std::string> read_bytes(const std::filesystem::path& file,
                                                             std::size_t max_bytes) {
  std::error_code ignored;
  if (std::filesystem::is_directory(file, ignored)) return refused("is a directory");
  // A pipe may never end, and a device has no end.
  if (std::filesystem::exists(file, ignored) && !std::filesystem::is_regular_file(file, ignored)) {
    return refused("is not a regular file");
  }
  errno = 0;
  std::ifstream in{file, std::ios::binary};
  if (!in) return refused(std::string{"cannot read it: "} + std::strerror(errno));
  std::vector<std::byte> bytes;
  std::array<char, 1 << 16> block{};
  do {  // a file may have another size than it says, as those of /proc have
    in.read(block.data(), block.size());
    const auto read = std::as_bytes(std::span{block}).first(static_cast<std::size_t>(in.gcount()));
    bytes.insert(bytes.end(), read.begin(), read.end());
    if (bytes.size() > max_bytes) {
      return refused("has more than " + std::to_string(max_bytes) + " bytes");
    }
  } while (in);
  if (in.bad()) return refused(std::string{"cannot read it: "} + std::strerror(errno));
  return bytes;
}

}  // namespace

std::optional<std::string> wrong_size(std::uint64_t width, std::uint64_t depth) {
  const std::uint64_t longest = terrain::kMaxHeightMapSide;
  const bool fits = width >= 2 && depth >= 2 && width <= longest && depth <= longest &&
                    width * depth <= terrain::kMaxHeightMapSamples;
  if (fits) return std::nullopt;
  return "has " + std::to_string(width) + " x " + std::to_string(depth) + " samples; 2 to " +
         std::to_string(longest) + " a side and at most " + std::to_string(terrain::kMaxHeightMapSamples) +
         " in all";
}

tl::expected<terrain::HeightMap, std::string> decode_height_map(std::span<const std::byte> bytes) {
  if (is_png(bytes)) return decode_png(bytes);
  if (is_npy(bytes)) return decode_npy(bytes);
  return refused("is neither PNG nor .npy; a 16-bit greyscale PNG or an array of two axes is needed");
}

tl::expected<terrain::HeightMap, std::string> read_height_map(const std::filesystem::path& file) {
  const auto bytes = read_bytes(file, kMaxHeightMapBytes);
  if (!bytes) return refused(bytes.error());
  return decode_height_map(*bytes);
}

terrain::WorldFiles beside(const std::filesystem::path& world_file) {
  const std::filesystem::path folder = world_file.parent_path();
  using Models = tl::expected<std::vector<terrain::VoxelModel>, std::string>;
  return {[folder](const std::string& name) { return read_height_map(folder / name); },
          [folder](const std::string& name) -> Models {
            const auto bytes = read_bytes(folder / name, kMaxModelFileBytes);
            if (!bytes) return refused(bytes.error());
            return decode_vox(*bytes);
          }};
}

}  // namespace talus::world_files
