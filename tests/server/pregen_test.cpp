#include "chunks/pregen.h"

#include <catch2/catch.hpp>
#include <map>
#include <set>

#include "fake_generator.h"
#include "runtime/manual_clock.h"
#include "scratch_directory.h"

using namespace talus;
using namespace talus::server;
using namespace std::chrono_literals;

namespace {

/// A service on a fake generator whose columns have the rows 2 to 3 mixed.
struct Bench {
  ScratchDirectory scratch;
  FakeService fake{4};
  std::atomic<bool> others{false};
  /// What the file says whenever what was made is to be kept, and how far the work is then.
  std::vector<std::pair<std::uint64_t, int>> kept;
  PregenPlan plan;
  Pregen pregen{{fake.service, [this] { return others.load(); }, fake.clock, 2, scratch / "pregen",
                 [this] {
                   kept.emplace_back(read_pregen_file(scratch / "pregen", plan, 4),
                                     fake.work->patches.load());
                 }}};

  Bench() {
    fake.work->first_mixed = 2;
    fake.work->last_mixed = 3;
    fake.work->last_mixed_anywhere = 100;
  }
};

PregenPlan around(std::int32_t x, std::int32_t z, std::int32_t radius, int levels = 1) {
  return {.x = x, .z = z, .radius = radius, .levels = levels};
}

}  // namespace

TEST_CASE("squares: each once, rings around the middle, all that the radius touches") {
  for (const PregenPlan& plan : {around(0, 0, 1), around(-70, 1000, 500, 3), around(127, -129, 128)}) {
    const int tiles = 4;
    const PregenSquares squares{plan, tiles};
    std::map<int, std::set<std::pair<std::int32_t, std::int32_t>>> seen;
    std::map<int, std::int64_t> ring;
    for (std::uint64_t i = 0; i < squares.size(); ++i) {
      const ChunkKey corner = squares.at(i);
      const int level = corner.lod.value();
      REQUIRE(corner.coord.x % tiles == 0);
      REQUIRE(corner.coord.z % tiles == 0);
      REQUIRE(seen[level].emplace(corner.coord.x, corner.coord.z).second);
      const std::int64_t square = 32 * tiles << level;
      const auto away = [&](std::int32_t at, std::int32_t middle) {
        const auto floor = [](std::int64_t a, std::int64_t b) { return (a - ((a % b) + b) % b) / b; };
        return std::abs(floor(std::int64_t{at} * 32 << level, square) - floor(middle, square));
      };
      const std::int64_t now = std::max(away(corner.coord.x, plan.x), away(corner.coord.z, plan.z));
      REQUIRE(now >= ring[level]);
      ring[level] = now;
    }
    REQUIRE(seen.size() == static_cast<std::size_t>(plan.levels));
    for (const auto& [level, corners] : seen) {
      const std::int64_t square = 32 * tiles << level;
      for (const std::int32_t dx : {-plan.radius, 0, plan.radius}) {
        for (const std::int32_t dz : {-plan.radius, 0, plan.radius}) {
          const auto corner = [&](std::int64_t at) {
            return static_cast<std::int32_t>((at - ((at % square) + square) % square) / square * tiles);
          };
          CHECK(corners.contains({corner(std::int64_t{plan.x} + dx), corner(std::int64_t{plan.z} + dz)}));
        }
      }
    }
  }
}

TEST_CASE("squares at the world's ends are all within it") {
  const PregenPlan plan = around(INT32_MAX, INT32_MIN, PregenPlan::kMaxRadius, Lod::kMax + 1);
  const PregenSquares squares{plan, 4};
  for (std::uint64_t i = 0; i < squares.size(); i += 997) {
    const ChunkKey corner = squares.at(i);
    const std::int64_t end = std::int64_t{1} << (31 - corner.lod.value());
    CHECK(std::int64_t{corner.coord.x} * 32 >= -end);
    CHECK((std::int64_t{corner.coord.x} + 4) * 32 <= end);
    CHECK(std::int64_t{corner.coord.z} * 32 >= -end);
    CHECK((std::int64_t{corner.coord.z} + 4) * 32 <= end);
  }
}

TEST_CASE("every mixed chunk of the plan is made, and a second run makes no chunk") {
  Bench bench;
  const PregenPlan plan = around(0, 0, 200);
  std::uint64_t reported = 0;
  const auto done = bench.pregen.run(plan, [&](const PregenProgress& progress) {
    CHECK(progress.squares >= reported);
    reported = progress.squares;
    return true;
  });
  REQUIRE(done.has_value());
  CHECK(done->squares == done->of);
  CHECK(reported == done->of);
  CHECK(done->columns == 16 * done->of);
  for (std::int32_t x = -7; x <= 6; ++x) {
    for (std::int32_t z = -7; z <= 6; ++z) {
      for (const std::int32_t y : {2, 3})
        CHECK(bench.fake.service.find({{x, y, z}, Lod{}}, Version::generated) != nullptr);
    }
  }
  const int patches = bench.fake.work->patches;
  const auto again = bench.pregen.run(plan, [](const PregenProgress&) { return true; });
  REQUIRE(again.has_value());
  CHECK(again->columns == 0);
  CHECK(bench.fake.work->patches == patches);
}

TEST_CASE("a pregen that ended early resumes there; another plan begins anew") {
  Bench bench;
  const PregenPlan plan = around(0, 0, 1'000);
  const auto early =
      bench.pregen.run(plan, [](const PregenProgress& progress) { return progress.squares < 20; });
  REQUIRE(early.has_value());
  CHECK(early->squares >= 20);
  CHECK(early->squares < early->of);
  CHECK(read_pregen_file(bench.scratch / "pregen", plan, 4) == early->squares);
  CHECK(read_pregen_file(bench.scratch / "pregen", around(0, 0, 1'001), 4) == 0);
  CHECK(read_pregen_file(bench.scratch / "pregen", plan, 2) == 0);
  const auto rest = bench.pregen.run(plan, [](const PregenProgress&) { return true; });
  REQUIRE(rest.has_value());
  CHECK(rest->squares == rest->of);
  CHECK(rest->columns == 16 * (rest->of - early->squares));
}

TEST_CASE("the file never says more than was kept") {
  Bench bench;
  bench.plan = around(0, 0, 1'500);
  const auto done = bench.pregen.run(bench.plan, [&](const PregenProgress&) {
    bench.fake.clock.advance(3s);
    return true;
  });
  REQUIRE(done.has_value());
  REQUIRE(bench.kept.size() > 3);
  std::uint64_t patches_before = 0;
  for (const auto& [said, patches] : bench.kept) {
    CHECK(said <= patches_before);
    patches_before = static_cast<std::uint64_t>(patches);
  }
}

TEST_CASE("while others wait for the generators nothing is begun") {
  Bench bench;
  bench.others = true;
  int asked = 0;
  const auto none = bench.pregen.run(around(0, 0, 100), [&](const PregenProgress&) { return ++asked < 3; });
  REQUIRE(none.has_value());
  CHECK(none->squares == 0);
  CHECK(bench.fake.work->patches == 0);
}

TEST_CASE("plans out of range are refused by the flag's name") {
  CHECK(around(0, 0, 1).check().has_value());
  CHECK(around(0, 0, 0).check().error().starts_with("--radius"));
  CHECK(around(0, 0, PregenPlan::kMaxRadius + 1).check().error().starts_with("--radius"));
  CHECK(around(0, 0, 1, 8).check().error().starts_with("--levels"));
  PregenPlan plan = around(0, 0, 1);
  for (const double share : {0.0, 1e-300, -1.0, 1.5, std::numeric_limits<double>::quiet_NaN()}) {
    plan.share = share;
    CHECK(plan.check().error().starts_with("--share: "));
  }
}
