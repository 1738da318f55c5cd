// Caves by the kernels of every instruction set are those of the definition (docs/DESIGN.md, "Caves").
#include <rapidcheck.h>
#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <vector>

#include <talus/terrain/boundary_row.h>
#include <talus/terrain/world.h>
#include <talus/vectors/instruction_set.h>
#include <talus/vectors/tables.h>

#include "features/carried_roofs.h"
#include "kernels/caves.h"

namespace talus::terrain {
namespace {

constexpr std::int64_t kOne = 1 << 16;

std::int64_t noise_of(float value) {
  return static_cast<std::int64_t>(value * static_cast<float>(kNoiseOne));
}
std::int64_t bulge(std::int64_t share) {
  return kOne - (((kOne - share) * (kOne - share)) >> 16);
}

struct Air {
  std::int64_t floor_fx = 0;
  std::int64_t roof_fx = 0;
};

Air air_by_definition(const CavePlan& plan, float tunnel, float chamber, float climb, int level) {
  const std::int64_t in_tunnel = plan.half_width_noise - std::abs(noise_of(tunnel));
  const std::int64_t in_chamber = noise_of(chamber) - plan.threshold_noise;
  if (in_tunnel <= 0 && in_chamber <= 0) return {};
  const std::int64_t up = std::clamp<std::int64_t>(kOne / 2 + 4 * noise_of(climb), 0, kOne);
  const std::int64_t middle = plan.low_fx + ((plan.climb_fx * up) >> 16);
  std::int64_t rise = 0;
  std::int64_t drop = 0;
  const auto widen = [&](std::int64_t height, std::int64_t depth, std::int64_t whole) {
    if (depth <= 0) return;
    const std::int64_t dome = bulge(std::min(kOne, (depth << 16) / whole));
    const std::int64_t high = (height * dome) >> 16;
    rise = std::max(rise, high - high / 4);
    drop = std::max(drop, ((height * bulge(dome)) >> 16) / 4);
  };
  widen(plan.height_fx, in_tunnel, plan.half_width_noise);
  widen(plan.chamber_height_fx, in_chamber, kNoiseOne / 6);
  const std::int64_t floor = std::max<std::int64_t>(kSubvoxels, middle - drop);
  const std::int64_t roof = std::max(floor, middle + rise);
  return {std::max<std::int64_t>(kSubvoxels, floor >> level), roof >> level};
}

std::int32_t any_of(std::int32_t least, std::int32_t most) {
  return *rc::gen::oneOf(rc::gen::inRange(least, most + 1), rc::gen::element(least, most));
}

CavePlan any_plan() {
  CavePlan plan;
  plan.low_fx = any_of(0, 1 << 23);
  plan.climb_fx = any_of(0, (1 << 23) - plan.low_fx);
  plan.half_width_noise = any_of(8, kNoiseOne / 4);
  plan.height_fx = any_of(kSubvoxels, 1 << 20);
  plan.threshold_noise = any_of(0, kNoiseOne);
  plan.chamber_height_fx = any_of(kSubvoxels, 1 << 20);
  return plan;
}

/// Near `middle` more often than elsewhere.
std::vector<float> any_noise(std::size_t width, std::int32_t middle) {
  std::vector<float> values(padded(width));
  for (float& value : values) {
    const auto parts = *rc::gen::oneOf(rc::gen::inRange(-kNoiseOne, kNoiseOne + 1),
                                       rc::gen::inRange(middle - 40, middle + 41));
    value = static_cast<float>(parts) / static_cast<float>(kNoiseOne);
  }
  return values;
}

TEST_CASE("The shape of caves is the definition's by every instruction set") {
  CHECK(rc::check([] {
    const CavePlan plan = any_plan();
    const auto width = *rc::gen::inRange<std::size_t>(1, 150);
    const std::vector<float> tunnels = any_noise(width, *rc::gen::element(0, plan.half_width_noise));
    const std::vector<float> chambers = any_noise(width, plan.threshold_noise);
    const std::vector<float> climb = any_noise(width, *rc::gen::element(-kNoiseOne / 2, kNoiseOne / 2));
    const CaveNoises noises{tunnels.data(), chambers.data(), climb.data()};
    const ColumnRange within{*rc::gen::inRange<std::size_t>(0, width), width};
    const int level = *rc::gen::inRange(0, 7);
    for (const auto set : kInstructionSets) {
      if (!runs_here(set)) continue;
      const CaveKernels& kernels = cave_kernels(set);
      std::vector<std::int32_t> floor(width);
      std::vector<std::int32_t> roof(width);
      const ColumnRange found = kernels.find(plan, noises, within);
      RC_ASSERT(found.last == 0 || (found.first >= within.first && found.last <= within.last));
      kernels.shape(plan, noises, found, level, floor.data(), roof.data());
      for (std::size_t x = 0; x < width; ++x) {
        const Air air =
            x < within.first ? Air{} : air_by_definition(plan, tunnels[x], chambers[x], climb[x], level);
        RC_ASSERT(floor[x] == air.floor_fx);
        RC_ASSERT(roof[x] == air.roof_fx);
      }
    }
  }));
}

// Of few depths a quotient of floats is rounded up to the next integer.
TEST_CASE("The shape of tunnels is the definition's at every depth") {
  for (std::int32_t half_width = 513; half_width <= kNoiseOne / 4; half_width += 97) {
    CavePlan plan;
    plan.half_width_noise = half_width;
    plan.height_fx = 1 << 20;
    plan.threshold_noise = kNoiseOne;
    const auto width = static_cast<std::size_t>(half_width);
    std::vector<float> tunnels(padded(width));
    for (std::size_t x = 0; x < width; ++x) {
      tunnels[x] = static_cast<float>(x) / static_cast<float>(kNoiseOne);
    }
    const std::vector<float> level(padded(width));
    for (const auto set : kInstructionSets) {
      if (!runs_here(set)) continue;
      std::vector<std::int32_t> floor(width);
      std::vector<std::int32_t> roof(width);
      cave_kernels(set).shape(plan, {tunnels.data(), level.data(), level.data()}, {0, width}, 0, floor.data(),
                              roof.data());
      std::size_t wrong = 0;
      for (std::size_t x = 0; x < width; ++x) {
        const Air air = air_by_definition(plan, tunnels[x], 0, 0, 0);
        wrong += floor[x] == air.floor_fx && roof[x] == air.roof_fx ? 0 : 1;
      }
      CHECK(wrong == 0);
    }
  }
}

enum class Kind { solid, roofed, open };

struct Columns {
  int width = 0;
  int depth = 0;
  std::vector<Kind> kinds;
  std::vector<std::int32_t> roof_row;
  std::vector<std::int32_t> rock_row;

  [[nodiscard]] std::size_t at(int x, int z) const { return static_cast<std::size_t>(z * width + x); }
  [[nodiscard]] bool holds(int x, int z) const { return x >= 0 && x < width && z >= 0 && z < depth; }
  [[nodiscard]] bool touch(std::size_t i, std::size_t j) const {
    return std::max(roof_row[i], roof_row[j]) < std::min(rock_row[i], rock_row[j]);
  }

  /// Whether a line from (x, z) ends beside a solid column.
  [[nodiscard]] bool carried(int x, int z, int east, int south, int span) const {
    for (int far = 1; far <= span; ++far) {
      const std::size_t here = at(x, z);
      x += east;
      z += south;
      if (!holds(x, z) || !touch(here, at(x, z)) || kinds[at(x, z)] == Kind::open) return false;
      if (kinds[at(x, z)] == Kind::solid) return true;
    }
    return false;
  }
  [[nodiscard]] bool carried(int x, int z, int span) const {
    return carried(x, z, -1, 0, span) || carried(x, z, 1, 0, span) || carried(x, z, 0, -1, span) ||
           carried(x, z, 0, 1, span);
  }
};

/// Heights have a column and a row around the judged ones.
struct Ground {
  Field height;
  Field floor;
  Field roof;
};

Ground any_ground(int width, int depth) {
  Ground ground{Field{width + 2, depth + 2}, Field{width, depth}, Field{width, depth}};
  const auto rows = [](int least, int most) {
    return *rc::gen::inRange(least * kSubvoxels, most * kSubvoxels);
  };
  for (std::int32_t& height : ground.height.values) height = rows(8, 26);
  for (std::size_t i = 0; i < ground.floor.values.size(); ++i) {
    if (*rc::gen::inRange(0, 4) == 0) continue;
    ground.floor.values[i] = rows(1, 12);
    ground.roof.values[i] = ground.floor.values[i] + rows(0, 9);
  }
  return ground;
}

Columns judged_by_definition(const Ground& ground, const RoofRules& rules) {
  Columns columns{ground.floor.width, ground.floor.depth, {}, {}, {}};
  for (int z = 0; z < columns.depth; ++z) {
    for (int x = 0; x < columns.width; ++x) {
      std::int32_t lowest = 1 << 30;
      for (int south = 0; south < 3; ++south) {
        for (int east = 0; east < 3; ++east) lowest = std::min(lowest, ground.height.at(x + east, z + south));
      }
      const std::int32_t surface = ground.height.at(x + 1, z + 1) >> rules.level;
      lowest >>= rules.level;
      const bool dry = !rules.shore || lowest - rules.sunk_fx > rules.sea_fx;
      const std::int32_t floor = boundary_row(ground.floor.at(x, z));
      const std::int32_t roof = boundary_row(ground.roof.at(x, z));
      std::int32_t rock = boundary_row(surface - rules.loose_fx);
      Kind kind = Kind::solid;
      if (floor < roof && rock - floor >= rules.min_rows) {
        if (!dry) rock = std::min(rock, boundary_row(lowest - rules.loose_fx));
        if (rock - roof >= rules.min_rows) {
          kind = Kind::roofed;
        } else if (dry) {
          kind = Kind::open;
        }
      }
      columns.kinds.push_back(kind);
      columns.roof_row.push_back(kind == Kind::roofed ? roof : kFarBelow);
      columns.rock_row.push_back(kind == Kind::open ? kFarBelow : rock);
    }
  }
  return columns;
}

bool is_set(const ColumnBits& bits, int x, int z) {
  return (bits.from(z, x) & 1) != 0;
}

TEST_CASE("Roofs are judged, and carried, by every instruction set as by the definition") {
  CHECK(rc::check([] {
    const int width = *rc::gen::inRange(1, 150);
    const int depth = *rc::gen::inRange(1, 6);
    const int span = *rc::gen::element(1, 2, 5, 64, 70);
    const Ground ground = any_ground(width, depth);
    RoofRules rules;
    rules.level = *rc::gen::inRange(0, 2);
    rules.loose_fx = *rc::gen::inRange(0, 3 * kSubvoxels);
    rules.sunk_fx = *rc::gen::element(0, rules.loose_fx);
    rules.min_rows = *rc::gen::inRange(2, 5);
    rules.shore = *rc::gen::arbitrary<bool>();
    rules.sea_fx = (12 * kSubvoxels) >> rules.level;
    const Columns expected = judged_by_definition(ground, rules);
    for (const auto set : kInstructionSets) {
      if (!runs_here(set)) continue;
      const CaveKernels& kernels = cave_kernels(set);
      Field roof = ground.roof;
      Field roof_row{width, depth};
      Field rock_row{width, depth};
      CarriedRoofs roofs;
      roofs.start(width, depth);
      const auto count = static_cast<std::size_t>(width);
      for (int z = 0; z < depth; ++z) {
        const auto heights = [&](int row) { return ground.height.row(row).data() + 1; };
        HeightsAround around{nullptr, heights(z + 1), nullptr};
        if (rules.shore) around = {heights(z), heights(z + 1), heights(z + 2)};
        kernels.judge(rules, around, count,
                      {ground.floor.row(z).data(), roof.row(z).data(), roof_row.row(z).data(),
                       rock_row.row(z).data(), roofs.roofed().row(z), roofs.open().row(z)});
      }
      for (int z = 0; z < depth; ++z) {
        const std::int32_t* const own_roof = roof_row.row(z).data();
        const std::int32_t* const own_rock = rock_row.row(z).data();
        kernels.touch(own_roof, own_rock, own_roof + 1, own_rock + 1, count - 1, roofs.touches_east().row(z));
        if (z + 1 == depth) continue;
        kernels.touch(own_roof, own_rock, roof_row.row(z + 1).data(), rock_row.row(z + 1).data(), count,
                      roofs.touches_south().row(z));
      }
      roofs.find(0, depth, span);
      for (int z = 0; z < depth; ++z) {
        RC_ASSERT(kernels.lowest(ground.height.row(z).data(), count + 2) ==
                  *std::min_element(ground.height.row(z).begin(), ground.height.row(z).end()));
        for (int x = 0; x < width; ++x) {
          const std::size_t i = expected.at(x, z);
          const Kind kind = expected.kinds[i];
          RC_ASSERT(is_set(roofs.roofed(), x, z) == (kind == Kind::roofed));
          RC_ASSERT(is_set(roofs.open(), x, z) == (kind == Kind::open));
          RC_ASSERT(roof_row.values[i] == expected.roof_row[i]);
          RC_ASSERT(rock_row.values[i] == expected.rock_row[i]);
          RC_ASSERT(roof.values[i] == (kind == Kind::open ? ground.height.at(x + 1, z + 1) >> rules.level
                                                          : ground.roof.values[i]));
          RC_ASSERT(is_set(roofs.carried(), x, z) == (kind == Kind::roofed && expected.carried(x, z, span)));
        }
      }
    }
  }));
}

}  // namespace
}  // namespace talus::terrain
