// Which edits a token and the server's settings forbid, and what is said of it.
#include "edits/admission/edit_rules.h"

#include <catch2/catch.hpp>

#include <talus/edits/settle.h>

namespace talus::server {
namespace {

Grant editor(Rights rights = {Right::read, Right::edit}) {
  return Grant{rights, "alice", std::nullopt};
}

edits::Edit write_at(VoxelPos at) {
  edits::Edit edit;
  edit.writes.push_back({at, MaterialId{1}});
  return edit;
}

edits::Edit fill_of(VoxelPos first, VoxelPos last) {
  edits::Edit edit;
  edit.fills.push_back({first, last, MaterialId{1}, std::nullopt});
  return edit;
}

/// A chunk of air with one voxel of stone, at `place` in it.
edits::Edit paste_of(VoxelPos origin, std::size_t place, bool with_air) {
  DenseVoxels voxels{};
  voxels[place] = MaterialId{1};
  edits::Edit edit;
  edit.paste = edits::Paste{origin, Chunk::from_dense(voxels), with_air};
  return edit;
}

const EditRules kSpawn{*Boxes::parse("-16,-16:16,16"), false};

}  // namespace

TEST_CASE("protected boxes of the server are open to the right admin alone, and guards may look into them") {
  CHECK_FALSE(edit_forbidden(write_at({17, 0, 0}), editor(), kSpawn));
  CHECK(edit_forbidden(write_at({16, 0, 0}), editor(), kSpawn) ==
        "write 0: voxel 16,0,0 intersects -16,-16:16,16, which this server protects");
  CHECK_FALSE(edit_forbidden(write_at({16, 0, 0}), editor({Right::read, Right::edit, Right::admin}), kSpawn));
  CHECK(edit_forbidden(write_at({16, 0, 0}), editor({Right::read, Right::edit, Right::gateway}), kSpawn));
  CHECK(edit_forbidden(fill_of({-90, -9, 0}, {90, -9, 0}), editor(), kSpawn) ==
        "fill 0: the box -90,-9,0:90,-9,0 intersects -16,-16:16,16, which this server protects");
  edits::Edit looks = write_at({17, 0, 0});
  looks.guards.push_back({{0, 0, 0}, MaterialId{1}});
  CHECK_FALSE(edit_forbidden(looks, editor(), kSpawn));
}

TEST_CASE("a token's boxes limit its edits, with or without the right admin") {
  Grant grant = editor({Right::read, Right::edit, Right::admin});
  grant.edit_in = *Boxes::parse("0,0:31,31; 32,0:63,31");
  grant.edit_not_in = *Boxes::parse("8,8:9,9");
  CHECK_FALSE(edit_forbidden(write_at({31, 5, 31}), grant, {}));
  CHECK_FALSE(edit_forbidden(write_at({32, 5, 31}), grant, {}));
  CHECK(edit_forbidden(write_at({64, 5, 0}), grant, {}) ==
        "write 0: voxel 64,5,0 is outside the boxes of this session's token, which allows edits in "
        "0,0:31,31; "
        "32,0:63,31");
  CHECK_FALSE(edit_forbidden(fill_of({10, 0, 10}, {31, 0, 31}), grant, {}));
  CHECK(edit_forbidden(fill_of({10, 0, 10}, {32, 0, 31}), grant, {}));  // over two boxes
  CHECK_THAT(*edit_forbidden(write_at({8, 5, 9}), grant, {}),
             Catch::EndsWith("intersects 8,8:9,9, where this session's token forbids edits"));
  edits::Edit second = write_at({1, 1, 1});
  second.writes.push_back({{-1, 1, 1}, MaterialId{1}});
  CHECK_THAT(*edit_forbidden(second, grant, {}), Catch::StartsWith("write 1: voxel -1,1,1"));
  grant.edit_in = Boxes{};
  CHECK_THAT(*edit_forbidden(write_at({1, 1, 1}), grant, {}), Catch::EndsWith("allows edits nowhere"));
}

TEST_CASE("a paste is checked by the voxels that it writes") {
  Grant grant = editor();
  grant.edit_in = *Boxes::parse("5,6,7:5,6,7");
  const std::size_t place = (6 * 32 + 7) * 32 + 5;
  CHECK_FALSE(edit_forbidden(paste_of({0, 0, 0}, place, false), grant, {}));
  CHECK(edit_forbidden(paste_of({1, 0, 0}, place, false), grant, {}));
  CHECK(edit_forbidden(paste_of({0, 0, 0}, place, true), grant, {}));
}

TEST_CASE("material that slides after an edit does not leave a box that the edit must stay out of") {
  const auto around = [](std::int64_t x, std::int64_t z) { return *edits::settle_box(write_at({x, 0, z})); };
  CHECK(may_settle(around(16, 0), editor(), {}));
  CHECK(may_settle(around(17 + edits::kSettleMargin, 0), editor(), kSpawn));
  CHECK_FALSE(may_settle(around(16 + edits::kSettleMargin, 0), editor(), kSpawn));
  CHECK(may_settle(around(16, 0), editor({Right::read, Right::edit, Right::admin}), kSpawn));
  Grant grant = editor();
  grant.edit_in = *Boxes::parse("0,0:31,31");
  CHECK(may_settle(around(16, 16), grant, {}));
  CHECK_FALSE(may_settle(around(2, 16), grant, {}));
  // Farther off than can be counted: the edit has no box, and is refused where its voxels are looked at.
  for (const std::int64_t far : {INT64_MIN, INT64_MAX}) {
    for (const edits::Edit& edit :
         {fill_of({0, 0, 0}, {far, far, far}), paste_of({far, far, far}, kChunkVolume - 1, false)}) {
      CHECK_FALSE(extent_of(edit, true).loose);
      CHECK_FALSE(edit_forbidden(edit, grant, {}));
    }
  }
}

TEST_CASE("if a gateway is required, so is its right") {
  const EditRules required{{}, true};
  CHECK_FALSE(edits_forbidden(editor(), {}));
  CHECK_THAT(*edits_forbidden(editor(), required), Catch::Contains("edits.gateway"));
  CHECK_FALSE(edits_forbidden(editor({Right::read, Right::edit, Right::gateway}), required));
  CHECK_THAT(*edits_forbidden(editor({Right::read}), {}), Catch::Contains("no right to edit"));
}

}  // namespace talus::server
