#include "scene.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>

namespace talus::cli {
namespace {

constexpr int kChunkShift = 5;
constexpr double kPast = 1e-4;  // voxels beyond a boundary, to be on its other side

glm::ivec3 floored(const glm::dvec3& point) {
  return glm::ivec3{glm::floor(point)};
}

// A ray prepared for traversing grids, with everything that is the same in all cells.
struct Ray {
  glm::dvec3 from{};
  glm::dvec3 direction{};
  glm::dvec3 inverse{};  // 1 / direction; huge for 0, so that these walls are never reached
  glm::ivec3 step{};

  Ray(const glm::dvec3& from_, const glm::dvec3& direction_) : from{from_}, direction{direction_} {
    for (int axis = 0; axis < 3; ++axis) {
      const double along = direction[axis];
      inverse[axis] = std::abs(along) < 1e-12 ? 1e12 : 1.0 / along;
      step[axis] = along < 0 ? -1 : 1;
    }
  }

  [[nodiscard]] glm::dvec3 at(double distance) const { return from + direction * distance; }

  // Distances at which the ray leaves the box of edge `size` at `low`, by axis.
  [[nodiscard]] glm::dvec3 walls(const glm::ivec3& low, int size) const {
    glm::dvec3 walls;
    for (int axis = 0; axis < 3; ++axis) {
      const int wall = step[axis] > 0 ? low[axis] + size : low[axis];
      walls[axis] = (static_cast<double>(wall) - from[axis]) * inverse[axis];
      if (std::abs(inverse[axis]) >= 1e12) walls[axis] = std::numeric_limits<double>::max();
    }
    return walls;
  }
};

int nearest(const glm::dvec3& walls) {
  if (walls.x < walls.y) return walls.x < walls.z ? 0 : 2;
  return walls.y < walls.z ? 1 : 2;
}

glm::ivec3 face_met(const glm::dvec3& direction, int axis) {
  glm::ivec3 normal{0};
  normal[axis] = direction[axis] > 0 ? -1 : 1;
  return normal;
}

}  // namespace

std::int32_t Scene::Level::at(const glm::ivec3& cell) const {
  const glm::ivec3 local = cell - low;
  if (local.x < 0 || local.y < 0 || local.z < 0 || local.x >= size.x || local.y >= size.y ||
      local.z >= size.z) {
    return kUnknown;
  }
  return cells[static_cast<std::size_t>((local.y * size.z + local.z) * size.x + local.x)];
}

Scene::Scene(const client::ChunkStore& store, const std::vector<client::Material>& materials,
             VoxelPos centre) {
  solid_.assign(kMaterials, true);
  not_gas_.assign(kMaterials, true);
  for (const auto& material : materials) {
    solid_[to_integer(material.id)] = material.phase == client::Phase::solid;
    not_gas_[to_integer(material.id)] = material.phase != client::Phase::gas;
  }
  // A chunk corner of every level, so that cells of all levels begin at whole chunks.
  const std::int64_t grain = std::int64_t{kChunkSize} << Lod::kMax;
  origin_ = {floor_div(centre.x, grain) * grain, floor_div(centre.y, grain) * grain,
             floor_div(centre.z, grain) * grain};
  for (int level = 0; level <= Lod::kMax; ++level) add_level(store, Lod::of(level));
}

void Scene::add_level(const client::ChunkStore& store, Lod lod) {
  Level level;
  level.shift = kChunkShift + lod.value();
  const glm::i64vec3 shifted = to_vec(origin_) / (std::int64_t{kChunkSize} << lod.value());
  glm::ivec3 high{std::numeric_limits<int>::min()};
  level.low = glm::ivec3{std::numeric_limits<int>::max()};
  store.for_each([&](const client::ReceivedChunk& chunk) {
    if (chunk.key.lod != lod) return;
    const glm::ivec3 cell{to_vec(chunk.key.coord) - shifted};
    level.low = glm::min(level.low, cell);
    high = glm::max(high, cell);
  });
  if (high.x < level.low.x) return;
  level.size = high - level.low + 1;
  level.cells.assign(static_cast<std::size_t>(level.size.x) * static_cast<std::size_t>(level.size.y) *
                         static_cast<std::size_t>(level.size.z),
                     kUnknown);
  std::vector<MaterialId> voxels(kChunkVolume);
  store.for_each([&](const client::ReceivedChunk& chunk) {
    if (chunk.key.lod != lod) return;
    const glm::ivec3 local = glm::ivec3{to_vec(chunk.key.coord) - shifted} - level.low;
    auto& cell =
        level.cells[static_cast<std::size_t>((local.y * level.size.z + local.z) * level.size.x + local.x)];
    if (chunk.chunk->is_uniform()) {
      cell = -2 - to_integer(chunk.chunk->at({}));
      return;
    }
    cell = static_cast<std::int32_t>(chunks_.size());
    chunk.chunk->copy_to(std::span<MaterialId, kChunkVolume>{voxels});
    std::transform(voxels.begin(), voxels.end(), chunks_.emplace_back().begin(),
                   [](MaterialId id) { return to_integer(id); });
  });
  levels_.push_back(std::move(level));
}

Scene::CellContent Scene::find(const glm::ivec3& point) const {
  for (const Level& level : levels_) {
    const glm::ivec3 cell{point.x >> level.shift, point.y >> level.shift, point.z >> level.shift};
    const std::int32_t content = level.at(cell);
    if (content != kUnknown) return {&level, cell, content};
  }
  return {};
}

std::uint16_t Scene::material_in(const CellContent& found, const glm::ivec3& point) const {
  if (found.content < kUnknown) return static_cast<std::uint16_t>(-2 - found.content);
  const int voxel_shift = found.level->shift - kChunkShift;
  const auto local = [&](int at) {
    return static_cast<std::uint8_t>((at >> voxel_shift) & (kChunkSize - 1));
  };
  return voxel(found, {local(point.x), local(point.y), local(point.z)});
}

std::uint16_t Scene::voxel(const CellContent& found, const glm::ivec3& local) const {
  const auto index = (local.y * kChunkSize + local.z) * kChunkSize + local.x;
  return chunks_[static_cast<std::size_t>(found.content)][static_cast<std::size_t>(index)];
}

bool Scene::solid_at(const glm::ivec3& point) const {
  const CellContent found = find(point);
  return found.level != nullptr && solid_[material_in(found, point)];
}

std::optional<Hit> Scene::cast(const glm::dvec3& from, const glm::dvec3& direction, double reach,
                               Stop stop) const {
  const Ray ray{from, direction};
  const auto& stopping = stop == Stop::at_solid ? solid_ : not_gas_;
  double distance = 0;
  int axis = 1;  // along which the ray entered the current cell
  while (distance < reach) {
    const glm::ivec3 point = floored(ray.at(distance + kPast));
    const CellContent found = find(point);
    const int shift = found.level == nullptr ? kChunkShift : found.level->shift;
    const glm::ivec3 low{point.x >> shift << shift, point.y >> shift << shift, point.z >> shift << shift};
    const bool uniform = found.level == nullptr || found.content < kUnknown;
    if (uniform && (found.level == nullptr || !stopping[material_in(found, point)])) {
      const glm::dvec3 walls = ray.walls(low, 1 << shift);
      axis = nearest(walls);
      distance = std::max(walls[axis], distance + kPast);
      continue;
    }
    const int voxel_shift = shift - kChunkShift;
    const int size = 1 << voxel_shift;
    glm::ivec3 local{(point.x - low.x) >> voxel_shift, (point.y - low.y) >> voxel_shift,
                     (point.z - low.z) >> voxel_shift};
    glm::dvec3 walls = ray.walls(low + local * size, size);
    const glm::dvec3 across = glm::abs(ray.inverse) * static_cast<double>(size);
    while (distance < reach) {
      const std::uint16_t material = uniform ? material_in(found, point) : voxel(found, local);
      if (stopping[material]) {
        return Hit{distance, ray.at(distance), low + local * size, size, face_met(direction, axis), material};
      }
      axis = nearest(walls);
      distance = walls[axis];
      walls[axis] += across[axis];
      local[axis] += ray.step[axis];
      if (local[axis] < 0 || local[axis] >= kChunkSize) break;
    }
  }
  return std::nullopt;
}

}  // namespace talus::cli
