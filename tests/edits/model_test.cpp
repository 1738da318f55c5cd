// Random edits, in batches that are stored or dropped, against the model.
#include <rapidcheck.h>
#include <catch2/catch.hpp>

#include "model.h"

namespace talus::edits {
namespace {

using namespace testing;

/// S as it would be, were it made from nothing.
StateHash hash_from_nothing(const Model& model) {
  StateHash hash;
  for (const auto& [voxel, material] : model.overrides()) {
    const ChunkCoord chunk = chunk_holding(voxel, Lod{}).value().coord;
    hash.add(chunk, Override{static_cast<std::uint16_t>(voxel_index(local_pos(voxel))), material});
  }
  return hash;
}

void require_equal(const State& state, const Model& model) {
  RC_ASSERT(state.overrides(Lod{}) == model.overrides());
  RC_ASSERT(state.hash == hash_from_nothing(model));
  for (int level = 1; level <= Lod::kMax; ++level) {
    const std::int64_t size = std::int64_t{1} << level;
    std::map<VoxelPos, MaterialId> samples;
    for (const auto& [voxel, material] : model.overrides()) {
      if (floor_mod(voxel.x, size) != 0 || floor_mod(voxel.z, size) != 0) continue;
      if (floor_mod(voxel.y, size) != size / 2) continue;
      samples.emplace(VoxelPos{floor_div(voxel.x, size), floor_div(voxel.y, size), floor_div(voxel.z, size)},
                      material);
    }
    RC_ASSERT(state.overrides(Lod::of(level)) == samples);
  }
}

Model::Result result_of(const Outcome& outcome) {
  std::size_t changed = 0;
  for (const ChunkChanges& chunk : outcome.chunks) {
    RC_ASSERT(!chunk.voxels.empty());
    changed += chunk.voxels.size();
  }
  RC_ASSERT(changed == outcome.changed);
  return {outcome.conflict, outcome.changed};
}

/// An edit that puts everything back, and holds only where nobody else wrote since.
Edit undo_of(const Outcome& outcome) {
  Edit undo;
  for (const ChunkChanges& each : outcome.chunks) {
    const VoxelPos origin = chunk_origin(each.chunk);
    for (const VoxelChange& voxel : each.voxels) {
      const VoxelPos at{origin.x + voxel.index % 32, origin.y + voxel.index / 1024,
                        origin.z + voxel.index / 32 % 32};
      undo.guards.push_back({at, voxel.after});
      undo.writes.push_back({at, voxel.before});
    }
  }
  return undo;
}

}  // namespace

TEST_CASE("batches of edits do what the model does; a batch that is dropped does nothing") {
  CHECK(rc::check([] {
    Model model;
    State state;
    for (int batch = *rc::gen::inRange(1, 5); batch > 0; --batch) {
      StagingArea staging{state, state.hash};
      Model staged = model;
      for (int edits = *rc::gen::inRange(1, 6); edits > 0; --edits) {
        const Edit edit = any_edit(staged);
        const auto outcome = evaluate(edit, base_of(edit), staging);
        RC_ASSERT(outcome.has_value());
        RC_ASSERT(result_of(*outcome) == staged.apply(edit));
        if (outcome->conflict) RC_ASSERT(outcome->chunks.empty());
        staging.stage(*outcome);
      }
      if (*rc::gen::inRange(0, 4) > 0) {
        state.commit(std::move(staging));
        model = staged;
      }
      require_equal(state, model);
    }
  }));
}

TEST_CASE(
    "the writes of a batch, made again and twice, give the same chunks: a log of them can be replayed") {
  CHECK(rc::check([] {
    Model model;
    State state;
    std::vector<ChunkWrites> log;
    StagingArea staging{state, state.hash};
    for (int edits = *rc::gen::inRange(1, 8); edits > 0; --edits) {
      const Edit edit = any_edit(model);
      const auto outcome = evaluate(edit, base_of(edit), staging);
      model.apply(edit);
      for (ChunkWrites& each : staging.stage(outcome.value())) log.push_back(std::move(each));
    }
    state.commit(std::move(staging));
    std::unordered_map<ChunkKey, ChunkOverrides> replayed;
    for (int pass = 0; pass < 2; ++pass) {
      for (const ChunkWrites& each : log) replayed[each.key].apply(each.writes);
    }
    std::erase_if(replayed, [](const auto& each) { return each.second.empty(); });
    RC_ASSERT(replayed == state.chunks);
  }));
}

TEST_CASE("undoing all edits from the last to the first leaves nothing, at any level") {
  CHECK(rc::check([] {
    Model model;
    State state;
    std::vector<Edit> undos;
    const auto apply = [&](const Edit& edit) {
      StagingArea staging{state, state.hash};
      const Outcome outcome = evaluate(edit, base_of(edit), staging).value();
      RC_ASSERT(result_of(outcome) == model.apply(edit));
      staging.stage(outcome);
      state.commit(std::move(staging));
      return outcome;
    };
    for (int edits = *rc::gen::inRange(1, 6); edits > 0; --edits) {
      Edit edit = any_edit(model);
      // An undo guards and writes each voxel: half as many as an edit may name.
      if (edit.paste) edit.paste->with_air = false;
      edit.fills.clear();
      undos.push_back(undo_of(apply(edit)));
    }
    for (; !undos.empty(); undos.pop_back()) RC_ASSERT(!apply(undos.back()).conflict);
    RC_ASSERT(state.chunks.empty());
    RC_ASSERT(state.hash == StateHash{});
  }));
}

}  // namespace talus::edits
