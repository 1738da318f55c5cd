// Chunk, voxel and local coordinates as distinct types, levels of detail, and conversions between them. Pure
// values; every function may be called from any thread.
//
// Axes: x east, y up, z south. A voxel at level of detail l spans 2^l base voxels along each axis, and
// coordinates at level l count voxels (or chunks) of that level: column x at level l stands for base
// column x << l.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

#include <glm/vec3.hpp>
#include <tl/expected.hpp>

namespace talus {

inline constexpr int kChunkSize = 32;  // voxels along each edge of a chunk, at every level of detail
inline constexpr int kChunkArea = kChunkSize * kChunkSize;
inline constexpr int kChunkVolume = kChunkArea * kChunkSize;

/// A coordinate or level out of range. `message` names it and the range.
struct RangeError {
  std::string message;
};

/// Level of detail, 0 (base voxels) to 6 (one voxel spans 64 base voxels).
class Lod {
 public:
  static constexpr int kMax = 6;

  constexpr Lod() = default;  // level 0

  /// Fails if `level` is outside 0 to kMax; the error names the level.
  [[nodiscard]] static tl::expected<Lod, RangeError> checked(std::int64_t level);

  /// For levels computed by the program. REQUIRES: 0 <= level <= kMax (asserted).
  [[nodiscard]] static constexpr Lod of(int level) { return Lod{static_cast<std::uint8_t>(level)}; }

  [[nodiscard]] constexpr int value() const { return value_; }
  constexpr auto operator<=>(const Lod&) const = default;

 private:
  explicit constexpr Lod(std::uint8_t value) : value_{value} {}
  std::uint8_t value_ = 0;
};

/// Position of a chunk of 32^3 voxels, in chunks of some level of detail.
struct ChunkCoord {
  std::int32_t x = 0;
  std::int32_t y = 0;
  std::int32_t z = 0;
  constexpr auto operator<=>(const ChunkCoord&) const = default;
};

/// A chunk and its level of detail.
struct ChunkKey {
  ChunkCoord coord;
  Lod lod;
  constexpr auto operator<=>(const ChunkKey&) const = default;
};

/// Position of a voxel, in voxels of some level. 64 bits, because chunk 2^31 - 1 is voxel 2^36.
struct VoxelPos {
  std::int64_t x = 0;
  std::int64_t y = 0;
  std::int64_t z = 0;
  constexpr auto operator<=>(const VoxelPos&) const = default;
};

/// Position of a voxel inside its chunk; each component is 0 to 31.
struct LocalPos {
  std::uint8_t x = 0;
  std::uint8_t y = 0;
  std::uint8_t z = 0;
  constexpr auto operator<=>(const LocalPos&) const = default;
};

/// Quotient rounded towards minus infinity: floor_div(-1, 32) == -1. REQUIRES: divisor > 0.
[[nodiscard]] constexpr std::int64_t floor_div(std::int64_t dividend, std::int64_t divisor) {
  const std::int64_t quotient = dividend / divisor;
  return dividend % divisor < 0 ? quotient - 1 : quotient;
}

/// Remainder of floor_div(), 0 to divisor - 1: floor_mod(-1, 32) == 31. REQUIRES: divisor > 0.
[[nodiscard]] constexpr std::int64_t floor_mod(std::int64_t dividend, std::int64_t divisor) {
  const std::int64_t remainder = dividend % divisor;
  return remainder < 0 ? remainder + divisor : remainder;
}

/// Chunk coordinates at level l are -(2^31 >> l) to (2^31 >> l) - 1 along each axis, so that every level
/// covers the same endless plane.
[[nodiscard]] constexpr std::int64_t chunk_limit(Lod lod) {
  return (std::int64_t{1} << 31) >> lod.value();
}

/// Base voxel rows between which a world's ground meets its air: at every level everything below `low` is one
/// rock and everything from `high` up is air, except in the voxel row below the one that contains `low`.
struct HeightRange {
  std::int64_t low = 0;
  std::int64_t high = 0;
  constexpr bool operator==(const HeightRange&) const = default;
};

/// Maximum number of rows from `low` to `high` of a world. World files and servers that exceed it are
/// rejected, because a View with a horizon contains all rows.
inline constexpr std::int64_t kMaxWorldRows = std::int64_t{1} << 17;

/// True if a world may have these heights.
[[nodiscard]] constexpr bool is_height_range(HeightRange heights) {
  constexpr std::int64_t kEdge = (std::int64_t{1} << 31) * kChunkSize;
  return heights.low >= -kEdge && heights.high <= kEdge && heights.low <= heights.high &&
         heights.high - heights.low <= kMaxWorldRows;
}

/// Returns the chunk of `lod` at x, y, z, or an error that names the axis, the value and the range.
[[nodiscard]] tl::expected<ChunkKey, RangeError> checked_chunk(std::int64_t x, std::int64_t y, std::int64_t z,
                                                               Lod lod);

/// Returns the chunk that holds `voxel`, both at `lod`, or an error that names the axis out of range.
[[nodiscard]] tl::expected<ChunkKey, RangeError> chunk_holding(VoxelPos voxel, Lod lod);

/// Lowest corner of a chunk, in voxels of the chunk's own level.
[[nodiscard]] constexpr VoxelPos chunk_origin(ChunkCoord chunk) {
  return {std::int64_t{chunk.x} * kChunkSize, std::int64_t{chunk.y} * kChunkSize,
          std::int64_t{chunk.z} * kChunkSize};
}

/// Position of `voxel` in the chunk that holds it.
[[nodiscard]] constexpr LocalPos local_pos(VoxelPos voxel) {
  return {static_cast<std::uint8_t>(floor_mod(voxel.x, kChunkSize)),
          static_cast<std::uint8_t>(floor_mod(voxel.y, kChunkSize)),
          static_cast<std::uint8_t>(floor_mod(voxel.z, kChunkSize))};
}

/// Axis order of dense voxels everywhere: y slowest, then z, then x.
[[nodiscard]] constexpr std::size_t voxel_index(LocalPos pos) {
  return (std::size_t{pos.y} * kChunkSize + pos.z) * kChunkSize + pos.x;
}

/// Inverse of voxel_index(). REQUIRES: index < 32^3.
[[nodiscard]] constexpr LocalPos local_of(std::size_t index) {
  return {static_cast<std::uint8_t>(index % kChunkSize), static_cast<std::uint8_t>(index / kChunkArea),
          static_cast<std::uint8_t>(index / kChunkSize % kChunkSize)};
}
/// The voxel `local` of the chunk whose lowest corner is `origin`, both of level 0.
[[nodiscard]] constexpr VoxelPos voxel_at(VoxelPos origin, LocalPos local) {
  return {origin.x + local.x, origin.y + local.y, origin.z + local.z};
}

/// Axis order of a chunk's columns: z slowest, then x.
[[nodiscard]] constexpr std::size_t column_index(int x, int z) {
  return static_cast<std::size_t>(z) * kChunkSize + static_cast<std::size_t>(x);
}

/// Conversions for arithmetic between coordinates. Exact, without narrowing.
[[nodiscard]] constexpr glm::i64vec3 to_vec(ChunkCoord chunk) {
  return {chunk.x, chunk.y, chunk.z};
}
[[nodiscard]] constexpr glm::i64vec3 to_vec(VoxelPos voxel) {
  return {voxel.x, voxel.y, voxel.z};
}

/// "(x, y, z)" and "(x, y, z) at level of detail l", for messages.
[[nodiscard]] std::string to_string(ChunkCoord chunk);
[[nodiscard]] std::string to_string(ChunkKey key);

}  // namespace talus

template <>
struct std::hash<talus::ChunkKey> {
  std::size_t operator()(const talus::ChunkKey& key) const noexcept {
    // One multiply-xorshift round per 64 bits spreads neighbours over all buckets.
    const auto mix = [](std::uint64_t v) {
      v *= 0x9E3779B97F4A7C15U;
      return v ^ (v >> 32);
    };
    const auto half = [](std::int32_t v) { return std::uint64_t{static_cast<std::uint32_t>(v)}; };
    const std::uint64_t plane = mix((half(key.coord.x) << 32) | half(key.coord.z));
    const auto level = static_cast<std::uint64_t>(key.lod.value());
    return static_cast<std::size_t>(mix(plane ^ ((half(key.coord.y) << 8) | level)));
  }
};
