// The bounds of an edit, and which voxels it touches.
#include <talus/edits/edit.h>

#include <algorithm>

#include <catch2/catch.hpp>

namespace talus::edits {
namespace {

constexpr std::int64_t kWorldEnd = std::int64_t{1} << 36;
constexpr MaterialId kStone{3};

Edit filling(VoxelPos first, VoxelPos last) {
  Edit edit;
  edit.fills.push_back({first, last, kStone, {}});
  return edit;
}

std::string refusal(const Edit& edit) {
  const auto touched = touched_voxels(edit);
  return touched ? "" : touched.error().message;
}

std::size_t touched_count(const Edit& edit) {
  std::size_t count = 0;
  const auto touched = touched_voxels(edit);
  for (const TouchedChunk& each : touched.value()) count += each.voxels.size();
  return count;
}

constexpr const char* kTooManyVoxels =
    "edit: it names more than 65536 voxels; guards, writes, fills and paste count together";
constexpr const char* kTooManyChunks = "edit: it reaches more than 64 chunks; it must be divided";

}  // namespace

TEST_CASE("an edit names up to 65,536 voxels, guards with them") {
  Edit edit = filling({0, 0, 0}, {63, 31, 31});
  CHECK(touched_count(edit) == kMaxVoxels);
  edit.guards.push_back({{0, 0, 0}, kStone});
  CHECK(refusal(edit) == kTooManyVoxels);
  CHECK(refusal(filling({0, 0, 0}, {64, 31, 31})) == kTooManyVoxels);
}

TEST_CASE("boxes whose volume wraps any integer are refused at once") {
  CHECK(refusal(filling({-kWorldEnd, -kWorldEnd, -kWorldEnd},
                        {kWorldEnd - 1, kWorldEnd - 1, kWorldEnd - 1})) == kTooManyVoxels);
  Edit many = filling({0, 0, 0}, {63, 31, 31});
  many.fills.resize(5000, many.fills.front());
  CHECK(refusal(many) == kTooManyVoxels);
}

TEST_CASE("an edit reaches up to 64 chunks") {
  CHECK(touched_voxels(filling({-5, 0, 0}, {-5 + 32 * 63, 0, 0})).value().size() == 64);
  CHECK(refusal(filling({-5, 0, 0}, {-5 + 32 * 64, 0, 0})) == kTooManyChunks);
  Edit edit;
  for (int i = 0; i < 65; ++i) edit.writes.push_back({{i * 1000, 0, 0}, kStone});
  CHECK(refusal(edit) == kTooManyChunks);
  edit.writes.back() = edit.writes.front();
  CHECK(touched_count(edit) == 64);
}

TEST_CASE("a box has its corners in order and in the world") {
  CHECK(refusal(filling({0, 5, 0}, {0, 4, 0})) ==
        "fill 0: its first y is 5, its last 4; the first must not be greater");
  CHECK(refusal(filling({0, 0, kWorldEnd - 1}, {0, 0, kWorldEnd})) ==
        "fill 0: voxel z is 68719476736; it must lie in -68719476736 to 68719476735 at level of detail 0");
  CHECK(refusal(filling({INT64_MIN, 0, 0}, {INT64_MAX, 0, 0}))
            .starts_with("fill 0: voxel x is -9223372036854775808;"));
  Edit edit;
  edit.writes.push_back({{0, 0, 0}, kStone});
  edit.writes.push_back({{0, INT64_MAX, 0}, kStone});
  CHECK(refusal(edit).starts_with("write 1: voxel y is 9223372036854775807;"));
  edit.guards.push_back({{0, 0, INT64_MIN}, kStone});
  CHECK(refusal(edit).starts_with("guard 0: voxel z is"));
}

TEST_CASE("a paste touches what it writes, and lies in the world whole") {
  const std::vector<Override> two{{0, kStone}, {32767, kStone}};
  Edit edit;
  edit.paste = Paste{{1, 1, 1}, Chunk::uniform(kAir).with_overrides(two), false};
  CHECK(touched_count(edit) == 2);
  edit.paste->with_air = true;
  CHECK(touched_count(edit) == 32768);
  CHECK(touched_voxels(edit).value().size() == 8);
  edit.paste->origin = {kWorldEnd - 32, 0, 0};
  CHECK(refusal(edit).empty());
  edit.paste->origin = {kWorldEnd - 31, 0, 0};
  CHECK(refusal(edit).starts_with("paste: voxel x is 68719476736;"));
  edit.paste->origin = {INT64_MAX, 0, 0};
  CHECK(refusal(edit).starts_with("paste: voxel x is 9223372036854775807;"));
}

TEST_CASE("touched chunks come in order, and in each its voxels, once") {
  Edit edit;
  for (const VoxelPos voxel :
       {VoxelPos{40, 0, 0}, VoxelPos{-1, -1, -1}, VoxelPos{33, 2, 1}, VoxelPos{40, 0, 0}}) {
    edit.writes.push_back({voxel, kStone});
  }
  const auto touched = touched_voxels(edit).value();
  REQUIRE(touched.size() == 2);
  CHECK(touched[0].chunk == ChunkCoord{-1, -1, -1});
  CHECK(touched[0].voxels == std::vector<std::uint16_t>{32767});
  CHECK(touched[1].chunk == ChunkCoord{1, 0, 0});
  CHECK(touched[1].voxels == std::vector<std::uint16_t>{8, (2 * 32 + 1) * 32 + 1});
}

TEST_CASE("boxes that overlap touch each voxel once, in order, be they small or large") {
  for (const std::int64_t size : {3, 20}) {
    Edit edit = filling({5, 5, 5}, {4 + size, 4 + size, 4 + size});
    edit.fills.push_back({{5, 4, 5}, {4 + size, 4 + size, 4 + size}, kStone, {}});
    const auto touched = touched_voxels(edit).value();
    REQUIRE(touched.size() == 1);
    CHECK(touched[0].voxels.size() == static_cast<std::size_t>(size * (size + 1) * size));
    CHECK(std::is_sorted(touched[0].voxels.begin(), touched[0].voxels.end()));
  }
}

std::vector<ChunkCoord> chunks_of(const Edit& edit) {
  return extent_of(edit, false).chunks;
}

TEST_CASE("an edit touches its writable chunks and its guards' chunks, or no chunk if it is refused") {
  Edit edit = filling({30, 0, 0}, {33, 0, 0});
  edit.writes.push_back({{-1, 5, 64}, kStone});
  edit.writes.push_back({{-2, 5, 64}, kStone});
  edit.guards.push_back({{1'000, 0, 0}, kStone});
  CHECK(chunks_of(edit) == std::vector<ChunkCoord>{{-1, 0, 2}, {0, 0, 0}, {1, 0, 0}, {31, 0, 0}});
  // A paste may write all that it lies in, whatever it holds.
  Edit paste;
  paste.paste = Paste{{1, 0, 0}, Chunk::uniform(kAir), false};
  CHECK(chunks_of(paste) == std::vector<ChunkCoord>{{0, 0, 0}, {1, 0, 0}});
  CHECK(chunks_of(filling({0, 0, 0}, {64 * 32 - 1, 0, 0})).size() == 64);
  CHECK(chunks_of(filling({0, 0, 0}, {64 * 32, 0, 0})).empty());
  Edit guarding = filling({0, 0, 0}, {63 * 32 - 1, 0, 0});
  guarding.guards.push_back({{0, 32, 0}, kStone});
  CHECK(chunks_of(guarding).size() == 64);
  guarding.guards.push_back({{0, 64, 0}, kStone});
  CHECK(chunks_of(guarding).empty());
  CHECK(chunks_of(filling({kWorldEnd, 0, 0}, {kWorldEnd, 0, 0})).empty());
  CHECK(chunks_of(filling({1, 0, 0}, {0, 0, 0})).empty());
  // Far beyond the world nothing overflows.
  paste.paste->origin = {INT64_MAX, INT64_MAX - 31, INT64_MIN};
  CHECK(chunks_of(paste).empty());
  CHECK_FALSE(touched_voxels(paste));
  // At the world's six faces too.
  for (const std::int64_t end : {std::int64_t{-kWorldEnd}, std::int64_t{kWorldEnd} - 1}) {
    for (const VoxelPos at : {VoxelPos{end, 0, 0}, VoxelPos{0, end, 0}, VoxelPos{0, 0, end}}) {
      CHECK(chunks_of(filling(at, at)) == std::vector{chunk_holding(at, Lod{})->coord});
    }
  }
  // What is loose around it may come into its neighbours.
  Edit corner;
  corner.writes.push_back({{0, 40, 0}, kStone});
  CHECK(chunks_of(corner).size() == 1);
  const Extent settling = extent_of(corner, true);
  CHECK(settling.chunks == chunks_of(corner));
  CHECK(settling.loose == settle_box(corner));
  CHECK_FALSE(extent_of(corner, false).loose);
  std::vector<ChunkCoord> all = settling.loose_chunks;
  all.insert(all.end(), settling.chunks.begin(), settling.chunks.end());
  std::ranges::sort(all);
  const auto touched = with_settling(touched_voxels(corner).value(), settling.loose);
  REQUIRE(all.size() == touched.size());
  for (std::size_t i = 0; i < all.size(); ++i) CHECK(all[i] == touched[i].chunk);
  CHECK(all.size() == 12);
  CHECK(extent_of(filling({0, 0, 0}, {64 * 32, 0, 0}), true).voxels == 64 * 32 + 1);
  CHECK_FALSE(extent_of(filling({0, 0, 0}, {64 * 32, 0, 0}), true).loose);
}

TEST_CASE("the chunks beside an edit are those of the voxels beside its own") {
  const auto beside_of = [](const Edit& edit, bool settles) {
    const Extent extent = extent_of(edit, settles);
    const auto around = with_neighbours(with_settling(touched_voxels(edit).value(), extent.loose));
    std::vector<ChunkCoord> all = extent.chunks;
    all.insert(all.end(), extent.loose_chunks.begin(), extent.loose_chunks.end());
    const auto beside = chunks_beside(edit, extent);
    all.insert(all.end(), beside.begin(), beside.end());
    std::ranges::sort(all);
    REQUIRE(all.size() == around.size());
    for (std::size_t i = 0; i < all.size(); ++i) CHECK(all[i] == around[i].chunk);
    return beside.size();
  };
  CHECK(beside_of(filling({5, 5, 5}, {9, 9, 9}), false) == 0);
  CHECK(beside_of(filling({0, 0, 0}, {31, 31, 31}), false) == 6);
  Edit edit = filling({-3, 0, 5}, {40, 2, 5});
  edit.writes.push_back({{31, 64, 0}, kStone});
  edit.guards.push_back({{100, 31, -1}, kStone});
  CHECK(beside_of(edit, false) == 8);
  CHECK(beside_of(filling({24, 40, 24}, {24, 40, 24}), true) > 0);
  for (const std::int64_t end : {std::int64_t{-kWorldEnd}, std::int64_t{kWorldEnd} - 1}) {
    CHECK(beside_of(filling({end, 5, 5}, {end, 5, 5}), false) == 0);
  }
  // Never more than an edit may reach.
  const Edit line = filling({0, 0, 0}, {40 * 32 - 1, 0, 0});
  CHECK(chunks_beside(line, extent_of(line, false)).size() == kMaxChunks - 40);
}

TEST_CASE("a world names the rows and materials that edits may use") {
  const std::vector<MaterialId> materials{kAir, kStone, MaterialId{300}};
  const EditRules rules{{-10, 100}, materials};
  const auto refused = [&](const Edit& edit) {
    const auto checked = check(edit, rules);
    return checked ? std::string{} : checked.error().message;
  };
  CHECK(refused(filling({0, -4106, 0}, {0, 4196, 0})).empty());
  CHECK(refused(filling({0, -4107, 0}, {0, 0, 0})) ==
        "fill 0: voxel y is -4107; in this world it must lie in -4106 to 4196");
  CHECK(refused(filling({0, 0, 0}, {0, 4197, 0})) ==
        "fill 0: voxel y is 4197; in this world it must lie in -4106 to 4196");
  Edit edit = filling({0, 0, 0}, {0, 0, 0});
  edit.fills[0].material = MaterialId{4};
  CHECK(refused(edit) ==
        "fill 0: material 4 is not in this world; it must be an id of its list of materials");
  edit.fills[0] = {{0, 0, 0}, {0, 0, 0}, {}, MaterialId{4}};
  CHECK(refused(edit).starts_with("fill 0: material 4"));
  edit.fills[0].only = MaterialId{300};
  CHECK(refused(edit).empty());
  edit.writes.push_back({{0, 0, 0}, MaterialId{301}});
  CHECK(refused(edit).starts_with("write 0: material 301"));
  edit.guards.push_back({{0, 5000, 0}, kStone});
  CHECK(refused(edit).starts_with("guard 0: voxel y is 5000"));
  Edit pasting;
  pasting.paste = Paste{{0, 0, 0}, Chunk::uniform(MaterialId{9}), false};
  CHECK(refused(pasting).starts_with("paste: material 9"));
  pasting.paste = Paste{{0, 4166, 0}, Chunk::uniform(kStone), false};
  CHECK(refused(pasting).starts_with("paste: voxel y is 4197"));
}

}  // namespace talus::edits
