#include <talus/edits/edit.h>

#include <algorithm>
#include <bitset>
#include <functional>
#include <iterator>
#include <optional>
#include <string_view>
#include <tuple>
#include <utility>

#include <talus/edits/settle.h>

#include "visit.h"

namespace talus::edits {
namespace {

using Refusal = tl::unexpected<EditError>;

Refusal refused(std::string message) {
  return Refusal{EditError{std::move(message)}};
}

std::string numbered(std::string_view what, std::size_t index) {
  return std::string{what} + " " + std::to_string(index);
}

tl::expected<void, EditError> check_in_world(std::string_view what, std::optional<std::size_t> index,
                                             VoxelPos voxel) {
  const auto held = chunk_holding(voxel, Lod{});
  if (held) return {};
  return refused((index ? numbered(what, *index) : std::string{what}) + ": " + held.error().message);
}

tl::expected<void, EditError> check_order(std::size_t index, const Fill& fill) {
  for (const auto& [axis, first, last] :
       {std::tuple{'x', fill.first.x, fill.last.x}, std::tuple{'y', fill.first.y, fill.last.y},
        std::tuple{'z', fill.first.z, fill.last.z}}) {
    if (first > last) {
      return refused(numbered("fill", index) + ": its first " + axis + " is " + std::to_string(first) +
                     ", its last " + std::to_string(last) + "; the first must not be greater");
    }
  }
  return {};
}

/// Number of voxels that the edit names, with repetitions, or an error if one lies outside the world.
tl::expected<std::size_t, EditError> count_voxels(const Edit& edit) {
  std::size_t count = edit.guards.size() + edit.writes.size();
  for (const auto& [name, list] : {std::pair{"guard", &edit.guards}, std::pair{"write", &edit.writes}}) {
    for (std::size_t i = 0; i < list->size(); ++i) {
      if (auto in = check_in_world(name, i, (*list)[i].voxel); !in) return Refusal{in.error()};
    }
  }
  for (std::size_t i = 0; i < edit.fills.size(); ++i) {
    for (const VoxelPos corner : {edit.fills[i].first, edit.fills[i].last}) {
      if (auto in = check_in_world("fill", i, corner); !in) return Refusal{in.error()};
    }
    if (auto ordered = check_order(i, edit.fills[i]); !ordered) return Refusal{ordered.error()};
    count += volume(edit.fills[i]);
  }
  if (edit.paste) {
    if (auto in = check_in_world("paste", {}, edit.paste->origin); !in) return Refusal{in.error()};
    if (auto in = check_in_world("paste", {}, last_of(*edit.paste)); !in) return Refusal{in.error()};
    visit_paste(*edit.paste, [&](VoxelPos, MaterialId) { ++count; });
  }
  return count;
}

/// Sorts indices and removes duplicates. A single box is sorted already; many indices go through a bitmap.
void put_in_order(std::vector<std::uint16_t>& indices) {
  constexpr std::size_t kMany = 512;  // about the cost of clearing and reading a bitmap
  if (std::ranges::adjacent_find(indices, std::greater_equal{}) == indices.end()) return;
  if (indices.size() < kMany) {
    std::ranges::sort(indices);
    indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
    return;
  }
  std::bitset<kChunkVolume> seen;
  for (const std::uint16_t index : indices) seen.set(index);
  indices.clear();
  for (std::size_t index = 0; index < seen.size(); ++index) {
    if (seen[index]) indices.push_back(static_cast<std::uint16_t>(index));
  }
}

/// Appends the chunks of a box, except one that was appended just before. Returns false, with nothing
/// appended, if the corners are not in order or not in the world.
bool add_chunks(VoxelPos first, VoxelPos last, std::vector<ChunkCoord>& chunks) {
  if (first.x > last.x || first.y > last.y || first.z > last.z) return false;
  if (!chunk_holding(first, Lod{}) || !chunk_holding(last, Lod{})) return false;
  const ChunkCoord low = chunk_of(first);
  const ChunkCoord high = chunk_of(last);
  // 64 bits: the coordinate of the world's last chunk is the maximum of 32 bits.
  for (std::int64_t y = low.y; y <= high.y; ++y) {
    for (std::int64_t z = low.z; z <= high.z; ++z) {
      for (std::int64_t x = low.x; x <= high.x; ++x) {
        const ChunkCoord chunk{static_cast<std::int32_t>(x), static_cast<std::int32_t>(y),
                               static_cast<std::int32_t>(z)};
        if (chunks.empty() || chunks.back() != chunk) chunks.push_back(chunk);
      }
    }
  }
  return true;
}

/// Sorts chunks and removes duplicates, without spare capacity.
void put_in_order(std::vector<ChunkCoord>& chunks) {
  std::ranges::sort(chunks);
  chunks.erase(std::unique(chunks.begin(), chunks.end()), chunks.end());
  chunks.shrink_to_fit();
}

/// Voxels by chunk. Neighbours are mostly in one chunk, so the last one is checked first.
class TouchedVoxels {
 public:
  explicit TouchedVoxels(std::vector<TouchedChunk> chunks = {}) : chunks_{std::move(chunks)} {}

  /// Returns false if there are more than kMaxChunks.
  bool insert(VoxelPos voxel) {
    const ChunkCoord chunk = chunk_of(voxel);
    if (last_ == chunks_.size() || chunks_[last_].chunk != chunk) {
      const auto at = std::ranges::lower_bound(chunks_, chunk, {}, &TouchedChunk::chunk);
      last_ = static_cast<std::size_t>(at - chunks_.begin());
      if (at == chunks_.end() || at->chunk != chunk) chunks_.insert(at, TouchedChunk{chunk, {}});
    }
    chunks_[last_].voxels.push_back(index_of(voxel));
    return chunks_.size() <= kMaxChunks;
  }

  std::vector<TouchedChunk> take() {
    for (TouchedChunk& each : chunks_) {
      put_in_order(each.voxels);
      each.voxels.shrink_to_fit();
    }
    return std::move(chunks_);
  }

 private:
  std::vector<TouchedChunk> chunks_;  // sorted
  std::size_t last_ = 0;
};

tl::expected<void, EditError> check_rows(const std::string& what, std::int64_t first, std::int64_t last,
                                         HeightRange rows) {
  const std::int64_t lowest = rows.low - kRowMargin;
  const std::int64_t highest = rows.high + kRowMargin;
  if (first >= lowest && last <= highest) return {};
  return refused(what + ": voxel y is " + std::to_string(first < lowest ? first : last) +
                 "; in this world it must lie in " + std::to_string(lowest) + " to " +
                 std::to_string(highest));
}

tl::expected<void, EditError> check_material(const std::string& what, MaterialId material,
                                             std::span<const MaterialId> materials) {
  if (std::ranges::binary_search(materials, material)) return {};
  return refused(what + ": material " + std::to_string(to_integer(material)) +
                 " is not in this world; it must be an id of its list of materials");
}

}  // namespace

std::size_t volume(const Fill& fill) {
  std::size_t product = 1;
  for (const auto& [first, last] :
       {std::pair{fill.first.x, fill.last.x}, std::pair{fill.first.y, fill.last.y},
        std::pair{fill.first.z, fill.last.z}}) {
    if (first > last) return 0;
    const std::uint64_t length = static_cast<std::uint64_t>(last) - static_cast<std::uint64_t>(first);
    // Each factor is at most 2^17, so the product cannot overflow.
    product *= std::min<std::uint64_t>(length, kMaxVoxels) + 1;
    product = std::min(product, kMaxVoxels + 1);
  }
  return product;
}

std::size_t named_voxels(const Edit& edit) {
  std::size_t voxels = edit.guards.size() + edit.writes.size() + (edit.paste ? kChunkVolume : 0);
  for (const Fill& fill : edit.fills) voxels += volume(fill);
  return voxels;
}

Extent extent_of(const Edit& edit, bool settles) {
  Extent extent{.voxels = named_voxels(edit)};
  if (extent.voxels > kMaxVoxels) return extent;
  std::vector<ChunkCoord> chunks;
  bool good = true;
  const auto add = [&](VoxelPos first, VoxelPos last) { good = good && add_chunks(first, last, chunks); };
  for (const auto* list : {&edit.guards, &edit.writes}) {
    for (const VoxelWrite& each : *list) add(each.voxel, each.voxel);
  }
  for (const Fill& each : edit.fills) add(each.first, each.last);
  if (edit.paste) add(edit.paste->origin, last_of(*edit.paste));
  put_in_order(chunks);
  if (!good || chunks.size() > kMaxChunks) return extent;
  extent.chunks = std::move(chunks);
  if (!settles || !(extent.loose = settle_box(edit))) return extent;
  std::vector<ChunkCoord> loose;
  (void)add_chunks(extent.loose->first, extent.loose->last, loose);
  put_in_order(loose);
  std::ranges::set_difference(loose, extent.chunks, std::back_inserter(extent.loose_chunks));
  return extent;
}

std::vector<ChunkCoord> chunks_beside(const Edit& edit, const Extent& extent) {
  if (extent.chunks.empty()) return {};
  std::vector<ChunkCoord> all;
  const auto add = [&](VoxelPos first, VoxelPos last) {
    for (const auto axis : {&VoxelPos::x, &VoxelPos::y, &VoxelPos::z}) {
      VoxelPos low = first;
      VoxelPos high = last;
      if (--(low.*axis); !chunk_holding(low, Lod{})) low = first;
      if (++(high.*axis); !chunk_holding(high, Lod{})) high = last;
      (void)add_chunks(low, high, all);
    }
    constexpr std::size_t kMany = 4'096;  // mostly repetitions: an edit has few chunks
    if (all.size() > kMany) put_in_order(all);
  };
  for (const auto* list : {&edit.guards, &edit.writes}) {
    for (const VoxelWrite& each : *list) add(each.voxel, each.voxel);
  }
  for (const Fill& each : edit.fills) add(each.first, each.last);
  if (edit.paste) add(edit.paste->origin, last_of(*edit.paste));
  if (extent.loose) add(extent.loose->first, extent.loose->last);
  put_in_order(all);
  const std::size_t own = extent.chunks.size() + extent.loose_chunks.size();
  std::erase_if(all, [&](ChunkCoord chunk) {
    return std::ranges::binary_search(extent.chunks, chunk) ||
           std::ranges::binary_search(extent.loose_chunks, chunk);
  });
  if (own + all.size() > kMaxChunks) all.resize(kMaxChunks - std::min(own, kMaxChunks));
  return all;
}

tl::expected<std::vector<TouchedChunk>, EditError> touched_voxels(const Edit& edit) {
  const auto count = count_voxels(edit);
  if (!count) return Refusal{count.error()};
  if (*count > kMaxVoxels) {
    return refused("edit: it names more than " + std::to_string(kMaxVoxels) +
                   " voxels; guards, writes, fills and paste count together");
  }
  TouchedVoxels touched;
  bool fits = true;
  for (const auto* list : {&edit.guards, &edit.writes}) {
    for (const VoxelWrite& each : *list) fits = fits && touched.insert(each.voxel);
  }
  for (const Fill& fill : edit.fills) {
    visit_box(fill.first, fill.last, [&](VoxelPos voxel) { fits = fits && touched.insert(voxel); });
  }
  if (edit.paste) {
    visit_paste(*edit.paste, [&](VoxelPos voxel, MaterialId) { fits = fits && touched.insert(voxel); });
  }
  if (!fits) {
    return refused("edit: it reaches more than " + std::to_string(kMaxChunks) +
                   " chunks; it must be divided");
  }
  return touched.take();
}

std::vector<TouchedChunk> with_settling(std::vector<TouchedChunk> touched,
                                        const std::optional<VoxelBox>& loose) {
  if (!loose) return touched;
  TouchedVoxels all{std::move(touched)};
  visit_box(loose->first, loose->last, [&](VoxelPos voxel) { (void)all.insert(voxel); });
  return all.take();
}

std::vector<TouchedChunk> with_neighbours(std::vector<TouchedChunk> touched) {
  TouchedVoxels all{touched};
  for (const TouchedChunk& each : touched) {
    for (const std::uint16_t index : each.voxels) {
      visit_beside(voxel_at(chunk_origin(each.chunk), local_of(index)), [&](VoxelPos voxel) {
        if (chunk_holding(voxel, Lod{})) (void)all.insert(voxel);
      });
    }
  }
  return all.take();
}

tl::expected<void, EditError> check(const Edit& edit, const EditRules& rules) {
  tl::expected<void, EditError> good;
  const auto voxel = [&](const std::string& what, const VoxelWrite& each) {
    return check_rows(what, each.voxel.y, each.voxel.y, rules.rows).and_then([&] {
      return check_material(what, each.material, rules.materials);
    });
  };
  for (std::size_t i = 0; good && i < edit.guards.size(); ++i) {
    good = voxel(numbered("guard", i), edit.guards[i]);
  }
  for (std::size_t i = 0; good && i < edit.writes.size(); ++i) {
    good = voxel(numbered("write", i), edit.writes[i]);
  }
  for (std::size_t i = 0; good && i < edit.fills.size(); ++i) {
    const Fill& fill = edit.fills[i];
    const std::string what = numbered("fill", i);
    good = check_rows(what, fill.first.y, fill.last.y, rules.rows);
    for (const auto& material : {fill.material, fill.only}) {
      if (good && material) good = check_material(what, *material, rules.materials);
    }
  }
  if (good && edit.paste) {
    good = check_rows("paste", edit.paste->origin.y, last_of(*edit.paste).y, rules.rows);
    visit_paste(*edit.paste, [&](VoxelPos, MaterialId material) {
      if (good) good = check_material("paste", material, rules.materials);
    });
  }
  return good;
}

}  // namespace talus::edits
