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

// Searches from the top: the most frequent queries, voxels of objects, are in the air.
MaterialId material_in(const Layers& layers, std::size_t voxel) {
  const std::size_t row = voxel / kChunkArea;
  const std::size_t column = voxel % kChunkArea;
  std::size_t index = layers.plane_count();
  while (index > 0 && layers.tops[(index - 1) * kChunkArea + column] > row) --index;
  return layers.materials[index];
}

bool all_equal(std::span<const MaterialId, kChunkVolume> voxels) {
  return std::memcmp(voxels.data(), voxels.data() + 1, (kChunkVolume - 1) * sizeof(MaterialId)) == 0;
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
  std::size_t kept = 0;                       // materials; the top of each is in plane kept - 1
  const std::uint8_t* lower = kFloor.data();  // top of the last material kept
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

Chunk Chunk::with_overrides(std::span<const Override> overrides) const {
  assert(std::all_of(overrides.begin(), overrides.end(),
                     [](Override each) { return each.index < kChunkVolume; }));
  const auto densely = [&] {
    auto voxels = std::make_shared_for_overwrite<DenseVoxels>();
    copy_to(*voxels);
    for (const Override& each : overrides) (*voxels)[each.index] = each.material;
    return from_dense(std::shared_ptr<const DenseVoxels>{std::move(voxels)});
  };
  const Layers* const under = layers() != nullptr ? layers() : base();
  if (under == nullptr || overrides.size() > 4 * kMaxOverrides) return densely();

  std::vector<Override> all{this->overrides().begin(), this->overrides().end()};
  all.insert(all.end(), overrides.begin(), overrides.end());
  const auto before = [](Override a, Override b) { return a.index < b.index; };
  if (!std::is_sorted(all.begin(), all.end(), before)) std::stable_sort(all.begin(), all.end(), before);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const bool last = i + 1 == all.size() || all[i + 1].index != all[i].index;
    if (last && all[i].material != material_in(*under, all[i].index)) all[kept++] = all[i];
  }
  all.resize(kept);
  if (all.empty()) return Chunk{*under};
  // Only overrides with a common material can make the chunk uniform.
  const bool alike = std::all_of(all.begin(), all.end(),
                                 [&](Override each) { return each.material == all.front().material; });
  const bool material_is_under = std::find(under->materials.begin(), under->materials.end(),
                                           all.front().material) != under->materials.end();
  if (all.size() > kMaxOverrides || (alike && material_is_under)) {
    Chunk chunk = densely();
    if (all.size() > kMaxOverrides || chunk.is_uniform()) return chunk;
  }
  return Chunk{OverriddenLayers{*under, std::move(all)}};
}

const DenseVoxels* Chunk::dense() const {
  const auto* const dense = std::get_if<Dense>(&form_);
  return dense == nullptr ? nullptr : dense->get();
}

std::span<const Override> Chunk::overrides() const {
  const auto* const form = std::get_if<OverriddenLayers>(&form_);
  return form == nullptr ? std::span<const Override>{} : form->overrides;
}

const Layers* Chunk::base() const {
  const auto* const form = std::get_if<OverriddenLayers>(&form_);
  return form == nullptr ? nullptr : &form->base;
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
  const std::size_t index = voxel_index(pos);
  if (const DenseVoxels* voxels = dense()) return (*voxels)[index];
  const std::span changed = overrides();
  const auto found = std::lower_bound(changed.begin(), changed.end(), index,
                                      [](Override each, std::size_t at) { return each.index < at; });
  if (found != changed.end() && found->index == index) return found->material;
  return material_in(base() != nullptr ? *base() : *layers(), index);
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
  if (const DenseVoxels* all = dense()) {
    std::copy(all->begin(), all->end(), voxels.begin());
    return;
  }
  Slices slices{base() != nullptr ? *base() : *layers()};
  for (std::size_t y = 0; y < kChunkSize; ++y) slices.next(voxels.data() + y * kChunkArea);
  for (const Override& each : overrides()) voxels[each.index] = each.material;
}

bool operator==(const Chunk& a, const Chunk& b) {
  if (a.is_uniform() && b.is_uniform()) return a.layers()->materials == b.layers()->materials;
  // A chunk of one material is always held as uniform.
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
