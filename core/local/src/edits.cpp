#include <talus/local/edits.h>

#include <cstdint>
#include <span>
#include <utility>

#include <talus/edits/levels.h>
#include <talus/edits/materials.h>
#include <talus/edits/staging.h>
#include <talus/terrain/extraction.h>

namespace talus::local {
namespace {

// Reads the generated materials of voxels.
class BaseReader final : public ChunkSink {
 public:
  BaseReader(std::span<const std::uint16_t> voxels, std::vector<Override>& base)
      : voxels_{voxels}, base_{base} {}
  void take(ChunkKey /*key*/, const Chunk& chunk) override {
    for (const std::uint16_t index : voxels_) base_.push_back({index, chunk.at(local_of(index))});
  }

 private:
  std::span<const std::uint16_t> voxels_;
  std::vector<Override>& base_;
};

std::vector<MaterialId> writable_in(const World& world) {
  std::vector<MaterialId> ids;
  for (const terrain::Material& material : world.materials()) ids.push_back(material.id);
  for (std::size_t i = 0; i < world.placeables().size(); ++i) ids.push_back(placeable_id(i));
  return ids;
}

}  // namespace

MaterialId placeable_id(std::size_t index) {
  return MaterialId{static_cast<std::uint16_t>(edits::kFirstBound + index)};
}

tl::expected<EditOutcome, edits::EditError> Edits::apply(Workspace& workspace, const edits::Edit& edit) {
  const auto touched = edits::touched_voxels(edit);
  if (!touched) return tl::unexpected(touched.error());
  const std::vector<MaterialId> writable = writable_in(workspace.world());
  const auto allowed = edits::check(edit, {terrain::height_range(workspace.world()), writable});
  if (!allowed) return tl::unexpected(allowed.error());
  edits::BaseVoxels base;
  for (const edits::TouchedChunk& each : *touched) {
    const ChunkKey key{each.chunk, Lod{}};
    BaseReader reader{each.voxels, base[each.chunk]};
    generate(workspace, {&key, 1}, reader);
  }
  const auto outcome = edits::evaluate(edit, base, *this, nullptr, *touched);
  if (!outcome) return tl::unexpected(outcome.error());
  EditOutcome result{outcome->conflict, outcome->changed, {}};
  for (const edits::ChunkWrites& each : edits::writes_at_all_levels(outcome->chunks)) {
    edits::ChunkOverrides& overrides = overrides_[each.key];
    overrides.apply(each.writes);
    if (overrides.empty()) overrides_.erase(each.key);
    result.chunks.push_back(each.key);
  }
  return result;
}

Chunk Edits::merged_over(ChunkKey key, const Chunk& generated) const {
  const edits::ChunkOverrides* const overrides = find(key);
  return overrides == nullptr ? generated : overrides->merged_over(generated);
}

const edits::ChunkOverrides* Edits::find(ChunkKey chunk) const {
  const auto found = overrides_.find(chunk);
  return found == overrides_.end() ? nullptr : &found->second;
}

}  // namespace talus::local
