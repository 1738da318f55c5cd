#include <rapidcheck.h>
#include <catch2/catch.hpp>

#include <array>
#include <map>
#include <vector>

#include <talus/edits/batch.h>
#include <talus/edits/evaluate.h>
#include <talus/edits/staging.h>

#include "model.h"

namespace talus::edits {
namespace {

using namespace testing;

constexpr MaterialId kRock{3};  // what the base shows in place of ore
constexpr MaterialId kOre{9};
constexpr MaterialId kPlanks{200};

bool is_hidden(VoxelPos voxel) {
  return base_at(voxel) == kRock && (voxel.x + 2 * voxel.y + voxel.z) % 2 == 0;
}

std::array<VoxelPos, 6> beside(VoxelPos at) {
  return {{{at.x - 1, at.y, at.z},
           {at.x + 1, at.y, at.z},
           {at.x, at.y - 1, at.z},
           {at.x, at.y + 1, at.z},
           {at.x, at.y, at.z - 1},
           {at.x, at.y, at.z + 1}}};
}

// What a node looks up for an edit.
SecretVoxels secrets_of(const Edit& edit) {
  SecretVoxels secrets{{kAir, kWater}, {}, {}};
  for (const TouchedChunk& each : with_neighbours(touched_voxels(edit).value())) {
    for (const std::uint16_t index : each.voxels) {
      const VoxelPos at = voxel_at(chunk_origin(each.chunk), local_of(index));
      if (!is_hidden(at)) continue;
      secrets.hidden[each.chunk].push_back({index, kOre});
      secrets.base[each.chunk].push_back({index, base_at(at)});
    }
  }
  return secrets;
}

// The overrides that an edit leaves: the model's, then every hidden voxel beside a see-through override.
void reveal(const Edit& edit, Model& model) {
  Edit revealed;
  for (const auto& [chunk, hidden] : secrets_of(edit).hidden) {
    for (const Override& each : hidden) {
      const VoxelPos at = voxel_at(chunk_origin(chunk), local_of(each.index));
      if (model.overrides().contains(at)) continue;
      for (const VoxelPos other : beside(at)) {
        const auto found = model.overrides().find(other);
        if (found == model.overrides().end() || found->second > kWater) continue;
        revealed.writes.push_back({at, kOre});
        break;
      }
    }
  }
  model.apply(revealed);
}

VoxelPos hidden_voxel_near(VoxelPos at) {
  while (!is_hidden(at)) ++at.x;
  return at;
}

Outcome outcome_of(const Edit& edit, const OverrideSource& state) {
  const SecretVoxels secrets = secrets_of(edit);
  return evaluate(edit, base_of(edit), state, nullptr, {}, &secrets).value();
}

}  // namespace

TEST_CASE("edits reveal what they expose, and nothing else") {
  std::size_t ore = 0;
  CHECK(rc::check([&] {
    State state;
    Model model;
    for (int edits = *rc::gen::inRange(1, 12); edits > 0; --edits) {
      const Edit edit = any_edit(model);
      if (!touched_voxels(edit)) continue;
      const auto before = model.overrides();
      const Model::Result expected = model.apply(edit);
      if (expected.changed > 0) reveal(edit, model);
      StagingArea staging{state, state.hash};
      const Outcome outcome = outcome_of(edit, staging);
      RC_ASSERT(outcome.conflict == expected.conflict);
      staging.stage(outcome);
      state.commit(staging);
      RC_ASSERT(state.overrides(Lod{}) == model.overrides());
      std::map<VoxelPos, MaterialId> both = before;
      both.insert(model.overrides().begin(), model.overrides().end());
      std::size_t changed = 0;
      for (const auto& [at, material] : both) {
        const auto old = before.find(at);
        const auto now = model.overrides().find(at);
        const bool same = old == before.end()              ? now == model.overrides().end()
                          : now == model.overrides().end() ? false
                                                           : old->second == now->second;
        changed += same ? 0 : 1;
      }
      RC_ASSERT(outcome.changed == changed);
      for (const auto& [at, material] : model.overrides()) ore += material == kOre ? 1 : 0;
    }
  }));
  CHECK(ore > 1000);
}

TEST_CASE("a refused edit and one that changes nothing reveal nothing") {
  const VoxelPos hidden = hidden_voxel_near({0, 0, 0});
  const VoxelPos dug{hidden.x, hidden.y + 1, hidden.z};
  State state;
  Edit dig;
  dig.writes.push_back({dug, kPlanks});
  dig.guards.push_back({hidden, kOre});  // players' guards see the shown world
  CHECK(outcome_of(dig, state).conflict == 0);
  CHECK(outcome_of(dig, state).changed == 0);
  Edit only;
  only.fills.push_back({hidden, hidden, kPlanks, kOre});
  CHECK(outcome_of(only, state) == Outcome{});
  Edit nothing;
  nothing.writes.push_back({dug, kAir});
  nothing.writes.push_back({dug, base_at(dug)});
  CHECK(outcome_of(nothing, state) == Outcome{});
}

TEST_CASE("an opaque material reveals nothing, and revealed ore stays when it is covered") {
  VoxelPos hidden = hidden_voxel_near({0, 0, 0});
  while (base_at({hidden.x, hidden.y + 1, hidden.z}) <= kWater)
    hidden = hidden_voxel_near({hidden.x + 1, 0, 0});
  const VoxelPos dug{hidden.x, hidden.y + 1, hidden.z};
  State state;
  const auto apply = [&](MaterialId material) {
    Edit edit;
    edit.writes.push_back({dug, material});
    StagingArea staging{state, state.hash};
    staging.stage(outcome_of(edit, staging));
    state.commit(staging);
    const auto overrides = state.overrides(Lod{});
    const auto found = overrides.find(hidden);
    return found != overrides.end() && found->second == kOre;
  };
  CHECK_FALSE(apply(kPlanks));
  CHECK(apply(kAir));
  CHECK(apply(kPlanks));
}

TEST_CASE("the result of an entry with secrets counts and stores what it revealed") {
  VoxelPos hidden = hidden_voxel_near({0, 0, 0});
  while (base_at({hidden.x, hidden.y + 1, hidden.z}) <= kWater)
    hidden = hidden_voxel_near({hidden.x + 1, 0, 0});
  State state;
  const Editors editors;
  const Head head;
  Batch batch{state, editors, head, 0};
  batch.apply(AttachEntry{{1, 1}, 1, ""});
  EditEntry entry{{1, 1}, 1, 1, {}, {}};
  entry.edit.writes.push_back({{hidden.x, hidden.y + 1, hidden.z}, kAir});
  entry.base = base_of(entry.edit);
  entry.secrets = secrets_of(entry.edit);
  const EntryResult& result = batch.apply(entry);
  REQUIRE(result.kind == EntryResult::Kind::done);
  CHECK(result.result.changed >= 2);
  std::size_t ore = 0;
  for (const ChunkChanges& chunk : result.changes) {
    for (const VoxelChange& voxel : chunk.voxels) ore += voxel.after == kOre ? 1 : 0;
  }
  CHECK(ore + 1 == result.result.changed);
}

}  // namespace talus::edits
