#include <talus/edits/evaluate.h>

#include <algorithm>
#include <string>
#include <utility>

#include "reveal.h"
#include "visit.h"

namespace talus::edits {
namespace {

/// Finds voxels by ascending index with doubling steps: cheap for neighbours, and for few voxels among many.
template <typename Voxel>
class VoxelCursor {
 public:
  explicit VoxelCursor(std::span<const Voxel> voxels) : left_{voxels} {}

  /// Null if not found. REQUIRES: `index` is not below the previous call's.
  const Voxel* find(std::uint16_t index) {
    std::size_t step = 1;
    while (step < left_.size() && left_[step].index < index) step *= 2;
    const auto near = left_.first(std::min(step, left_.size()));
    const auto at = std::ranges::lower_bound(near, index, {}, &Voxel::index);
    left_ = left_.subspan(static_cast<std::size_t>(at - near.begin()));
    return left_.empty() || left_.front().index != index ? nullptr : &left_.front();
  }

 private:
  std::span<const Voxel> left_;
};

/// The voxels of an edit in one chunk, with `after` still equal to `before`.
tl::expected<ChunkChanges, EditError> stage(const TouchedChunk& touched, const BaseVoxels& base,
                                            const OverrideSource& overrides) {
  ChunkChanges staged{touched.chunk, {}};
  staged.voxels.reserve(touched.voxels.size());
  const auto generated = base.find(touched.chunk);
  const ChunkKey key{touched.chunk, Lod{}};
  const ChunkOverrides* const changed = overrides.find(key);
  VoxelCursor of_base{generated == base.end() ? std::span<const Override>{} : std::span{generated->second}};
  VoxelCursor of_edits{changed == nullptr ? std::span<const Override>{} : changed->voxels()};
  VoxelCursor of_batch{overrides.staged(key)};
  for (const std::uint16_t index : touched.voxels) {
    const Override* const material = of_base.find(index);
    if (!material) {
      return tl::unexpected{EditError{"chunk " + to_string(touched.chunk) + ": the base of voxel " +
                                      std::to_string(index) +
                                      " is missing; an entry must hold the base of every voxel it touches"}};
    }
    MaterialId now = material->material;
    if (const OverrideWrite* const write = of_batch.find(index)) {
      now = write->material.value_or(now);
    } else if (const Override* const edited = of_edits.find(index)) {
      now = edited->material;
    }
    staged.voxels.push_back({index, now, now, material->material});
  }
  return staged;
}

/// Stages all of `touched`.
tl::expected<std::vector<ChunkChanges>, EditError> stage(std::span<const TouchedChunk> touched,
                                                         const BaseVoxels& base,
                                                         const OverrideSource& overrides) {
  std::vector<ChunkChanges> chunks;
  chunks.reserve(touched.size());
  for (const TouchedChunk& each : touched) {
    auto staged = stage(each, base, overrides);
    if (!staged) return tl::unexpected{std::move(staged.error())};
    chunks.push_back(std::move(*staged));
  }
  return chunks;
}

/// The staged voxels of an edit by position. Neighbours are mostly in one chunk, so the last one is checked
/// first.
class StagedVoxels {
 public:
  explicit StagedVoxels(std::vector<ChunkChanges>& chunks) : chunks_{chunks} {}

  VoxelChange& at(VoxelPos voxel) {
    const ChunkCoord chunk = chunk_of(voxel);
    if (last_ == nullptr || last_->chunk != chunk) {
      last_ = &*std::ranges::lower_bound(chunks_, chunk, {}, &ChunkChanges::chunk);
      next_ = 0;
    }
    std::vector<VoxelChange>& voxels = last_->voxels;
    const std::uint16_t index = index_of(voxel);
    if (next_ == voxels.size() || voxels[next_].index != index) {
      const auto found = std::ranges::lower_bound(voxels, index, {}, &VoxelChange::index);
      next_ = static_cast<std::size_t>(found - voxels.begin());
    }
    return voxels[next_++];
  }

 private:
  std::vector<ChunkChanges>& chunks_;
  ChunkChanges* last_ = nullptr;
  std::size_t next_ = 0;  // the voxel after the last one found, which operations mostly request next
};

void operate(const Edit& edit, StagedVoxels& staged) {
  for (const VoxelWrite& write : edit.writes) staged.at(write.voxel).after = write.material;
  for (const Fill& fill : edit.fills) {
    visit_box(fill.first, fill.last, [&](VoxelPos at) {
      VoxelChange& voxel = staged.at(at);
      if (!fill.only || voxel.after == *fill.only) voxel.after = fill.material.value_or(voxel.base);
    });
  }
  if (edit.paste) {
    visit_paste(*edit.paste, [&](VoxelPos at, MaterialId material) { staged.at(at).after = material; });
  }
}

/// Settles loose material in the box, all of which is staged.
void settle_in(const VoxelBox& box, const SettleRules& rules, StagedVoxels& staged) {
  std::vector<SettlingVoxel> voxels;
  voxels.reserve(kSettleVoxels);
  visit_box(box.first, box.last, [&](VoxelPos at) {
    const VoxelChange& voxel = staged.at(at);
    voxels.push_back({voxel.after, voxel.base, voxel.before != voxel.after});
  });
  if (settle(box, rules, voxels).moves == 0) return;
  auto settled = voxels.begin();
  visit_box(box.first, box.last, [&](VoxelPos at) { staged.at(at).after = (settled++)->now; });
}

void drop_unchanged(std::vector<ChunkChanges>& chunks) {
  for (ChunkChanges& each : chunks) {
    std::erase_if(each.voxels, [](const VoxelChange& voxel) { return voxel.before == voxel.after; });
  }
  std::erase_if(chunks, [](const ChunkChanges& each) { return each.voxels.empty(); });
}

/// True if `is` holds for a material that edits left in voxels `first` to `last` of the chunk.
template <typename Is>
bool any_edited(ChunkKey key, std::uint16_t first, std::uint16_t last, const OverrideSource& overrides,
                const Is& is) {
  const auto between = [&](auto voxels) {
    using Voxel = typename decltype(voxels)::value_type;
    const auto begin = std::ranges::lower_bound(voxels, first, {}, &Voxel::index);
    return voxels.subspan(
        static_cast<std::size_t>(begin - voxels.begin()),
        static_cast<std::size_t>(std::ranges::upper_bound(begin, voxels.end(), last, {}, &Voxel::index) -
                                 begin));
  };
  const auto staged = between(overrides.staged(key));
  const auto is_staged = [&](const OverrideWrite& write) { return write.material && is(*write.material); };
  if (std::ranges::any_of(staged, is_staged)) return true;
  const ChunkOverrides* const applied = overrides.find(key);
  if (applied == nullptr) return false;
  VoxelCursor rewritten{staged};
  return std::ranges::any_of(between(applied->voxels()), [&](const Override& each) {
    return is(each.material) && rewritten.find(each.index) == nullptr;
  });
}

/// True if anything may settle: something changed, and the voxels looked up for the edit, or edits on top of
/// them, contain material of the rules. Mostly there is no such material, and the box costs one read.
bool may_settle(const SettleRules& rules, std::span<const ChunkChanges> chunks, const BaseVoxels& base,
                const OverrideSource& overrides) {
  const auto is_loose = [&](MaterialId material) {
    return std::ranges::any_of(rules, [&](const SettleRule& rule) { return rule.material == material; });
  };
  bool any = false;
  bool loose = false;
  for (const ChunkChanges& chunk : chunks) {
    for (const VoxelChange& voxel : chunk.voxels) {
      any = any || voxel.before != voxel.after;
      loose = loose || is_loose(voxel.after);
    }
  }
  if (!any) return false;
  for (auto chunk = base.begin(); chunk != base.end() && !loose; ++chunk) {
    const std::vector<Override>& voxels = chunk->second;
    if (voxels.empty()) continue;
    MaterialId seen = kAir;  // neighbours are mostly equal
    for (auto voxel = voxels.begin(); voxel != voxels.end() && !loose; ++voxel) {
      if (voxel->material == seen) continue;
      seen = voxel->material;
      loose = is_loose(seen);
    }
    loose = loose ||
            any_edited({chunk->first, Lod{}}, voxels.front().index, voxels.back().index, overrides, is_loose);
  }
  return loose;
}

}  // namespace

std::vector<OverrideWrite> writes_of(const ChunkChanges& changes) {
  std::vector<OverrideWrite> writes;
  writes.reserve(changes.voxels.size());
  for (const VoxelChange& voxel : changes.voxels) {
    writes.push_back(OverrideWrite::of(voxel.index, voxel.after, voxel.base));
  }
  return writes;
}

tl::expected<Outcome, EditError> evaluate(const Edit& edit, const BaseVoxels& base,
                                          const OverrideSource& overrides, const SettleRules* settles,
                                          std::span<const TouchedChunk> touched,
                                          const SecretVoxels* secrets) {
  std::vector<TouchedChunk> found;
  if (touched.empty()) {
    auto of_edit = touched_voxels(edit);
    if (!of_edit) return tl::unexpected{std::move(of_edit.error())};
    touched = found = *std::move(of_edit);
  }
  auto chunks = stage(touched, base, overrides);
  if (!chunks) return tl::unexpected{std::move(chunks.error())};
  StagedVoxels voxels{*chunks};
  Outcome outcome;
  for (std::size_t i = 0; i < edit.guards.size(); ++i) {
    if (voxels.at(edit.guards[i].voxel).before == edit.guards[i].material) continue;
    outcome.conflict = i;
    return outcome;
  }
  operate(edit, voxels);
  if (settles != nullptr && may_settle(*settles, *chunks, base, overrides)) {
    if (const auto box = settle_box(edit)) {
      chunks = stage(with_settling({touched.begin(), touched.end()}, box), base, overrides);
      if (!chunks) return tl::unexpected{std::move(chunks.error())};
      StagedVoxels all{*chunks};
      operate(edit, all);
      settle_in(*box, *settles, all);
    }
  }
  drop_unchanged(*chunks);
  if (secrets != nullptr && !chunks->empty()) {
    reveal(*secrets, overrides, *chunks);
    drop_unchanged(*chunks);
  }
  for (const ChunkChanges& each : *chunks) outcome.changed += each.voxels.size();
  outcome.chunks = *std::move(chunks);
  return outcome;
}

}  // namespace talus::edits
