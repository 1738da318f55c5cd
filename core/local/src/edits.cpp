#include <talus/local/edits.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <utility>

#include <talus/edits/levels.h>
#include <talus/edits/runs.h>
#include <talus/edits/staging.h>
#include <talus/local/settle_rules.h>
#include <talus/terrain/extraction.h>

namespace talus::local {
namespace {

// Reads the generated materials of voxels.
class BaseReader final : public ChunkSink {
 public:
  explicit BaseReader(std::span<const edits::TouchedChunk> touched) {
    for (const edits::TouchedChunk& each : touched) voxels_.emplace(each.chunk, each.voxels);
  }
  void take(ChunkKey key, const Chunk& chunk) override {
    std::vector<Override>& of_chunk = base[key.coord];
    for (const std::uint16_t index : voxels_.at(key.coord)) {
      of_chunk.push_back({index, chunk.at(local_of(index))});
    }
  }
  edits::BaseVoxels base;

 private:
  std::map<ChunkCoord, std::span<const std::uint16_t>> voxels_;
};

edits::BaseVoxels base_of(Workspace& workspace, std::span<const edits::TouchedChunk> touched) {
  std::vector<ChunkKey> keys;
  keys.reserve(touched.size());
  for (const edits::TouchedChunk& each : touched) keys.push_back({each.chunk, Lod{}});
  BaseReader reader{touched};
  generate(workspace, keys, reader);
  return std::move(reader.base);
}

// The writes that make `after` of `before`, both by ascending index.
std::vector<edits::OverrideWrite> difference(std::span<const Override> before,
                                             std::span<const Override> after) {
  std::vector<edits::OverrideWrite> writes;
  auto old = before.begin();
  for (const Override& voxel : after) {
    for (; old != before.end() && old->index < voxel.index; ++old) writes.push_back({old->index, {}});
    const bool had = old != before.end() && old->index == voxel.index;
    if (!had || old->material != voxel.material) writes.push_back({voxel.index, voxel.material});
    if (had) ++old;
  }
  for (; old != before.end(); ++old) writes.push_back({old->index, {}});
  return writes;
}

tl::unexpected<edits::EditError> refused(ChunkCoord chunk, const std::string& what) {
  return tl::unexpected{edits::EditError{"edits of chunk " + to_string(chunk) + ": " + what}};
}

}  // namespace

MaterialId placeable_id(std::size_t index) {
  return MaterialId{static_cast<std::uint16_t>(edits::kFirstBound + index)};
}

std::optional<std::vector<MaterialId>> placeable_ids(const World& world, const edits::MaterialIds& known) {
  std::vector<std::string> names;
  for (const terrain::Placeable& placeable : world.placeables()) names.push_back(placeable.name);
  const auto named = edits::ids_for(names, known);
  if (!named) return std::nullopt;
  std::vector<MaterialId> ids;
  for (const auto& [name, id] : *named) ids.push_back(id);
  return ids;
}

std::optional<edits::MaterialIds> material_ids(const World& world, const edits::MaterialIds& known) {
  const auto placeables = placeable_ids(world, known);
  if (!placeables) return std::nullopt;
  edits::MaterialIds ids;
  for (const terrain::Material& material : world.materials()) ids.emplace(material.name, material.id);
  for (std::size_t i = 0; i < placeables->size(); ++i) {
    ids.emplace(world.placeables()[i].name, (*placeables)[i]);
  }
  return ids;
}

tl::expected<EditOutcome, edits::EditError> Edits::apply(Workspace& workspace, const edits::Edit& edit) {
  const World& world = workspace.world();
  auto touched = edits::touched_voxels(edit);
  if (!touched) return tl::unexpected(touched.error());
  const std::vector<MaterialId> writable = writable_in(world);
  const auto allowed = edits::check(edit, {terrain::height_range(world), writable});
  if (!allowed) return tl::unexpected(allowed.error());
  edits::SettleRules rules;
  if (settings_.settles) rules = settle_rules(world);
  std::optional<edits::VoxelBox> loose;
  if (!rules.empty()) loose = edits::settle_box(edit);
  const auto base =
      loose ? base_of(workspace, edits::with_settling(*touched, loose)) : base_of(workspace, *touched);
  const auto outcome = edits::evaluate(edit, base, *this, loose ? &rules : nullptr, *touched);
  if (!outcome) return tl::unexpected(outcome.error());
  edits::StagingArea staged{*this, hash_};
  std::vector<ChunkKey> written = write(staged.stage(*outcome));
  hash_ = staged.hash();
  return EditOutcome{outcome->conflict, outcome->changed, std::move(written)};
}

Chunk Edits::merged_over(ChunkKey key, const Chunk& generated) const {
  const edits::ChunkOverrides* const overrides = find(key);
  return overrides == nullptr ? generated : overrides->merged_over(generated);
}

std::vector<ChunkCoord> Edits::changed_chunks() const {
  std::vector<ChunkCoord> chunks;
  for (const auto& [key, overrides] : overrides_) {
    if (key.lod == Lod{} && !overrides.empty()) chunks.push_back(key.coord);
  }
  std::ranges::sort(chunks);
  return chunks;
}

std::vector<std::byte> Edits::overrides(ChunkCoord chunk) const {
  const edits::ChunkOverrides* const found = find({chunk, Lod{}});
  std::vector<std::byte> runs;
  edits::encode_runs(found == nullptr ? std::span<const Override>{} : found->voxels(), runs);
  return runs;
}

tl::expected<std::vector<ChunkKey>, edits::EditError> Edits::restore(const World& world, ChunkCoord chunk,
                                                                     std::span<const std::byte> runs) {
  const auto inside = checked_chunk(chunk.x, chunk.y, chunk.z, Lod{});
  if (!inside) return refused(chunk, inside.error().message);
  const auto voxels = edits::decode_runs(runs);
  if (!voxels) return refused(chunk, std::string{edits::describe(voxels.error())});
  const HeightRange rows = terrain::height_range(world);
  const std::int64_t lowest = rows.low - edits::kRowMargin;
  const std::int64_t highest = rows.high + edits::kRowMargin;
  const std::vector<MaterialId> writable = writable_in(world);
  for (const Override& voxel : *voxels) {
    const std::int64_t y = voxel_at(chunk_origin(chunk), local_of(voxel.index)).y;
    if (y < lowest || y > highest) {
      return refused(chunk, "row " + std::to_string(y) + " is not in this world, whose rows are " +
                                std::to_string(lowest) + " to " + std::to_string(highest));
    }
    if (std::ranges::binary_search(writable, voxel.material)) continue;
    return refused(chunk, "material " + std::to_string(to_integer(voxel.material)) +
                              " is not in this world; its file must name all that was placed");
  }
  const edits::ChunkOverrides* const held = find({chunk, Lod{}});
  const edits::ChunkOverrides before = held == nullptr ? edits::ChunkOverrides{} : *held;
  std::vector<edits::OverrideWrite> changes = difference(before.voxels(), *voxels);
  if (changes.empty()) return std::vector<ChunkKey>{};
  std::vector<edits::ChunkWrites> writes = edits::coarse_writes(chunk, changes);
  writes.insert(writes.begin(), {{chunk, Lod{}}, std::move(changes)});
  std::vector<ChunkKey> written = write(writes);
  for (const Override& voxel : before.voxels()) hash_.remove(chunk, voxel);
  hash_.add(chunk, *voxels);
  return written;
}

std::vector<ChunkKey> Edits::write(std::span<const edits::ChunkWrites> writes) {
  // All memory is allocated before anything changes: if it runs out, some chunks have empty overrides, which
  // are none.
  std::vector<ChunkKey> written;
  written.reserve(writes.size());
  std::vector<edits::ChunkOverrides> after;
  after.reserve(writes.size());
  for (const edits::ChunkWrites& each : writes) {
    edits::ChunkOverrides overrides = overrides_[each.key];
    overrides.apply(each.writes);
    after.push_back(std::move(overrides));
    written.push_back(each.key);
  }
  for (std::size_t i = 0; i < written.size(); ++i) {
    const auto held = overrides_.find(written[i]);
    held->second = std::move(after[i]);
    if (held->second.empty()) overrides_.erase(held);
  }
  return written;
}

std::vector<MaterialId> Edits::writable_in(const World& world) const {
  std::vector<MaterialId> ids;
  for (const terrain::Material& material : world.materials()) ids.push_back(material.id);
  for (std::size_t i = 0; i < world.placeables().size(); ++i) {
    ids.push_back(settings_.placeables.empty() ? placeable_id(i) : settings_.placeables[i]);
  }
  std::ranges::sort(ids);
  return ids;
}

const edits::ChunkOverrides* Edits::find(ChunkKey chunk) const {
  const auto found = overrides_.find(chunk);
  return found == overrides_.end() || found->second.empty() ? nullptr : &found->second;
}

}  // namespace talus::local
