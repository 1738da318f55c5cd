// The ground seen from above, assembled from chunks in any order.
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

/// Top of a base column.
struct SurfacePoint {
  std::int32_t top = 0;             // row of the topmost voxel that is not air
  std::int32_t ground = 0;          // row of the topmost solid voxel: lower than `top` under water
  MaterialId material{};            // the topmost solid voxel's
  std::optional<MaterialId> water;  // the topmost liquid, if there is one above
};

/// Base columns from (x, z), `width` along x and `depth` along z.
struct Extent {
  std::int64_t x = 0;
  std::int64_t z = 0;
  std::int64_t width = 0;
  std::int64_t depth = 0;
};

/// The extent of this size around base column (x, z), or an error if it leaves the world.
[[nodiscard]] tl::expected<Extent, RangeError> extent_around(std::int64_t x, std::int64_t z,
                                                             std::int64_t width, std::int64_t depth);

class SurfaceMap {
 public:
  explicit SurfaceMap(const std::vector<client::Material>& materials);

  /// Adds a chunk of level 0; chunks of other levels are ignored.
  void add(const ChunkKey& key, const Chunk& chunk);

  /// The surface at a column, if chunks have shown its topmost voxel and air above it.
  [[nodiscard]] std::optional<SurfacePoint> at(std::int64_t x, std::int64_t z) const;

  /// The next unknown chunk row above the topmost voxels seen in a chunk's columns, to be requested next.
  /// nullopt if the whole square of columns is known.
  [[nodiscard]] std::optional<std::int32_t> next_row_up(std::int32_t chunk_x, std::int32_t chunk_z) const;

  /// The smallest extent of whole chunks around all columns seen.
  [[nodiscard]] Extent extent() const;

 private:
  struct Square {
    std::set<std::int32_t> rows;  // chunk rows received
    std::array<std::int32_t, kChunkArea> top;
    std::array<std::int32_t, kChunkArea> ground;
    std::array<MaterialId, kChunkArea> material{};
    std::array<MaterialId, kChunkArea> topmost{};  // material at `top`
  };
  static constexpr std::int32_t kNothing = INT32_MIN;

  [[nodiscard]] const Square* square(std::int32_t x, std::int32_t z) const;
  [[nodiscard]] client::Phase phase(MaterialId id) const;

  std::vector<client::Phase> phases_;
  std::unordered_map<ChunkKey, Square> squares_;  // by chunk with y = 0
};

}  // namespace talus::cli
