#include <talus/edits/evaluate.h>

#include <catch2/catch.hpp>

#include "model.h"

namespace talus::edits {
namespace {

using namespace testing;

constexpr MaterialId kStone{3};
constexpr MaterialId kPlanks{200};

Outcome outcome_of(const Edit& edit, const OverrideSource& state) {
  return evaluate(edit, base_of(edit), state).value();
}

}  // namespace

TEST_CASE("a guard that does not hold stops all of an edit, in every chunk") {
  State state;
  Edit edit;
  edit.guards.push_back({{0, 0, 0}, base_at({0, 0, 0})});
  edit.guards.push_back({{100, 0, 0}, kPlanks});
  edit.writes.push_back({{0, 0, 0}, kPlanks});
  edit.fills.push_back({{-40, 0, 0}, {40, 0, 0}, kPlanks, {}});
  const Outcome outcome = outcome_of(edit, state);
  CHECK(outcome.conflict == 1);
  CHECK(outcome.changed == 0);
  CHECK(outcome.chunks.empty());
}

TEST_CASE("guards see the state before the edit, and earlier edits of the batch") {
  State state;
  StagingArea staging{state, state.hash};
  Edit edit;
  edit.writes.push_back({{1, 1, 1}, kPlanks});
  staging.stage(outcome_of(edit, staging));
  edit.guards.push_back({{1, 1, 1}, kPlanks});
  edit.writes[0].material = MaterialId{201};
  CHECK(outcome_of(edit, state).conflict == 0);
  const Outcome outcome = outcome_of(edit, staging);
  CHECK_FALSE(outcome.conflict);
  CHECK(outcome.chunks ==
        std::vector<ChunkChanges>{{{0, 0, 0}, {{1057, kPlanks, MaterialId{201}, base_at({1, 1, 1})}}}});
}

TEST_CASE("an edit that changes nothing has changed nothing, though it wrote in between") {
  State state;
  Edit edit;
  edit.writes.push_back({{2, 0, 0}, kPlanks});
  edit.writes.push_back({{2, 0, 0}, base_at({2, 0, 0})});
  CHECK(outcome_of(edit, state) == Outcome{});
}

TEST_CASE("writes, fills and a paste are applied in this order, each on the result of the previous") {
  State state;
  Edit edit;
  edit.writes.push_back({{0, 0, 0}, kPlanks});
  edit.fills.push_back({{0, 0, 0}, {31, 0, 0}, MaterialId{201}, kPlanks});  // finds the written voxel alone
  Outcome outcome = outcome_of(edit, state);
  REQUIRE(outcome.changed == 1);
  CHECK(outcome.chunks[0].voxels[0].after == MaterialId{201});
  const std::vector<Override> one{{0, MaterialId{202}}};
  edit.paste = Paste{{0, 0, 0}, Chunk::uniform(kAir).with_overrides(one), false};
  outcome = outcome_of(edit, state);
  REQUIRE(outcome.changed == 1);
  CHECK(outcome.chunks[0].voxels[0].after == MaterialId{202});
}

TEST_CASE("filling as generated removes edits where `only` matches") {
  State state;
  StagingArea staging{state, state.hash};
  Edit build;
  build.writes.push_back({{0, 0, 0}, kPlanks});
  build.writes.push_back({{1, 0, 0}, MaterialId{201}});
  staging.stage(outcome_of(build, staging));
  Edit restore;
  restore.fills.push_back({{-1, 0, 0}, {5, 0, 0}, std::nullopt, kPlanks});
  const Outcome first = outcome_of(restore, staging);
  CHECK(first.changed == 1);
  CHECK(writes_of(first.chunks.at(0)) == std::vector<OverrideWrite>{{0, std::nullopt}});
  restore.fills[0].only = std::nullopt;
  const Outcome second = outcome_of(restore, staging);
  CHECK(second.changed == 2);
  CHECK_FALSE(staging.chunks().at({{0, 0, 0}, Lod{}}).after().empty());
  staging.stage(second);
  CHECK(staging.chunks().at({{0, 0, 0}, Lod{}}).after().empty());
  CHECK(staging.hash() == StateHash{});
}

TEST_CASE("a base that lacks a touched voxel is an error that names it; nothing is generated in its place") {
  State state;
  Edit edit;
  edit.writes.push_back({{33, 0, 0}, kStone});
  const std::string missing =
      "chunk (1, 0, 0): the base of voxel 1 is missing; an entry must hold the base of every voxel it "
      "touches";
  CHECK(evaluate(edit, {}, state).error().message == missing);
  CHECK(evaluate(edit, {{{1, 0, 0}, {{0, kStone}, {2, kStone}}}}, state).error().message == missing);
  CHECK(evaluate(edit, {{{1, 0, 0}, {{0, kStone}, {1, kAir}, {2, kStone}}}}, state).value().changed == 1);
}

TEST_CASE("an edit beyond its bounds is an error wherever it is evaluated") {
  State state;
  Edit edit;
  edit.fills.push_back({{0, 0, 0}, {64, 31, 31}, kStone, {}});
  CHECK(evaluate(edit, {}, state).error().message.starts_with("edit: it names more than 65536 voxels"));
}

TEST_CASE("the largest edit changes every one of its voxels") {
  State state;
  Edit edit;
  edit.fills.push_back({{-16, -16, -16}, {47, 15, 15}, kPlanks, {}});
  StagingArea staging{state, state.hash};
  const Outcome outcome = outcome_of(edit, staging);
  CHECK(outcome.changed == kMaxVoxels);
  CHECK(outcome.chunks.size() == 12);
  staging.stage(outcome);
  state.commit(std::move(staging));
  CHECK(state.overrides(Lod{}).size() == kMaxVoxels);
  CHECK(state.overrides(Lod::of(1)).size() == kMaxVoxels / 8);
}

}  // namespace talus::edits
