#include "model.h"

#include <algorithm>
#include <memory>

#include <rapidcheck.h>

namespace talus::edits::testing {
namespace {

constexpr std::int64_t kWorldEnd = std::int64_t{1} << 36;

VoxelPos plus(VoxelPos a, VoxelPos b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}

std::int64_t within(std::int64_t first, std::int64_t last) {
  return *rc::gen::inRange<std::int64_t>(first, last + 1);
}

MaterialId any_material() {
  return MaterialId{static_cast<std::uint16_t>(within(0, 4))};
}

std::optional<MaterialId> maybe_material() {
  return *rc::gen::arbitrary<bool>() ? std::optional{any_material()} : std::nullopt;
}

/// Few voxels at few places, so that edits meet.
VoxelPos any_voxel() {
  const VoxelPos middle = *rc::gen::element<VoxelPos>(
      VoxelPos{0, 0, 0}, VoxelPos{-64, 32, 64}, VoxelPos{kWorldEnd - 50, kWorldEnd - 50, -kWorldEnd + 20});
  return plus(middle, {within(-8, 8), within(-8, 8), within(-8, 8)});
}

Fill any_fill() {
  const VoxelPos first = any_voxel();
  const VoxelPos last = plus(first, {within(0, 9), within(0, 9), within(0, 9)});
  return {first, last, maybe_material(), maybe_material()};
}

Paste any_paste() {
  const auto voxels = std::make_unique<DenseVoxels>();
  const auto seed = static_cast<std::uint32_t>(within(1, 1 << 20));
  for (std::size_t i = 0; i < voxels->size(); ++i) {
    const std::uint32_t mixed = (static_cast<std::uint32_t>(i) + seed) * 2654435761U;
    (*voxels)[i] = MaterialId{static_cast<std::uint16_t>(mixed >> 30)};
  }
  return {any_voxel(), Chunk::from_dense(*voxels), *rc::gen::arbitrary<bool>()};
}

}  // namespace

MaterialId base_at(VoxelPos voxel) {
  const auto mixed =
      static_cast<std::uint64_t>(voxel.x * 3 + voxel.y * 5 + voxel.z * 7) * 0x9E3779B97F4A7C15U;
  return MaterialId{static_cast<std::uint16_t>((mixed >> 60) % 5)};
}

BaseVoxels base_of(const Edit& edit) {
  BaseVoxels base;
  const auto touched = touched_voxels(edit);
  for (const TouchedChunk& each : touched.value()) {
    const VoxelPos origin = chunk_origin(each.chunk);
    for (const std::uint16_t index : each.voxels) {
      const VoxelPos voxel = plus(origin, {index % 32, index / 1024, index / 32 % 32});
      base[each.chunk].push_back({index, base_at(voxel)});
    }
  }
  return base;
}

MaterialId Model::at(VoxelPos voxel) const {
  const auto found = overrides_.find(voxel);
  return found == overrides_.end() ? base_at(voxel) : found->second;
}

Model::Result Model::apply(const Edit& edit) {
  for (std::size_t i = 0; i < edit.guards.size(); ++i) {
    if (at(edit.guards[i].voxel) != edit.guards[i].material) return {i, 0};
  }
  std::map<VoxelPos, MaterialId> before;
  const auto set = [&](VoxelPos voxel, MaterialId material) {
    before.emplace(voxel, at(voxel));
    if (material == base_at(voxel)) {
      overrides_.erase(voxel);
    } else {
      overrides_[voxel] = material;
    }
  };
  for (const VoxelWrite& write : edit.writes) set(write.voxel, write.material);
  for (const Fill& fill : edit.fills) {
    for (std::int64_t x = fill.first.x; x <= fill.last.x; ++x) {
      for (std::int64_t y = fill.first.y; y <= fill.last.y; ++y) {
        for (std::int64_t z = fill.first.z; z <= fill.last.z; ++z) {
          const VoxelPos voxel{x, y, z};
          if (fill.only && at(voxel) != *fill.only) continue;
          set(voxel, fill.material ? *fill.material : base_at(voxel));
        }
      }
    }
  }
  if (edit.paste) {
    for (std::uint8_t x = 0; x < 32; ++x) {
      for (std::uint8_t y = 0; y < 32; ++y) {
        for (std::uint8_t z = 0; z < 32; ++z) {
          const MaterialId material = edit.paste->voxels.at({x, y, z});
          if (material == kAir && !edit.paste->with_air) continue;
          set(plus(edit.paste->origin, {x, y, z}), material);
        }
      }
    }
  }
  Result result;
  for (const auto& [voxel, material] : before) result.changed += at(voxel) != material ? 1 : 0;
  return result;
}

const ChunkOverrides* State::find(ChunkKey chunk) const {
  const auto found = chunks.find(chunk);
  return found == chunks.end() ? nullptr : &found->second;
}

void State::commit(const StagingArea& staging) {
  hash = staging.hash();
  write(staging.chunks());
}

void State::write(const std::unordered_map<ChunkKey, StagedChunk>& staged) {
  for (const auto& [key, chunk] : staged) {
    ChunkOverrides overrides = chunk.after();
    if (overrides.empty()) {
      chunks.erase(key);
    } else {
      chunks.insert_or_assign(key, std::move(overrides));
    }
  }
}

std::map<VoxelPos, MaterialId> State::overrides(Lod lod) const {
  std::map<VoxelPos, MaterialId> all;
  for (const auto& [key, of_chunk] : chunks) {
    if (key.lod != lod) continue;
    for (const Override& each : of_chunk.voxels()) {
      const VoxelPos local{each.index % 32, each.index / 1024, each.index / 32 % 32};
      all.emplace(plus(chunk_origin(key.coord), local), each.material);
    }
  }
  return all;
}

Edit any_edit(const Model& model) {
  Edit edit;
  for (auto left = within(0, 2); left > 0; --left) {
    const VoxelPos voxel = any_voxel();
    // Mostly one that holds: edits that conflict show little else.
    const bool holds = within(0, 9) > 0;
    edit.guards.push_back({voxel, holds ? model.at(voxel) : any_material()});
  }
  for (auto left = within(0, 12); left > 0; --left) edit.writes.push_back({any_voxel(), any_material()});
  for (auto left = within(0, 2); left > 0; --left) edit.fills.push_back(any_fill());
  if (within(0, 9) == 0) {
    edit.paste = any_paste();
    // At the world's end a paste has no place.
    if (edit.paste->origin.x > kWorldEnd / 2) edit.paste->origin = {-5, -40, 13};
  }
  return edit;
}

}  // namespace talus::edits::testing
