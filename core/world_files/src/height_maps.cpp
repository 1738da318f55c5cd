// Height maps in memory.
#include <talus/files/npy_header.h>
#include <talus/world_files/world_files.h>

#include "decoders.h"

namespace talus::world_files {

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
  if (files::is_npy(bytes)) return decode_npy(bytes);
  return refused("is neither PNG nor .npy; a greyscale PNG or an array of two axes is needed");
}

}  // namespace talus::world_files
