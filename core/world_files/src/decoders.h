// Decoders of height maps, one function per format. Private to core/world_files.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include <tl/expected.hpp>

#include <talus/terrain/height_map.h>

namespace talus::world_files {

using DecodeResult = tl::expected<terrain::HeightMap, std::string>;

[[nodiscard]] inline tl::unexpected<std::string> refused(std::string what) {
  return tl::unexpected<std::string>{std::move(what)};
}

[[nodiscard]] bool is_png(std::span<const std::byte> bytes);
[[nodiscard]] DecodeResult decode_png(std::span<const std::byte> bytes);

/// REQUIRES: files::is_npy(bytes).
[[nodiscard]] DecodeResult decode_npy(std::span<const std::byte> bytes);

/// Returns the error of a claimed size, if any.
[[nodiscard]] std::optional<std::string> wrong_size(std::uint64_t width, std::uint64_t depth);

}  // namespace talus::world_files
