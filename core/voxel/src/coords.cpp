#include <talus/voxel/coords.h>

#include <string_view>
#include <utility>

namespace talus {
namespace {

std::string outside(std::string_view what, std::int64_t value, std::int64_t first, std::int64_t last) {
  std::string message{what};
  message.append(" is ").append(std::to_string(value));
  message.append("; it must lie in ").append(std::to_string(first));
  message.append(" to ").append(std::to_string(last));
  return message;
}

std::string at_level(Lod lod) {
  return " at level of detail " + std::to_string(lod.value());
}

}  // namespace

tl::expected<Lod, RangeError> Lod::checked(std::int64_t level) {
  if (level < 0 || level > kMax) {
    return tl::unexpected{RangeError{outside("level of detail", level, 0, kMax)}};
  }
  return Lod::of(static_cast<int>(level));
}

tl::expected<ChunkKey, RangeError> checked_chunk(std::int64_t x, std::int64_t y, std::int64_t z, Lod lod) {
  const std::int64_t limit = chunk_limit(lod);
  for (const auto& [axis, value] : {std::pair{'x', x}, std::pair{'y', y}, std::pair{'z', z}}) {
    if (value < -limit || value >= limit) {
      return tl::unexpected{
          RangeError{outside(std::string{"chunk "} + axis, value, -limit, limit - 1) + at_level(lod)}};
    }
  }
  return ChunkKey{{static_cast<std::int32_t>(x), static_cast<std::int32_t>(y), static_cast<std::int32_t>(z)},
                  lod};
}

tl::expected<ChunkKey, RangeError> chunk_holding(VoxelPos voxel, Lod lod) {
  const std::int64_t limit = chunk_limit(lod) * kChunkSize;
  for (const auto& [axis, value] :
       {std::pair{'x', voxel.x}, std::pair{'y', voxel.y}, std::pair{'z', voxel.z}}) {
    if (value < -limit || value >= limit) {
      return tl::unexpected{
          RangeError{outside(std::string{"voxel "} + axis, value, -limit, limit - 1) + at_level(lod)}};
    }
  }
  return checked_chunk(floor_div(voxel.x, kChunkSize), floor_div(voxel.y, kChunkSize),
                       floor_div(voxel.z, kChunkSize), lod);
}

std::string to_string(ChunkCoord chunk) {
  return "(" + std::to_string(chunk.x) + ", " + std::to_string(chunk.y) + ", " + std::to_string(chunk.z) +
         ")";
}

std::string to_string(ChunkKey key) {
  return to_string(key.coord) + at_level(key.lod);
}

}  // namespace talus
