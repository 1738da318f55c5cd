#include <talus/voxel/chunk.h>

#include <algorithm>
#include <cassert>
#include <cstring>

#include "slices.h"

namespace talus {
namespace {

using Plane = std::array<std::uint8_t, kChunkArea>;

constexpr Plane filled_plane(std::uint8_t row) {
  Plane plane{};
  for (std::uint8_t& top : plane) top = row;
  return plane;
}

constexpr Plane kFloor = filled_plane(0);
constexpr Plane kCeiling = filled_plane(kChunkSize);

bool equal(const std::uint8_t* a, const std::uint8_t* b) {
  return std::memcmp(a, b, kChunkArea) == 0;
}

bool all_equal(std::span<const MaterialId, kChunkVolume> voxels) {
  return std::equal(voxels.begin() + 1, voxels.end(), voxels.begin());
}

}  // namespace

bool Layers::valid() const {
  if (materials.empty() || materials.size() > kMaxMaterials) return false;
  if (tops.size() != plane_count() * kChunkArea) return false;
  bool in_order = true;
  for (std::size_t i = 0; i < tops.size(); ++i) {
    const std::uint8_t below = i < kChunkArea ? std::uint8_t{0} : tops[i - kChunkArea];
    in_order &= below <= tops[i] && tops[i] <= kChunkSize;
  }
  return in_order;
}

Chunk Chunk::uniform(MaterialId material) {
  return Chunk{Layers{{material}, {}}};
}

Chunk Chunk::from_layers(Layers layers) {
  assert(layers.valid());
  const std::size_t count = layers.materials.size();
  std::uint8_t* const tops = layers.tops.data();
  std::size_t kept = 0;                       // materials, each with its top in plane kept - 1
  const std::uint8_t* lower = kFloor.data();  // the top of the last material kept
  for (std::size_t i = 0; i < count; ++i) {
    const bool last = i + 1 == count;
    const std::uint8_t* const upper = last ? kCeiling.data() : tops + i * kChunkArea;
    if (equal(lower, upper)) continue;
    const bool joins = kept > 0 && layers.materials[kept - 1] == layers.materials[i];
    if (!joins) layers.materials[kept++] = layers.materials[i];
    if (last) break;
    std::uint8_t* const place = tops + (kept - 1) * kChunkArea;
    if (place != upper) std::memcpy(place, upper, kChunkArea);
    lower = place;
  }
  layers.materials.resize(kept);
  layers.tops.resize((kept - 1) * kChunkArea);
  return Chunk{std::move(layers)};
}

Chunk Chunk::from_dense(std::span<const MaterialId, kChunkVolume> voxels) {
  if (all_equal(voxels)) return uniform(voxels.front());
  auto dense = std::make_shared_for_overwrite<DenseVoxels>();
  std::copy(voxels.begin(), voxels.end(), dense->begin());
  return Chunk{Dense{std::move(dense)}};
}

Chunk Chunk::from_dense(std::shared_ptr<const DenseVoxels> voxels) {
  if (all_equal(*voxels)) return uniform(voxels->front());
  return Chunk{Dense{std::move(voxels)}};
}

Layers Chunk::take_layers() && {
  Layers* const layers = std::get_if<Layers>(&form_);
  return layers == nullptr ? Layers{} : std::move(*layers);
}

bool Chunk::is_uniform() const {
  return layers() != nullptr && layers()->plane_count() == 0;
}

MaterialId Chunk::at(LocalPos pos) const {
  assert(pos.x < kChunkSize && pos.y < kChunkSize && pos.z < kChunkSize);
  if (const auto* dense = std::get_if<Dense>(&form_)) return (**dense)[voxel_index(pos)];
  const Layers& stack = *layers();
  std::size_t place = column_index(pos.x, pos.z);
  std::size_t index = 0;
  for (; index < stack.plane_count() && stack.tops[place] <= pos.y; ++index) place += kChunkArea;
  return stack.materials[index];
}

std::vector<Run> Chunk::runs(int x, int z) const {
  assert(x >= 0 && x < kChunkSize && z >= 0 && z < kChunkSize);
  std::vector<Run> runs;
  const auto append = [&runs](MaterialId material, std::uint8_t to) {
    const std::uint8_t from = runs.empty() ? std::uint8_t{0} : runs.back().to;
    if (from == to) return;
    if (!runs.empty() && runs.back().material == material) {
      runs.back().to = to;
    } else {
      runs.push_back({material, from, to});
    }
  };
  if (const Layers* stack = layers()) {
    for (std::size_t i = 0; i < stack->plane_count(); ++i) {
      append(stack->materials[i], stack->plane(i)[column_index(x, z)]);
    }
    append(stack->materials.back(), kChunkSize);
    return runs;
  }
  for (std::uint8_t y = 0; y < kChunkSize; ++y) {
    append(at({static_cast<std::uint8_t>(x), y, static_cast<std::uint8_t>(z)}),
           static_cast<std::uint8_t>(y + 1));
  }
  return runs;
}

void Chunk::copy_to(std::span<MaterialId, kChunkVolume> voxels) const {
  if (const auto* dense = std::get_if<Dense>(&form_)) {
    std::copy((*dense)->begin(), (*dense)->end(), voxels.begin());
    return;
  }
  Slices slices{*layers()};
  for (std::size_t y = 0; y < kChunkSize; ++y) slices.next(voxels.data() + y * kChunkArea);
}

bool operator==(const Chunk& a, const Chunk& b) {
  if (a.is_uniform() && b.is_uniform()) return a.layers()->materials == b.layers()->materials;
  // A chunk of one material is always uniform, whichever way it was made.
  if (a.is_uniform() != b.is_uniform()) return false;
  if (a.layers() != nullptr && b.layers() != nullptr && a.layers()->materials == b.layers()->materials &&
      a.layers()->tops == b.layers()->tops) {
    return true;
  }
  const auto voxels = std::make_unique_for_overwrite<std::array<DenseVoxels, 2>>();
  a.copy_to((*voxels)[0]);
  b.copy_to((*voxels)[1]);
  return (*voxels)[0] == (*voxels)[1];
}

}  // namespace talus
