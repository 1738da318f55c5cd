// The ground as seen from above, put together from chunks in whatever order they come.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <set>
#include <unordered_map>
#include <vector>

#include <tl/expected.hpp>

#include <talus/client/world_info.h>
#include <talus/voxel/chunk.h>
#include <talus/voxel/coords.h>

namespace talus::cli {

/// What lies on top of a base column.
struct SurfacePoint {
  std::int32_t top = 0;             // row of the topmost voxel that is not air
  std::int32_t ground = 0;          // row of the topmost solid voxel: lower than `top` under water
  MaterialId material{};            // of the topmost solid voxel
  std::optional<MaterialId> water;  // the topmost liquid, where one lies on it
};

/// Base columns from (x, z) on, `width` along x and `depth` along z.
struct Extent {
  std::int64_t x = 0;
  std::int64_t z = 0;
  std::int64_t width = 0;
  std::int64_t depth = 0;
};

/// The extent of that size around base column (x, z), or what says how it leaves the world.
[[nodiscard]] tl::expected<Extent, RangeError> extent_around(std::int64_t x, std::int64_t z,
                                                             std::int64_t width, std::int64_t depth);

class SurfaceMap {
 public:
  explicit SurfaceMap(const std::vector<client::Material>& materials);

  /// Takes in a chunk of level 0; those of other levels change nothing.
  void add(const ChunkKey& key, const Chunk& chunk);

  /// The surface at a column, if chunks have shown it: what is topmost, and that air lies above it.
  [[nodiscard]] std::optional<SurfacePoint> at(std::int64_t x, std::int64_t z) const;

  /// The chunk rows that hold nothing known yet above the topmost voxel seen in a chunk's columns: what
  /// to ask for next. None when the whole square of columns is known.
  [[nodiscard]] std::optional<std::int32_t> next_row_up(std::int32_t chunk_x, std::int32_t chunk_z) const;

  /// The smallest extent of whole chunks around all columns seen.
  [[nodiscard]] Extent extent() const;

 private:
  struct Square {
    std::set<std::int32_t> rows;  // chunk rows that have come
    std::array<std::int32_t, kChunkArea> top;
    std::array<std::int32_t, kChunkArea> ground;
    std::array<MaterialId, kChunkArea> material{};
    std::array<MaterialId, kChunkArea> topmost{};  // at `top`
  };
  static constexpr std::int32_t kNothing = INT32_MIN;

  [[nodiscard]] const Square* square(std::int32_t x, std::int32_t z) const;
  [[nodiscard]] client::Phase phase(MaterialId id) const;

  std::vector<client::Phase> phases_;
  std::unordered_map<ChunkKey, Square> squares_;  // by chunk with y = 0
};

}  // namespace talus::cli
