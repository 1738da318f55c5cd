#include "loose/aprons.h"

#include <rapidcheck.h>
#include <catch2/catch.hpp>

#include <algorithm>
#include <cstdlib>
#include <utility>
#include <vector>

namespace talus::terrain {
namespace {

constexpr std::int32_t kNever = std::int32_t{1} << 30;

// The definition, column by column over a plane of heights that is much larger than what is looked at.
class SlowAprons {
 public:
  SlowAprons(const Field& height, const Field& slope, const ApronNumbers& numbers)
      : height_{height},
        slope_{slope},
        numbers_{numbers},
        steps_{numbers.steps == 0 ? 0 : (numbers.max_fx - 1) / numbers.c_fx} {
    if (numbers.share_q8 == 0 || numbers.max_fx == 0) steps_ = 0;
    if (steps_ > 0) spread_aprons();
  }

  [[nodiscard]] std::int32_t raised(int x, int z) const {
    const std::int32_t h = height_.at(x, z);
    if (steps_ == 0 || top_.at(x, z) <= h) return h;
    std::int32_t sum = 0;
    each_of_nine([&](int i, int j) {
      const std::int32_t surface = std::max(surface_.at(x + i, z + j), top_.at(x + i, z + j));
      sum += surface * (2 - std::abs(i)) * (2 - std::abs(j));
    });
    const std::int32_t highest = std::min(sum >> 4, top_.at(x, z) + (numbers_.c_fx >> 1));
    return h + std::max(0, std::min(highest - h, h - numbers_.bare_fx));
  }

  // The nearest wall by all columns in reach.
  [[nodiscard]] std::int32_t cliff(int x, int z) const {
    if (numbers_.cliff_by_slope) {
      std::int64_t eighths = -8;
      for (const auto& [i, j] : {std::pair{-1, 0}, {1, 0}, {0, -1}, {0, 1}}) {
        if (numbers_.walls_beside.any == 0) continue;
        if (wall(x + i, z + j)) eighths += numbers_.walls_beside.any;
        if (slope_.at(x + i, z + j) > 2 * numbers_.wall_fx) eighths += numbers_.walls_beside.sheer;
      }
      const std::int64_t near = 16 * std::min(slope_.at(x, z), numbers_.wall_fx) + eighths * numbers_.wall_fx;
      return static_cast<std::int32_t>(kCliff * std::clamp<std::int64_t>(near, 0, 8 * numbers_.wall_fx) /
                                       (8 * numbers_.wall_fx));
    }
    const int d = numbers_.cliff_reach;
    if (d == 0) return 0;
    const std::int32_t straight = (kCliff + d - 1) / d;
    const std::int32_t slant = (straight * 362) >> 8;
    std::int32_t nearest = kCliff;
    for (int j = -d; j <= d; ++j) {
      for (int i = -d; i <= d; ++i) {
        if (!inside(x + i, z + j) || !wall(x + i, z + j)) continue;
        const int both = std::min(std::abs(i), std::abs(j));
        nearest = std::min(nearest, both * slant + (std::max(std::abs(i), std::abs(j)) - both) * straight);
      }
    }
    return kCliff - nearest;
  }

 private:
  template <class Visit>
  static void each_of_nine(const Visit& visit) {
    for (int j = -1; j <= 1; ++j) {
      for (int i = -1; i <= 1; ++i) visit(i, j);
    }
  }
  template <class Visit>
  void each(const Visit& visit) const {
    for (int z = 0; z < height_.depth; ++z) {
      for (int x = 0; x < height_.width; ++x) visit(x, z);
    }
  }
  [[nodiscard]] bool inside(int x, int z) const {
    return x >= 0 && z >= 0 && x < height_.width && z < height_.depth;
  }
  [[nodiscard]] bool wall(int x, int z) const { return slope_.at(x, z) > numbers_.wall_fx; }

  // Every second step goes along rows and columns alone.
  [[nodiscard]] static bool probes(int step, int i, int j) { return step % 2 == 1 || i == 0 || j == 0; }

  // The lowest ground that is no wall in `steps` steps from wall to wall.
  [[nodiscard]] Field feet() const {
    Field foot{height_.width, height_.depth};
    each([&](int x, int z) { foot.at(x, z) = wall(x, z) ? kNever : height_.at(x, z); });
    for (int step = 1; step <= numbers_.steps; ++step) {
      const Field before = foot;
      each([&](int x, int z) {
        if (!wall(x, z)) return;
        each_of_nine([&](int i, int j) {
          if (probes(step, i, j) && inside(x + i, z + j))
            foot.at(x, z) = std::min(foot.at(x, z), before.at(x + i, z + j));
        });
      });
    }
    return foot;
  }

  // The mean of `steps` columns of a line, the first at the column itself.
  [[nodiscard]] Field boxed(const Field& field, int along_x, int along_z) const {
    Field means{field.width, field.depth};
    each([&](int x, int z) {
      std::int64_t sum = 0;
      for (int i = 0; i < numbers_.steps; ++i) {
        sum +=
            field.at(std::min(x + i * along_x, field.width - 1), std::min(z + i * along_z, field.depth - 1));
      }
      means.at(x, z) = static_cast<std::int32_t>(sum / numbers_.steps);
    });
    return means;
  }

  void spread_aprons() {
    const Field foot = feet();
    // Twice along each axis, which is a tent that begins at the column.
    const Field tents = boxed(boxed(boxed(boxed(height_, 1, 0), 1, 0), 0, 1), 0, 1);
    const int before_tent = numbers_.steps - 1;
    top_ = Field{height_.width, height_.depth};
    surface_ = height_;
    Field bare{height_.width, height_.depth};
    each([&](int x, int z) {
      const std::int32_t h = height_.at(x, z);
      const std::int32_t f = foot.at(x, z);
      top_.at(x, z) = -kNever;
      if (!wall(x, z)) return;
      bare.at(x, z) = f == kNever ? 1 : 0;
      if (f >= h) return;
      const std::int32_t mean = tents.at(std::max(0, x - before_tent), std::max(0, z - before_tent));
      const std::int64_t share = (std::int64_t{std::max(0, mean - f)} * numbers_.share_q8) >> 8;
      const auto supply = static_cast<std::int32_t>(std::min<std::int64_t>(numbers_.max_fx, share));
      bare.at(x, z) = h >= f + supply ? 1 : 0;
      surface_.at(x, z) = std::min(h, f + supply);
      if (supply > 0) top_.at(x, z) = surface_.at(x, z);
    });
    const std::int32_t slant = (numbers_.c_fx * 362) >> 8;
    for (int step = 1; step <= steps_; ++step) {
      const Field before = top_;
      each([&](int x, int z) {
        if (bare.at(x, z) != 0) {
          top_.at(x, z) = -kNever;
          return;
        }
        std::int32_t reached = -kNever;
        each_of_nine([&](int i, int j) {
          if ((i == 0 && j == 0) || !probes(step, i, j) || !inside(x + i, z + j)) return;
          reached = std::max(reached, before.at(x + i, z + j) - (i != 0 && j != 0 ? slant : numbers_.c_fx));
        });
        const std::int32_t h = height_.at(x, z);
        if (reached <= h) return;
        top_.at(x, z) =
            std::max(top_.at(x, z), std::min(reached, h + numbers_.max_fx - numbers_.c_fx * step));
      });
    }
  }

  const Field& height_;
  const Field& slope_;
  ApronNumbers numbers_;
  int steps_;
  Field top_;
  Field surface_;
};

// Terraces whose walls are one column wide or more, ditches, lone peaks, and noise.
Field any_ground(int side) {
  Field height{side, side};
  const int kind = *rc::gen::element(0, 1, 1, 1, 2, 3);
  const int rough = *rc::gen::element(1, 20, 60, 250);
  const int apart = *rc::gen::inRange(4, 40);
  const int wide = *rc::gen::inRange(1, 10);
  const int tall = *rc::gen::element(500, 4000, 8000, 12000, 60000);
  const int aslant = *rc::gen::inRange(0, 4);
  auto state = static_cast<std::uint32_t>(*rc::gen::inRange(0, 1 << 20)) * 2654435761U + 1;
  const auto draw = [&](int most) {
    state = state * 1664525U + 1013904223U;
    return static_cast<std::int32_t>((state >> 8) % static_cast<std::uint32_t>(most));
  };
  for (int z = 0; z < side; ++z) {
    for (int x = 0; x < side; ++x) {
      const int along = x + z * aslant / 2;
      const int past = along % apart;
      std::int32_t h = draw(rough);
      if (kind == 0) h += draw(tall);
      if (kind == 1) h += along / apart * tall + std::min(past, wide) * tall / wide;
      if (kind == 2) h += past < wide ? tall : (past - wide) * 100;
      if (kind == 3) h += draw(6 * apart) == 0 ? tall : 0;
      height.at(x, z) = std::min(h, 1 << 23);
    }
  }
  return height;
}

// As slope_inside, but for a whole field: what lies past its edges does not rise.
Field slope_of(const Field& height) {
  Field slope{height.width, height.depth};
  for (int z = 0; z < height.depth; ++z) {
    for (int x = 0; x < height.width; ++x) {
      for (int j = std::max(0, z - 1); j <= std::min(height.depth - 1, z + 1); ++j) {
        for (int i = std::max(0, x - 1); i <= std::min(height.width - 1, x + 1); ++i) {
          slope.at(x, z) = std::max(slope.at(x, z), std::abs(height.at(i, j) - height.at(x, z)));
        }
      }
    }
  }
  return slope;
}

ApronNumbers any_numbers() {
  ApronNumbers numbers;
  numbers.wall_fx = *rc::gen::element(120, 284, 900);
  numbers.c_fx =
      *rc::gen::oneOf(rc::gen::inRange(60, 400), rc::gen::inRange(60, 400), rc::gen::inRange(60, 3000));
  numbers.max_fx = *rc::gen::oneOf(rc::gen::inRange(400, 2100), rc::gen::inRange(0, 2100));
  numbers.share_q8 = *rc::gen::element(0, 64, 192, 256, 1024);
  numbers.steps = *rc::gen::element(0, 1, 2, 4, 8, 8);
  numbers.bare_fx = *rc::gen::element(-(1 << 29), -(1 << 29), 300, 3000);
  numbers.cliff_reach = *rc::gen::inRange(0, 20);
  numbers.c_fx = std::max(numbers.c_fx, numbers.max_fx / 24);
  if (*rc::gen::inRange(0, 4) == 0) {
    numbers.cliff_by_slope = true;
    numbers.walls_beside = *rc::gen::element(WallsBeside{}, WallsBeside{8, 5}, WallsBeside{5, 2});
    numbers.cliff_reach = 0;
  }
  return numbers;
}

// The fields around columns (x, z) to (x + width, z + depth) of a plane.
Field part(const Field& plane, int x, int z, int width, int depth) {
  Field field{width, depth};
  for (int j = 0; j < depth; ++j) {
    for (int i = 0; i < width; ++i) field.at(i, j) = plane.at(x + i, z + j);
  }
  return field;
}

struct Results {
  Field raised;
  Field cliff;
  bool operator==(const Results& other) const {
    return raised.values == other.raised.values && cliff.values == other.cliff.values;
  }
};

struct Place {
  int x;
  int z;
  int width;
  int depth;
};

Results results_of(Aprons& aprons, const Field& height, const Field& slope, const Place& at, int margin,
                   const ApronNumbers& numbers, int cliff_ring = 0) {
  const auto around = [&](const Field& plane) {
    return part(plane, at.x - margin, at.z - margin, at.width + 2 * margin, at.depth + 2 * margin);
  };
  Results results;
  aprons.compute(around(height), around(slope), margin, numbers, results.raised, results.cliff, cliff_ring);
  return results;
}

Results slow_results(const SlowAprons& slow, const Place& at) {
  Results results{Field{at.width, at.depth}, Field{at.width, at.depth}};
  for (int z = 0; z < at.depth; ++z) {
    for (int x = 0; x < at.width; ++x) {
      results.raised.at(x, z) = slow.raised(at.x + x, at.z + z);
      results.cliff.at(x, z) = slow.cliff(at.x + x, at.z + z);
    }
  }
  return results;
}

constexpr int kFar = 48;  // beyond the halo of any_numbers

Place any_place() {
  return {kFar + *rc::gen::inRange(0, 6), kFar + *rc::gen::inRange(0, 6), *rc::gen::inRange(1, 40),
          *rc::gen::inRange(1, 12)};
}

TEST_CASE("Aprons with their halo are the plane's, column by column, by every instruction set") {
  CHECK(rc::check([] {
    const ApronNumbers numbers = any_numbers();
    const Field height = any_ground(2 * kFar + 46);
    const Field slope = slope_of(height);
    const Place at = any_place();
    const int halo = apron_halo(numbers);
    RC_ASSERT(halo < kFar);
    const Results expected = slow_results(SlowAprons{height, slope, numbers}, at);
    RC_CLASSIFY(expected.raised.values != part(height, at.x, at.z, at.width, at.depth).values, "raised");
    for (const auto set : kInstructionSets) {
      if (!runs_here(set)) continue;
      Aprons aprons{set};
      RC_ASSERT(results_of(aprons, height, slope, at, halo, numbers) == expected);
      // With more than it needs, too, in memory that has seen other ground.
      RC_ASSERT(results_of(aprons, height, slope, at, halo + 5, numbers) == expected);
      // And how near cliffs are in fewer columns.
      const Place wider{at.x - 1, at.z - 1, at.width + 2, at.depth + 2};
      RC_ASSERT(results_of(aprons, height, slope, wider, halo, numbers, 1).cliff.values ==
                expected.cliff.values);
    }
  }));
}

TEST_CASE("Neighbouring regions have the aprons of the whole") {
  CHECK(rc::check([] {
    const ApronNumbers numbers = any_numbers();
    const Field height = any_ground(2 * kFar + 46);
    const Field slope = slope_of(height);
    const Place whole = any_place();
    const int halo = apron_halo(numbers);
    const int cut = *rc::gen::inRange(0, whole.width);
    Aprons aprons{instruction_set()};
    const Results together = results_of(aprons, height, slope, whole, halo, numbers);
    for (const Place& at : {Place{whole.x, whole.z, cut, whole.depth},
                            Place{whole.x + cut, whole.z, whole.width - cut, whole.depth}}) {
      if (at.width == 0) continue;
      const Results alone = results_of(aprons, height, slope, at, halo, numbers);
      RC_ASSERT(alone.raised.values == part(together.raised, at.x - whole.x, 0, at.width, at.depth).values);
      RC_ASSERT(alone.cliff.values == part(together.cliff, at.x - whole.x, 0, at.width, at.depth).values);
    }
  }));
}

// What lies `ring` columns from a region, and farther, is another world's.
Results with_strange_ring(Field height, const ApronNumbers& numbers, const Place& at, int ring,
                          const Field& strange) {
  Field slope = slope_of(height);
  const Field other = slope_of(strange);
  for (int z = 0; z < height.depth; ++z) {
    for (int x = 0; x < height.width; ++x) {
      const bool near =
          x >= at.x - ring && x < at.x + at.width + ring && z >= at.z - ring && z < at.z + at.depth + ring;
      if (near) continue;
      height.at(x, z) = strange.at(x, z);
      slope.at(x, z) = other.at(x, z);
    }
  }
  Aprons aprons{instruction_set()};
  return results_of(aprons, height, slope, at, apron_halo(numbers), numbers);
}

TEST_CASE("Two columns less than the halo are too few for aprons, and for cliffs") {
  ApronNumbers numbers;
  numbers.wall_fx = 284;
  numbers.c_fx = 179;
  numbers.max_fx = 2048;
  numbers.share_q8 = 192;
  numbers.steps = 8;
  const bool cliffs = GENERATE(false, true);
  if (cliffs) {
    numbers.steps = 0;
    numbers.cliff_reach = 12;
  }
  const int halo = apron_halo(numbers);
  CHECK(halo == (cliffs ? 11 : 20));
  const Place at{kFar, kFar, 4, 4};
  int broken = 0;
  // Walls everywhere between the region and its edge, of any width.
  for (int edge = 1; edge < kFar; ++edge) {
    for (int wide = 1; wide < 12; ++wide) {
      Field height{2 * kFar + 4, 2 * kFar + 4};
      for (int z = 0; z < height.depth; ++z) {
        for (int x = 0; x < height.width; ++x) {
          height.at(x, z) = 9000 + std::clamp(kFar - edge - x, 0, wide) * 12000 / wide;
        }
      }
      Field strange = height;
      for (std::int32_t& h : strange.values) h = 1000;
      Aprons aprons{instruction_set()};
      const Results right = results_of(aprons, height, slope_of(height), at, halo, numbers);
      CHECK(with_strange_ring(height, numbers, at, halo, strange) == right);
      broken += with_strange_ring(height, numbers, at, halo - 2, strange) == right ? 0 : 1;
    }
  }
  CHECK(broken > 0);
}

TEST_CASE("An apron leans on its wall and falls outward at repose, and a mere slope has no apron") {
  ApronNumbers numbers;
  numbers.wall_fx = 284;
  numbers.c_fx = 179;
  numbers.max_fx = 2048;
  numbers.share_q8 = 256;
  numbers.steps = 8;
  const int halo = apron_halo(numbers);
  Aprons aprons{instruction_set()};
  Field height{60 + 2 * halo, 4 + 2 * halo};
  const auto raised = [&](const auto& height_at) {
    for (int z = 0; z < height.depth; ++z) {
      for (int x = 0; x < height.width; ++x) height.at(x, z) = height_at(x - halo);
    }
    Field out;
    Field cliff;
    aprons.compute(height, slope_of(height), halo, numbers, out, cliff);
    return out;
  };
  // A wall of 30 voxels over six columns, 20 to 26.
  const Field cliff = raised([](int x) { return 10000 + std::clamp(26 - x, 0, 6) * 1280; });
  int covered = 0;
  for (int x = 22; x < 45; ++x) {
    const std::int32_t before = 10000 + std::clamp(26 - x, 0, 6) * 1280;
    CHECK(cliff.at(x, 2) >= before);
    CHECK(cliff.at(x, 2) <= before + numbers.max_fx);
    CHECK(cliff.at(x, 2) <= cliff.at(x - 1, 2));  // no ridge
    if (x >= 27) CHECK(cliff.at(x - 1, 2) - cliff.at(x, 2) <= numbers.c_fx);
    covered += cliff.at(x, 2) > before ? 1 : 0;
  }
  CHECK(covered >= 5);
  for (int x = 0; x < 20; ++x) CHECK(cliff.at(x, 2) == 10000 + 6 * 1280);

  const Field slope = raised([](int x) { return 100000 - 300 * x; });
  CHECK(slope.values == height.cropped(halo).values);
}

TEST_CASE("Ground at the bare height has no scree, and that above it at most what it stands over it") {
  CHECK(rc::check([] {
    ApronNumbers numbers = any_numbers();
    const Field height = any_ground(2 * kFar + 46);
    const Place at = any_place();
    Aprons aprons{instruction_set()};
    const Results results = results_of(aprons, height, slope_of(height), at, apron_halo(numbers), numbers);
    for (int z = 0; z < at.depth; ++z) {
      for (int x = 0; x < at.width; ++x) {
        const std::int32_t h = height.at(at.x + x, at.z + z);
        const std::int32_t scree = results.raised.at(x, z) - h;
        RC_ASSERT(scree >= 0 && scree <= numbers.max_fx);
        RC_ASSERT(scree <= std::max(0, h - numbers.bare_fx));
      }
    }
  }));
}

TEST_CASE("Extreme heights, slopes and numbers give aprons without overflow") {
  ApronNumbers numbers;
  numbers.max_fx = GENERATE(1, 1 << 20);
  numbers.share_q8 = GENERATE(1, 1024);
  numbers.c_fx = GENERATE(1 << 16, 1 << 20);
  numbers.steps = GENERATE(1, 32);
  numbers.cliff_reach = GENERATE(1, 2, 4, 5);
  const int halo = apron_halo(numbers);
  Field height{9 + 2 * halo, 9 + 2 * halo};
  for (int z = 0; z < height.depth; ++z) {
    for (int x = 0; x < height.width; ++x) height.at(x, z) = (x + z) % 5 < 2 ? 1 << 23 : 0;
  }
  Results results;
  Aprons aprons{instruction_set()};
  const Field slope = slope_of(height);
  aprons.compute(height, slope, halo, numbers, results.raised, results.cliff);
  const Place at{halo, halo, 9, 9};
  CHECK(results == slow_results(SlowAprons{height, slope, numbers}, at));
}

TEST_CASE("At a level aprons lie on the same ground") {
  ApronNumbers numbers;
  numbers.c_fx = 179;
  numbers.max_fx = 2048;
  numbers.share_q8 = 192;
  numbers.steps = 8;
  numbers.cliff_reach = 12;
  CHECK(apron_halo(at_level(numbers, Lod::of(0))) == 20);
  CHECK(apron_halo(at_level(numbers, Lod::of(1))) == 4 + 5 + 1);
  CHECK(apron_halo(at_level(numbers, Lod::of(2))) == 2 + 2 + 1);
  CHECK(apron_halo(at_level(numbers, Lod::of(3))) == 1 + 1 + 1);
  CHECK(apron_halo(at_level(numbers, Lod::of(4))) == 1);
  CHECK(at_level(numbers, Lod::of(2)).cliff_reach == 3);
  CHECK(at_level(numbers, Lod::of(3)).cliff_by_slope);
  CHECK(apron_halo(at_level(numbers, Lod::of(5))) == 0);
  CHECK(apron_halo(ApronNumbers{}) == 0);
}

}  // namespace
}  // namespace talus::terrain
