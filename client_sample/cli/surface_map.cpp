#include "surface_map.h"

#include <algorithm>
#include <limits>

namespace talus::cli {
namespace {

ChunkKey square_key(std::int32_t x, std::int32_t z) {
  return {{x, 0, z}, Lod{}};
}

}  // namespace

tl::expected<Extent, RangeError> extent_around(std::int64_t x, std::int64_t z, std::int64_t width,
                                               std::int64_t depth) {
  // The centre is checked before any arithmetic, which could overflow.
  const auto center = chunk_holding({x, 0, z}, Lod{});
  if (!center) return tl::unexpected{center.error()};
  const Extent extent{x - width / 2, z - depth / 2, width, depth};
  for (const VoxelPos corner :
       {VoxelPos{extent.x, 0, extent.z}, VoxelPos{extent.x + width - 1, 0, extent.z + depth - 1}}) {
    if (const auto inside = chunk_holding(corner, Lod{}); !inside) return tl::unexpected{inside.error()};
  }
  return extent;
}

SurfaceMap::SurfaceMap(const std::vector<client::Material>& materials) {
  for (const auto& material : materials) {
    const std::size_t id = to_integer(material.id);
    if (phases_.size() <= id) phases_.resize(id + 1, client::Phase::solid);
    phases_[id] = material.phase;
  }
}

client::Phase SurfaceMap::phase(MaterialId id) const {
  const std::size_t index = to_integer(id);
  return index < phases_.size() ? phases_[index] : client::Phase::solid;
}

void SurfaceMap::add(const ChunkKey& key, const Chunk& chunk) {
  if (key.lod != Lod{}) return;
  auto [place, added] = squares_.try_emplace(square_key(key.coord.x, key.coord.z));
  Square& square = place->second;
  if (added) {
    square.top.fill(kNothing);
    square.ground.fill(kNothing);
  }
  square.rows.insert(key.coord.y);
  if (chunk.is_uniform() && phase(chunk.at({})) == client::Phase::gas) return;
  const std::int32_t base = key.coord.y * kChunkSize;
  for (int z = 0; z < kChunkSize; ++z) {
    for (int x = 0; x < kChunkSize; ++x) {
      const std::size_t column = column_index(x, z);
      for (const Run& run : chunk.runs(x, z)) {
        if (phase(run.material) == client::Phase::gas) continue;
        const std::int32_t top = base + run.to - 1;
        if (top > square.top[column]) {
          square.top[column] = top;
          square.topmost[column] = run.material;
        }
        if (phase(run.material) == client::Phase::solid && top > square.ground[column]) {
          square.ground[column] = top;
          square.material[column] = run.material;
        }
      }
    }
  }
}

const SurfaceMap::Square* SurfaceMap::square(std::int32_t x, std::int32_t z) const {
  const auto found = squares_.find(square_key(x, z));
  return found == squares_.end() ? nullptr : &found->second;
}

std::optional<SurfacePoint> SurfaceMap::at(std::int64_t x, std::int64_t z) const {
  const auto chunk = chunk_holding({x, 0, z}, Lod{});
  if (!chunk) return std::nullopt;
  const Square* found = square(chunk->coord.x, chunk->coord.z);
  if (found == nullptr) return std::nullopt;
  const LocalPos local = local_pos({x, 0, z});
  const std::size_t column = column_index(local.x, local.z);
  const std::int32_t top = found->top[column];
  const std::int32_t ground = found->ground[column];
  if (ground == kNothing) return std::nullopt;
  const auto above = static_cast<std::int32_t>(floor_div(std::int64_t{top} + 1, kChunkSize));
  if (!found->rows.contains(above)) return std::nullopt;
  const auto water = top > ground ? std::optional{found->topmost[column]} : std::nullopt;
  return SurfacePoint{top, ground, found->material[column], water};
}

std::optional<std::int32_t> SurfaceMap::next_row_up(std::int32_t chunk_x, std::int32_t chunk_z) const {
  const Square* found = square(chunk_x, chunk_z);
  if (found == nullptr) return std::nullopt;
  const std::int32_t highest = *std::max_element(found->top.begin(), found->top.end());
  if (highest == kNothing) return std::nullopt;
  const auto above = static_cast<std::int32_t>(floor_div(std::int64_t{highest} + 1, kChunkSize));
  return found->rows.contains(above) ? std::nullopt : std::optional{above};
}

Extent SurfaceMap::extent() const {
  if (squares_.empty()) return {};
  std::int64_t low_x = std::numeric_limits<std::int64_t>::max();
  std::int64_t low_z = low_x;
  std::int64_t high_x = std::numeric_limits<std::int64_t>::min();
  std::int64_t high_z = high_x;
  for (const auto& [key, square] : squares_) {
    low_x = std::min<std::int64_t>(low_x, key.coord.x);
    low_z = std::min<std::int64_t>(low_z, key.coord.z);
    high_x = std::max<std::int64_t>(high_x, key.coord.x);
    high_z = std::max<std::int64_t>(high_z, key.coord.z);
  }
  return {low_x * kChunkSize, low_z * kChunkSize, (high_x - low_x + 1) * kChunkSize,
          (high_z - low_z + 1) * kChunkSize};
}

}  // namespace talus::cli
