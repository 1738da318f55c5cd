// Loose material after an edit: none is lost, none lies too steep, placed blocks hold, every node agrees.
#include <talus/edits/settle.h>

#include <map>
#include <random>

#include <rapidcheck.h>
#include <talus/edits/batch.h>
#include <catch2/catch.hpp>

#include "model.h"

namespace talus::edits {
namespace {

constexpr MaterialId kRock{2};
constexpr MaterialId kSand{3};
constexpr MaterialId kScree{4};
constexpr MaterialId kPlanks{300};
/// 32 and 40 degrees.
const SettleRules kRules{{kSand, 160}, {kScree, 215}};

/// A box with room to look at single voxels.
struct Land {
  VoxelBox box{{0, 0, 0}, {14, 31, 14}};
  std::vector<SettlingVoxel> voxels = std::vector<SettlingVoxel>(15 * 32 * 15);

  SettlingVoxel& at(int x, int y, int z) { return voxels[static_cast<std::size_t>((y * 15 + z) * 15 + x)]; }
  /// Up to `top` of rock, then of `loose`, as generated.
  void generate(int x, int z, int rock, int top, MaterialId loose = kSand) {
    for (int y = 0; y <= 31; ++y) {
      at(x, y, z).now = at(x, y, z).base = y < rock ? kRock : y < top ? loose : kAir;
    }
  }
  void put(int x, int y, int z, MaterialId material) {
    at(x, y, z).now = material;
    at(x, y, z).edited = true;
  }
  int settle() { return edits::settle(box, kRules, voxels).moves; }
  [[nodiscard]] std::map<MaterialId, int> counts() const {
    std::map<MaterialId, int> counts;
    for (const SettlingVoxel& each : voxels) ++counts[each.now];
    return counts;
  }
  /// The lowest row of a column from which on all is open.
  int top(int x, int z) {
    int y = 32;
    while (y > 0 && (at(x, y - 1, z).now == kAir || at(x, y - 1, z).now == kWater)) --y;
    return y;
  }
};

void flat(Land& land, int rock, int top, MaterialId loose = kSand) {
  for (int z = 0; z < 15; ++z) {
    for (int x = 0; x < 15; ++x) land.generate(x, z, rock, top, loose);
  }
}

std::int32_t rise_of(MaterialId material) {
  for (const SettleRule& rule : kRules) {
    if (rule.material == material) return rule.rise;
  }
  return 0;
}

/// The first voxel on top of a column that lies too steep over where there is less than was generated.
std::string too_steep(Land& land) {
  for (int z = 0; z < 15; ++z) {
    for (int x = 0; x < 15; ++x) {
      const int top = land.top(x, z);
      if (top < 2 || top == 32 || rise_of(land.at(x, top - 1, z).now) == 0) continue;
      for (int dz = -1; dz <= 1; ++dz) {
        for (int dx = -1; dx <= 1; ++dx) {
          for (int distance = 1; distance <= kSettleReach; ++distance) {
            const int to_x = x + dx * distance;
            const int to_z = z + dz * distance;
            if (to_x < 0 || to_x > 14 || to_z < 0 || to_z > 14) break;
            const int other = land.top(to_x, to_z);
            if (other >= top) break;  // it does not go over that
            if (other == 0) continue;
            const bool moved = land.at(x, top - 1, z).base == kAir || land.at(to_x, other, to_z).base != kAir;
            if (moved &&
                (top - 1 - other) * SettleRule::kUnit > rise_of(land.at(x, top - 1, z).now) * distance) {
              return "column " + std::to_string(x) + ", " + std::to_string(z) + " is " + std::to_string(top) +
                     " high, and " + std::to_string(to_x) + ", " + std::to_string(to_z) + " " +
                     std::to_string(other);
            }
          }
        }
      }
    }
  }
  return {};
}

}  // namespace

TEST_CASE("a hole in sand becomes a funnel as steep as sand lies") {
  Land land;
  flat(land, 4, 20);
  for (int y = 12; y < 20; ++y) land.put(7, y, 7, kAir);
  const auto before = land.counts();
  CHECK(land.settle() > 4);
  CHECK(land.counts() == before);
  CHECK(too_steep(land) == "");
  CHECK(land.top(7, 7) > 12);
  CHECK(land.top(7, 7) < 20);
  CHECK(land.top(0, 0) == 20);
  const std::vector<SettlingVoxel> rests = land.voxels;
  CHECK(land.settle() == 0);
}

TEST_CASE("sand that is put on a heap runs down, and scree lies steeper") {
  std::map<MaterialId, int> high;
  for (const MaterialId material : {kSand, kScree}) {
    Land land;
    flat(land, 4, 4);
    for (int y = 4; y < 24; ++y) land.put(7, y, 7, material);
    land.settle();
    CHECK(land.counts()[material] == 20);
    CHECK(too_steep(land) == "");
    high[material] = land.top(7, 7);
  }
  CHECK(high[kSand] < 10);
  CHECK(high[kSand] <= high[kScree]);
}

TEST_CASE("a slope steep as generated stays until something under it goes, and then the hollow wanders up") {
  Land land;
  for (int z = 0; z < 15; ++z) {
    for (int x = 0; x < 15; ++x) land.generate(x, z, 1 + 2 * x, 3 + 2 * x - (x == 14 ? 1 : 0));  // 63 degrees
  }
  Land before = land;
  land.at(3, 30, 3).edited = true;  // nothing changed there
  CHECK(land.settle() == 0);
  land.put(4, land.top(4, 7) - 1, 7, kAir);
  CHECK(land.settle() > 3);
  CHECK(land.counts()[kSand] == before.counts()[kSand] - 1);
  CHECK(land.top(4, 7) == before.top(4, 7));
  // Below the hole all is as it was.
  for (int z = 0; z < 15; ++z) {
    for (int x = 0; x < 4; ++x) CHECK(land.top(x, z) == before.top(x, z));
  }
}

TEST_CASE("material on dug sand falls, and rock and planks hold material that leans on them") {
  Land land;
  flat(land, 4, 12);
  SECTION("a tunnel falls in") {
    for (int x = 4; x < 10; ++x) land.put(x, 6, 7, kAir);
    land.settle();
    for (int x = 4; x < 10; ++x) CHECK(land.at(x, 6, 7).now == kSand);
  }
  SECTION("planks hold the roof, and the walls") {
    for (int z = 6; z <= 8; ++z) {
      for (int x = 4; x < 10; ++x) land.put(x, 8, z, kPlanks);
    }
    for (int x = 4; x < 10; ++x) {
      land.put(x, 7, 7, kAir);
      land.put(x, 7, 6, kPlanks);
      land.put(x, 7, 8, kPlanks);
    }
    land.put(3, 7, 7, kPlanks);
    land.put(10, 7, 7, kPlanks);
    CHECK(land.settle() == 0);
    CHECK(land.at(5, 9, 7).now == kSand);
  }
  SECTION("a wall of planks holds a bank of sand") {
    for (int z = 0; z < 15; ++z) {
      for (int x = 8; x < 15; ++x) {
        for (int y = 4; y < 12; ++y) land.put(x, y, z, kAir);
      }
      for (int y = 4; y < 12; ++y) land.put(8, y, z, kPlanks);
    }
    CHECK(land.settle() == 0);
    land.put(8, 11, 7, kAir);
    land.put(8, 10, 7, kAir);
    CHECK(land.settle() > 0);
    CHECK(land.top(12, 7) >= 4);
    CHECK(land.at(7, 11, 7).now == kAir);
  }
  SECTION("under water the place of what slides is water") {
    for (int z = 0; z < 15; ++z) {
      for (int x = 0; x < 15; ++x) {
        for (int y = 12; y < 20; ++y) land.at(x, y, z).now = land.at(x, y, z).base = kWater;
      }
    }
    for (int y = 8; y < 12; ++y) land.put(7, y, 7, kWater);
    CHECK(land.settle() > 0);
    CHECK(land.counts()[kAir] == 12 * 15 * 15);
    CHECK(too_steep(land) == "");
  }
}

TEST_CASE("random digging and building: no loose voxel is lost, none lies too steep, the others stay") {
  CHECK(rc::check([] {
    Land land;
    const int slope = *rc::gen::inRange(0, 300);
    for (int z = 0; z < 15; ++z) {
      for (int x = 0; x < 15; ++x) {
        const int rock = 3 + (x * slope + z * 40) / 256;
        const int loose = *rc::gen::inRange(0, 4);
        land.generate(x, z, rock, rock + loose, loose % 2 == 0 ? kSand : kScree);
      }
    }
    for (int left = *rc::gen::inRange(1, 60); left > 0; --left) {
      const int y = *rc::gen::inRange(2, 20);
      const MaterialId material = *rc::gen::element(kAir, kAir, kAir, kSand, kScree, kPlanks);
      land.put(*rc::gen::inRange(0, 15), y, *rc::gen::inRange(0, 15), material);
    }
    Land again = land;
    const Land before = land;
    const int moves = land.settle();
    RC_ASSERT(moves < kSettleMoves);
    RC_ASSERT(again.settle() == moves);
    RC_ASSERT(land.counts() == Land{before}.counts());
    for (std::size_t i = 0; i < land.voxels.size(); ++i) {
      RC_ASSERT(land.voxels[i].now == again.voxels[i].now);
      const MaterialId was = before.voxels[i].now;
      if (was == kRock || was == kPlanks) RC_ASSERT(land.voxels[i].now == was);
    }
    const std::string fault = too_steep(land);
    if (!fault.empty()) RC_FAIL(fault);
    RC_ASSERT(land.settle() == 0);
  }));
}

TEST_CASE("the cost of an edit is bounded, whatever its shape") {
  // Towers with gaps and shelves, where much is moved far, and little at a time.
  std::mt19937 random{5};
  int most = 0;
  for (int round = 0; round < 60; ++round) {
    const VoxelBox box{{0, 0, 0}, {15, 63, 15}};
    std::vector<SettlingVoxel> voxels;
    const std::uint32_t shelves = random() % 8;
    const std::uint32_t sand = 1 + random() % 8;
    const std::int64_t base = round % 4 == 0 ? 1 : random() % 40;
    for (std::int64_t y = 0; y < 64; ++y) {
      for (int i = 0; i < 256; ++i) {
        const bool on_shelf = random() % 64 < shelves;
        const bool is_sand = random() % 8 < sand && y < 50;
        const MaterialId now = y < base ? kRock : on_shelf ? kPlanks : is_sand ? kSand : kAir;
        voxels.push_back({now, y < base ? kRock : kAir, y >= base});
      }
    }
    const SettleWork settled = edits::settle(box, kRules, voxels);
    most = std::max(most, settled.probes);
    CHECK(settled.moves <= kSettleMoves);
    CHECK(settled.probes <= kSettleProbes + 1);
  }
  CHECK(most > kSettleProbes / 4);  // hard enough to mean something
}

TEST_CASE("a dig without loose material needs no voxel of the box, and only the base that it touches") {
  testing::State state;
  Edit edit;
  edit.writes.push_back({{5, 5, 5}, kAir});
  BaseVoxels base;
  const auto all = touched_voxels(edit);
  for (const TouchedChunk& each : *all) {
    for (const std::uint16_t index : each.voxels) base[each.chunk].push_back({index, kRock});
  }
  const auto outcome = evaluate(edit, base, state, &kRules);
  REQUIRE(outcome.has_value());
  CHECK(outcome->changed == 1);
}

TEST_CASE("placed sand slides on land without sand") {
  testing::State state;
  Editors editors;
  Batch batch{state, editors, {}, 1};
  batch.apply(AttachEntry{{1, 1}, 1, ""});
  const auto entry_of = [](std::uint64_t sequence, Edit edit) {
    EditEntry entry{{1, 1}, 1, sequence, std::move(edit), {}, std::make_shared<const SettleRules>(kRules)};
    for (const TouchedChunk& each :
         with_settling(touched_voxels(entry.edit).value(), settle_box(entry.edit))) {
      const VoxelPos origin = chunk_origin(each.chunk);
      for (const std::uint16_t index : each.voxels) {
        entry.base[each.chunk].push_back({index, origin.y + index / 1024 < 10 ? kRock : kAir});
      }
    }
    return entry;
  };
  Edit put;
  put.writes.push_back({{5, 10, 5}, kSand});
  CHECK(batch.apply(entry_of(1, put)).result.changed == 1);
  Edit dig;
  dig.writes.push_back({{5, 9, 5}, kAir});
  const EntryResult& applied = batch.apply(entry_of(2, dig));
  REQUIRE(applied.changes.size() == 1);
  CHECK(applied.changes[0].voxels.size() == 2);  // the rock is sand, and the sand is gone
  CHECK(applied.changes[0].voxels[0].after == kSand);
  CHECK(applied.changes[0].voxels[1].after == kAir);
}

TEST_CASE("an edit settles in a box of 64 rows and 256 columns at most, around all that it writes") {
  Edit edit;
  edit.writes.push_back({{100, 20, -40}, kAir});
  CHECK(settle_box(edit) == VoxelBox{{93, -1, -47}, {107, 62, -33}});
  edit.fills.push_back({{100, 20, -40}, {109, 25, -31}, kAir, {}});
  CHECK(settle_box(edit) == VoxelBox{{97, 1, -43}, {112, 64, -28}});
  edit.fills.push_back({{100, 20, -40}, {100, 20, -10}, kAir, {}});
  CHECK_FALSE(settle_box(edit).has_value());
  edit.fills = {{{0, 0, 0}, {0, 64, 0}, kAir, {}}};
  edit.writes.clear();
  CHECK_FALSE(settle_box(edit).has_value());
  edit.fills = {{{(std::int64_t{1} << 36) - 2, 0, 0}, {(std::int64_t{1} << 36) - 2, 0, 0}, kAir, {}}};
  CHECK_FALSE(settle_box(edit).has_value());
  Edit guards;
  guards.guards.push_back({{0, 0, 0}, kAir});
  CHECK_FALSE(settle_box(guards).has_value());
}

TEST_CASE("an entry with rules settles where it is applied, all in one edit, and lacks no base") {
  testing::State state;
  Editors editors;
  const auto sand_below = [](std::int64_t y) { return y < 10 ? kRock : y < 40 ? kSand : kAir; };
  EditEntry entry{{1, 1}, 1, 1, {}, {}, std::make_shared<const SettleRules>(kRules)};
  entry.edit.fills.push_back({{30, 34, 30}, {34, 39, 34}, kAir, {}});
  const auto touched = with_settling(touched_voxels(entry.edit).value(), settle_box(entry.edit));
  for (const TouchedChunk& each : touched) {
    const VoxelPos origin = chunk_origin(each.chunk);
    for (const std::uint16_t index : each.voxels) {
      entry.base[each.chunk].push_back({index, sand_below(origin.y + index / 1024)});
    }
  }
  Batch batch{state, editors, {}, 1};
  batch.apply(AttachEntry{{1, 1}, 1, ""});
  const EntryResult& applied = batch.apply(entry);
  REQUIRE(applied.kind == EntryResult::Kind::done);
  CHECK(applied.revision == 1);
  std::map<MaterialId, int> became;
  int outside = 0;
  for (const ChunkChanges& chunk : applied.changes) {
    for (const VoxelChange& voxel : chunk.voxels) {
      const std::int64_t x = chunk_origin(chunk.chunk).x + voxel.index % 32;
      const std::int64_t z = chunk_origin(chunk.chunk).z + voxel.index / 32 % 32;
      outside += x < 30 || x > 34 || z < 30 || z > 34 ? 1 : 0;
      ++became[voxel.after];
      --became[voxel.before];
    }
  }
  CHECK(became[kSand] == -150);  // what was dug, and no more
  CHECK(outside > 30);
  EditEntry lacks = entry;
  lacks.sequence = 2;
  lacks.base.erase(lacks.base.begin());
  CHECK(batch.apply(lacks).kind == EntryResult::Kind::invalid);
  EditEntry without = entry;
  without.sequence = 3;
  without.settles = nullptr;
  without.edit.fills = {{{30, 33, 30}, {30, 33, 30}, kAir, {}}};
  CHECK(batch.apply(without).result.changed == 1);
}

}  // namespace talus::edits
