#include "tops_of_edits.h"

#include <algorithm>
#include <string>
#include <utility>

#include <talus/terrain/extraction.h>
#include <talus/terrain/generator.h>
#include <talus/terrain/stacks.h>
#include <talus/voxel/chunk.h>

namespace talus::tools {

/// Top of one column, from above. `row` and `water_row` are the rows above it.
struct TopsOfEdits::ColumnTop {
  MaterialId ground = kAir;  // neither air nor water; air: not found yet
  std::int64_t row = 0;
  MaterialId water = kAir;
  std::int64_t water_row = 0;
  bool operator==(const ColumnTop&) const = default;
};

namespace {

/// nullopt if neither the world nor the store names it.
std::optional<terrain::MaterialKind> kind_of(const terrain::World& world,
                                             const std::vector<terrain::Material>& more,
                                             MaterialId material) {
  const std::size_t id = to_integer(material);
  if (id < world.materials().size()) return world.materials()[id].kind;
  const auto found = std::ranges::find(more, material, &terrain::Material::id);
  if (found == more.end()) return std::nullopt;
  return found->kind;
}

}  // namespace

std::vector<map::EditedTop> TopsOfEdits::find(const terrain::Region& region) const {
  std::vector<map::EditedTop> tops;
  const std::int64_t last_x = floor_div(region.x + region.width - 1, kChunkSize);
  const std::int64_t last_z = floor_div(region.z + region.depth - 1, kChunkSize);
  for (std::int64_t z = floor_div(region.z, kChunkSize); z <= last_z; ++z) {
    for (std::int64_t x = floor_div(region.x, kChunkSize); x <= last_x; ++x) {
      const auto key = checked_chunk(x, 0, z, region.lod);
      if (key && edits_.edited_rows(*key).size() > 0) add_tops(*key, region, tops);
    }
  }
  return tops;
}

void TopsOfEdits::add_tops(ChunkKey column, const terrain::Region& region,
                           std::vector<map::EditedTop>& tops) const {
  const VoxelPos origin = chunk_origin(column.coord);
  const terrain::Stacks stacks =
      generate_stacks(world_, {origin.x, origin.z, kChunkSize, kChunkSize, column.lod});
  const terrain::MixedRange mixed = mixed_range(world_, stacks, column.coord.x, column.coord.z);
  const ChunkRange edited = edits_.edited_rows(column);
  const auto top = std::max(mixed.last, static_cast<std::int32_t>(edited.last));
  // Below both there is only one rock.
  const auto bottom = std::min(mixed.first, static_cast<std::int32_t>(edited.first)) - 1;
  Column before(kChunkArea);
  Column after(kChunkArea);
  std::optional<MaterialId> unnamed;
  const auto merge = [&](Column& seen, const Chunk& chunk, std::int64_t y) {
    bool all = true;
    for (int i = 0; i < kChunkArea; ++i) {
      ColumnTop& one = seen[static_cast<std::size_t>(i)];
      if (one.ground != kAir) continue;
      const std::vector<Run> runs = chunk.runs(i % kChunkSize, i / kChunkSize);
      for (auto run = runs.rbegin(); run != runs.rend() && one.ground == kAir; ++run) {
        const auto kind = kind_of(world_, edits_.materials(), run->material);
        if (!kind) unnamed = run->material;
        if (kind == terrain::MaterialKind::air) continue;
        if (kind == terrain::MaterialKind::water) {
          if (one.water == kAir) {
            one.water = run->material;
            one.water_row = y + run->to;
          }
          continue;
        }
        one.ground = run->material;
        one.row = y + run->to;
      }
      all = all && one.ground != kAir;
    }
    return all;
  };
  bool before_done = false;
  bool after_done = false;
  for (std::int32_t row = top; row >= bottom && !(before_done && after_done); --row) {
    const ChunkKey key{{column.coord.x, row, column.coord.z}, column.lod};
    const Chunk chunk = extract_chunk(world_, stacks, key.coord);
    auto overrides = edits_.overrides(key);
    if (!overrides) {
      fail(std::move(overrides.error()));
      return;
    }
    const std::int64_t y = chunk_origin(key.coord).y;
    if (!before_done) before_done = merge(before, chunk, y);
    if (!after_done) after_done = merge(after, overrides->merged_over(chunk), y);
    if (unnamed) {
      fail({kExitFailed,
            "chunk " + to_string(key) + ": material " + std::to_string(to_integer(*unnamed)) +
                " has no name in the store; start talusd once with the store's world, which names it"});
      return;
    }
  }
  for (std::size_t i = 0; i < after.size(); ++i) {
    const std::int64_t x = origin.x + static_cast<std::int64_t>(i) % kChunkSize;
    const std::int64_t z = origin.z + static_cast<std::int64_t>(i) / kChunkSize;
    const bool inside =
        x >= region.x && x < region.x + region.width && z >= region.z && z < region.z + region.depth;
    const ColumnTop& seen = after[i];
    if (!inside || seen.ground == kAir || seen == before[i]) continue;
    tops.push_back({x, z, seen.ground, static_cast<std::int32_t>(seen.row), seen.water,
                    static_cast<std::int32_t>(seen.water_row)});
  }
}

void TopsOfEdits::fail(Failure failure) const {
  const std::lock_guard lock{mutex_};
  if (!failure_) failure_ = std::move(failure);
}

std::optional<Failure> TopsOfEdits::failure() const {
  const std::lock_guard lock{mutex_};
  return failure_;
}

}  // namespace talus::tools
