// Edits of one editor after another, and what the store must hold then.
#pragma once

#include <map>
#include <random>
#include <string>

#include "edit_store.h"
#include "edits/model.h"

namespace talus::server::testing {

/// An editor that a store knows, and its next sequence.
struct TestEditor {
  edits::EditorId id{7, 9};
  std::uint64_t epoch = 0;
  std::uint64_t sequence = 0;

  void attach(EditStore& store) {
    const auto known = store.state().editor(id);
    epoch = known ? known->epoch + 1 : 1;
    REQUIRE(store.apply(edits::AttachEntry{id, epoch, "somebody"})->kind ==
            edits::EntryResult::Kind::attached);
  }
  [[nodiscard]] edits::EditEntry entry(const edits::Edit& edit) const {
    return {id, epoch, sequence, edit, edits::testing::base_of(edit)};
  }
  std::optional<edits::EntryResult> edit(EditStore& store, const edits::Edit& edit) {
    ++sequence;
    return store.apply(entry(edit));
  }
};

/// Writes of a few voxels near the corners of chunks.
inline edits::Edit random_edit(std::mt19937_64& random) {
  edits::Edit edit;
  for (std::uint64_t left = 1 + random() % 4; left > 0; --left) {
    const auto at = [&] { return static_cast<std::int64_t>(random() % 12) - 6; };
    edit.writes.push_back({{at() * 16, at(), at()}, MaterialId{static_cast<std::uint16_t>(random() % 5)}});
  }
  return edit;
}

/// All that the state says of level 0, by the chunks of the model.
inline std::map<VoxelPos, MaterialId> overrides_of(const EditState& state) {
  std::map<VoxelPos, MaterialId> voxels;
  for (std::int32_t x = -4; x <= 4; ++x) {
    for (std::int32_t y = -2; y <= 2; ++y) {
      for (std::int32_t z = -2; z <= 2; ++z) {
        const auto chunk = state.load({{x, y, z}, Lod{}});
        REQUIRE(chunk.has_value());
        if (chunk->overrides == nullptr) continue;
        const VoxelPos at = chunk_origin({x, y, z});
        for (const Override& each : chunk->overrides->voxels()) {
          voxels.emplace(
              VoxelPos{at.x + each.index % 32, at.y + each.index / 1024, at.z + each.index / 32 % 32},
              each.material);
        }
      }
    }
  }
  return voxels;
}

}  // namespace talus::server::testing
