// Looks, provinces and shares: what a place decides, by the rules of the spec, read one by one.
#include <rapidcheck.h>
#include <catch2/catch.hpp>

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include <talus/terrain/boundary_row.h>
#include <talus/terrain/extraction.h>
#include <talus/terrain/generator.h>
#include <talus/terrain/places.h>
#include <talus/terrain/settle.h>
#include <talus/terrain/slope.h>
#include <talus/terrain/world.h>

#include "kernels/places.h"
#include "place/narrowed_cases.h"
#include "worlds.h"
#include "wrong_spec.h"

namespace talus::terrain {
namespace {

World parsed_places(const std::string& text) {
  auto world = World::parse(text, "w.toml");
  INFO((world ? "" : world.error().message));
  REQUIRE(world.has_value());
  return *std::move(world);
}

// A world in which a patch has many looks, all three kinds of strata and ice.
std::string places_text() {
  // Without what else changes voxels.
  const std::string text =
      test::sample_world_without("default", {"[caves]", "[[veins]]", "[talus]", "[[object]]"});
  return test::replaced(text, "where = { cliff = [0.75, 0.15] }", "");
}

Region any_region(Lod lod) {
  const std::int64_t far = std::int64_t{1} << (36 - lod.value());
  const auto place = [&] {
    return *rc::gen::weightedOneOf<std::int64_t>({{4, rc::gen::inRange<std::int64_t>(-40000, 40000)},
                                                  {1, rc::gen::just(far)},
                                                  {1, rc::gen::just(-far)}});
  };
  const std::int64_t x = place();
  const std::int64_t z = place();
  return {x, z, *rc::gen::inRange(1, 40), *rc::gen::inRange(1, 40), lod};
}

// The first case all of whose conditions hold.
std::uint8_t look_by(const LookRules& rules, const std::vector<float>& quantities) {
  for (const LookCase& one : rules.cases) {
    const bool holds =
        std::all_of(one.conditions.begin(), one.conditions.end(), [&](const PlaceCondition& condition) {
          const float value = quantities[condition.quantity];
          const auto limit = static_cast<float>(condition.limit);
          return condition.above ? value >= limit : value < limit;
        });
    if (holds) return one.look;
  }
  return 0;
}

std::vector<std::string> early_names() {
  return {kQuantityNames.begin(), kQuantityNames.begin() + static_cast<int>(number_of(Quantity::slope))};
}

// Of each column of the region, row by row, all quantities but slope and cliff.
std::vector<std::vector<float>> quantities_of(const World& world, const Region& region) {
  const std::vector<std::string> names = early_names();
  auto sampler = PlaceSampler::make(world, names);
  REQUIRE(sampler.has_value());
  std::vector<std::vector<float>> all;
  const std::int64_t step = std::int64_t{1} << region.lod.value();
  std::vector<std::int64_t> xs;
  for (int x = 0; x < region.width; ++x) xs.push_back((region.x + x) * step);
  sampler->start(xs);
  for (int z = 0; z < region.depth; ++z) {
    sampler->row((region.z + z) * step);
    for (int x = 0; x < region.width; ++x) {
      std::vector<float>& column = all.emplace_back();
      for (std::size_t q = 0; q < names.size(); ++q) {
        column.push_back(sampler->values(q)[static_cast<std::size_t>(x)]);
      }
    }
  }
  return all;
}

TEST_CASE("Looks follow the first case that holds, at every level") {
  const World world = parsed_places(places_text());
  CHECK(rc::check("looks by quantities", [&] {
    const Region region = any_region(Lod::of(*rc::gen::inRange(0, 7)));
    const Stacks stacks = generate_stacks(world, region);
    const auto quantities = quantities_of(world, region);
    const auto& rules = world.spec().places.looks;
    RC_ASSERT(stacks.looks.size() == rules.size());
    for (std::size_t r = 0; r < rules.size(); ++r) {
      for (std::size_t i = 0; i < quantities.size(); ++i) {
        RC_ASSERT(int{stacks.looks[r].values[i]} == int{look_by(rules[r], quantities[i])});
      }
    }
  }));
}

TEST_CASE("A chunk shows what the looks of its columns say") {
  const World world = parsed_places(places_text());
  const auto sea_row = boundary_row(*world.sea_fx());
  CHECK(rc::check("voxels by looks", [&] {
    const Region region{*rc::gen::inRange(-300, 300) * 32, *rc::gen::inRange(-300, 300) * 32, kChunkSize,
                        kChunkSize, Lod{}};
    const Stacks stacks = generate_stacks(world, region);
    const auto cx = static_cast<std::int32_t>(region.x / kChunkSize);
    const auto cz = static_cast<std::int32_t>(region.z / kChunkSize);
    const MixedRange range = mixed_range(world, stacks, cx, cz);
    for (std::int32_t cy = range.first; cy <= range.last; ++cy) {
      const Chunk chunk = extract_chunk(world, stacks, {cx, cy, cz});
      for (int z = 0; z < kChunkSize; ++z) {
        for (int x = 0; x < kChunkSize; ++x) {
          for (int y = 0; y < kChunkSize; ++y) {
            const std::int32_t row = cy * kChunkSize + y;
            MaterialId expected = kAir;
            std::size_t plane = 0;
            while (plane < stacks.tops.size() && boundary_row(stacks.tops[plane].at(x, z)) <= row) ++plane;
            if (plane < stacks.tops.size()) {
              expected = stacks.shown(world, plane, x, z);
            } else if (row < sea_row) {
              const World::ShownBy& ice = *world.shown_by(kWater);
              expected = row + 1 == sea_row ? ice.by_look[stacks.looks[ice.looks].at(x, z)] : kWater;
            }
            const LocalPos at{static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(y),
                              static_cast<std::uint8_t>(z)};
            RC_ASSERT(chunk.at(at) == expected);
          }
        }
      }
    }
  }));
}

TEST_CASE("A share thins loose material out before it settles") {
  const World world = parsed_places(
      test::replaced(places_text(), "where = { temperature = [-0.50, -0.60] }",
                     "where = { height = [20, 60, 90, 180], slope = [40, 20], temperature = [0.9, -0.9] }"));
  const auto snow = std::find_if(world.loose().begin(), world.loose().end(),
                                 [](const LooseSpec& loose) { return loose.share.has_value(); });
  REQUIRE(snow != world.loose().end());
  const auto index = static_cast<std::size_t>(snow - world.loose().begin());
  CHECK(rc::check("thickness by the formula", [&] {
    const Lod lod = Lod::of(*rc::gen::element(0, 1, 3));
    Region region = any_region(lod);
    const int halo = snow->halo_at(lod);
    const Region around = region.expanded(halo);
    const Terrain wide = generate_terrain(world, around);
    const auto quantities = quantities_of(world, around);
    Field start{around.width, around.depth};
    for (std::size_t i = 0; i < start.values.size(); ++i) {
      std::int64_t share = kWholeShare;
      std::int64_t late = 0;
      for (const bool slope : {false, true}) {
        for (const PlaceRamp& ramp : world.spec().places.shares[*snow->share].ramps) {
          if ((ramp.quantity == number_of(Quantity::slope)) != slope) continue;
          const float value = slope ? static_cast<float>(wide.slope.values[i]) : quantities[i][ramp.quantity];
          const float t =
              (value - static_cast<float>(ramp.none)) * static_cast<float>(1 / (ramp.all - ramp.none));
          share = share * static_cast<std::int64_t>(std::clamp(t, 0.0F, 1.0F) * 4096.0F) >> 12;
          ++late;
        }
      }
      RC_ASSERT(late == 4);
      const std::int64_t t_fx = (snow->t_fx * share >> 12) >> lod.value();
      const std::int64_t room = std::max(0, snow->S_fx - wide.slope.values[i]);
      start.values[i] = static_cast<std::int32_t>(t_fx * room / snow->S_fx);
    }
    settle(start, snow->c_fx);
    RC_ASSERT(generate_terrain(world, region).loose[index].values == start.cropped(halo).values);
  }));
}

TEST_CASE("One more field, look or province moves nothing else") {
  const std::string forest = "name = \"forest\"\nof = \"soil\"\n";
  const std::string text = test::replaced(places_text(), forest, forest + "above = { temperature = -9 }\n");
  const World before = parsed_places(text);
  const World after = parsed_places(
      test::replaced(text, "[[look]]\nname = \"ice\"",
                     "[[look]]\nname = \"glade\"\nof = \"soil\"\nabove = { fairies = 0.9 }\n"
                     "colour = \"#ffffff\"\n[[look]]\nname = \"ice\"") +
      "[[province]]\nname = \"elves\"\nabove = { fairies = 0.5 }\ncolours = { gneiss = \"#00ff00\" }\n"
      "[[field]]\nname = \"fairies\"\nwavelength = 700\noctaves = 2\ngain = 0.5\n");
  CHECK(rc::check("the same ground and looks", [&] {
    const Region region = any_region(Lod::of(*rc::gen::element(0, 2, 6)));
    const Terrain a = generate_terrain(before, region);
    const Terrain b = generate_terrain(after, region);
    RC_ASSERT(a.surface.values == b.surface.values);
    for (std::size_t m = 0; m < a.loose.size(); ++m) RC_ASSERT(a.loose[m].values == b.loose[m].values);
    // The last look of all takes only what had none.
    const Stacks own = generate_stacks(before, region);
    const Stacks other = generate_stacks(after, region);
    for (std::size_t i = 0; i < own.looks[0].values.size(); ++i) {
      RC_ASSERT(own.looks[0].values[i] == other.looks[0].values[i]);
    }
  }));
}

TEST_CASE("A column's look is the ground's, whatever stands first in the file") {
  const auto without_looks =
      test::sample_world_without("default", {"[caves]", "[[veins]]", "[[object]]", "[[look]]"});
  const World provinces = parsed_places(without_looks);
  CHECK(provinces.look_names() == std::vector<std::string>{""});
  auto sampler = PlaceSampler::make(provinces, {});
  REQUIRE(sampler.has_value());
  std::vector<std::int64_t> xs;
  for (std::int64_t x = 0; x < 200; ++x) xs.push_back(x * 100);
  sampler->start(xs);
  sampler->row(-5000);
  CHECK(std::all_of(sampler->looks().begin(), sampler->looks().end(),
                    [](std::uint8_t look) { return look == 0; }));

  const World iced = parsed_places(without_looks +
                                   "[[look]]\nname = \"ice\"\nof = \"water\"\nbelow = { temperature = 0 }\n"
                                   "colour = \"#ffffff\"\n[[look]]\nname = \"moor\"\nof = \"soil\"\n"
                                   "colour = \"#777777\"\n");
  CHECK(iced.look_names() == std::vector<std::string>{"", "moor"});
  CHECK(iced.shown_by(kWater)->looks != 0);
}

TEST_CASE("Errors of talus, its halo and its defaults") {
  const auto error = [](const std::string& repose, const std::string& talus) {
    // 40 voxels a unit.
    const std::string scree =
        "[[eroded]]\nname = \"scree\"\ncolour = \"#888888\"\nweight = 9\nthickness = 0.02\nmax_slope = 45\n"
        "angle_of_repose = ";
    return test::error_of(test::small_world_text(7) + scree + repose + "\n[talus]\nof = \"scree\"\n" + talus);
  };
  CHECK(error("35", "thickness = 1.2\nreach = 0.8\ncliff = 1\n") == "accepted");
  CHECK_THAT(error("1", "thickness = 1.2\nreach = 0.8\ncliff = 1\n"),
             Catch::Contains("talus.thickness: at the angle of repose of 'scree' it needs a halo of"));
  CHECK_THAT(error("35", ""),
             Catch::Contains("talus.thickness: missing; 8 units, the default, are 320 voxels"));
}

TEST_CASE("Talus that comes to the same numbers has one fingerprint, and other numbers have another") {
  const auto fingerprint = [](const std::string& from, const std::string& to) {
    const auto world = World::parse(test::replaced(std::string{default_world_toml()}, from, to), "w.toml");
    REQUIRE(world.has_value());
    return world->fingerprint();
  };
  // 513.0 and 512.5 subvoxels, or nearly, which are rounded apart; floats of both are one.
  const std::string thickness =
      "thickness = 9                 # at most; no ground further than 32 columns away is looked at so";
  CHECK(fingerprint(thickness, "thickness = 1.001953125") !=
        fingerprint(thickness, "thickness = 1.001953124999"));
  CHECK(fingerprint("reach = 4 ", "reach = 3 ") == default_world().fingerprint());
  CHECK(fingerprint("reach = 4 ", "reach = 5 ") != default_world().fingerprint());
}

TEST_CASE("Ores have no colours of provinces") {
  const std::string text = test::replaced(std::string{default_world_toml()}, "colours = { gneiss",
                                          "colours = { coal = \"#00ff00\", gneiss");
  CHECK_THAT(test::error_of(text), Catch::Contains("colours.coal: no [[stratified]] material has this name"));
}

TEST_CASE("Errors of places") {
  const auto [from, to, message] = GENERATE(values<std::array<std::string, 3>>({
      {"below = { height = -7 }", "below = { depth = -7 }", "no quantity and no [[field]] has this name"},
      {"below = { height = -7 }", "below = { depth = -7 }", "base, terraces, and fields by name"},
      {"below = { height = -7 }\n", "",
       "'shingle beach' never shows, as 'sea floor' before it has no conditions"},
      {"below = { height = -7 }", "below = { slope = 30 }", "use it in `where`"},
      {"below = { height = -7 }", "under = { height = -7 }", "unknown key"},
      {"below = { height = -7 }", "below = 7", "a table"},
      {"of = \"water\"", "of = \"wine\"", "no [[eroded]] material is named 'wine'"},
      {"of = \"water\"", "of = \"granite\"", "no [[eroded]] material is named 'granite'"},
      {"shows = \"snow\"", "shows = \"sleet\"", "no material is named 'sleet'"},
      {"shows = \"snow\"", "shows = \"water\"", "no material is named 'water'"},
      {"shows = \"snow\"", "shows = \"snow\"\ncolour = \"#ffffff\"", "leave one of them out"},
      {"shows = \"snow\"\n", "", "a colour of its own"},
      {"above = { mesas = 0.3 }", "above = { mesas = \"red\" }", "is a string"},
      {"colours = { gneiss = \"#8a5a48\"", "colours = { grass = \"#6a4a42\"", "no [[stratified]] material"},
      {"colours = { gneiss = \"#8a5a48\"", "colours = { granite = \"#6a4a42\"", "the lowest layer goes on"},
      {"temperature = [-0.50, -0.60]", "temperature = [-0.50, -0.50]", "0.001 between them"},
      {"temperature = [-0.50, -0.60]", "cliff = [0, 1e-45]", "0.001 between them"},
      {"temperature = [-0.50, -0.60]", "temperature = [-0.50, -0.60, 1]", "a list of 2 or 4 numbers"},
      {"temperature = [-0.50, -0.60]", "slope = [-0.50, -0.60]", "out of range; 0 to 89"},
      {"temperature = [-0.50, -0.60]", "wetness = [-0.50, -0.60]", "fields by name"},
      {"repeat = true", "repeat = 1", "true or false"},
      {"[strata]", "[folds]\namplitude = 32700\nwavelength = 900\n[strata]",
       "the highest ground (757.4 units)"},
      {"octaves = 2", "octaves = 5", "strata.octaves: 5 is out of range; 1 to 4"},
      {"band = true\n", "", "no layer has band = true"},
  }));
  const auto world = World::parse(test::replaced(places_text(), from, to), "w.toml");
  INFO(to);
  REQUIRE_FALSE(world.has_value());
  INFO(world.error().message);
  CHECK(world.error().message.find(message) != std::string::npos);
  CHECK(world.error().message.find('\n') == std::string::npos);
}

TEST_CASE("Worlds of other surfaces have places by height and slope") {
  const std::string text = test::sample_world_text("classic") +
                           "where = { slope = [30, 10], height = [0, 0.1] }\n"
                           "[[look]]\nname = \"high\"\nof = \"grass\"\nabove = { height = 0.2 }\n"
                           "colour = \"#ffffff\"\n";
  const World world = parsed_places(text);
  CHECK(world.generator_version() == GeneratorVersion::v3);
  const Region region{-64, 40, 96, 64, Lod{}};
  const Stacks stacks = generate_stacks(world, region);
  const Terrain terrain = generate_terrain(world, region);
  for (std::size_t i = 0; i < region.columns(); ++i) {
    const double height = (terrain.surface.values[i] - *world.sea_fx()) / 256.0 / world.spec().resolution;
    CHECK((stacks.looks[0].values[i] == 1) == (height >= 0.2));
  }
  const auto wrong = World::parse(text +
                                      "[[look]]\nname = \"x\"\nof = \"grass\"\nabove = { moisture = 0 }\n"
                                      "colour = \"#ffffff\"\n",
                                  "w.toml");
  REQUIRE_FALSE(wrong.has_value());
  CHECK(wrong.error().message.find("only a surface of kind \"regions\"") != std::string::npos);
}

TEST_CASE("Place kernels of every instruction set agree") {
  CHECK(rc::check("the same looks and shares", [] {
    const auto width = *rc::gen::inRange<std::size_t>(1, 100);
    std::vector<std::vector<float>> rows(3, std::vector<float>(width));
    for (auto& row : rows) {
      for (float& value : row) value = static_cast<float>(*rc::gen::inRange(-100, 101)) * 0.01F;
    }
    const std::vector<const float*> quantities{rows[0].data(), rows[1].data(), rows[2].data()};
    std::vector<Places::Case> cases(4);
    for (std::size_t c = 0; c < cases.size(); ++c) {
      cases[c].look = static_cast<std::uint8_t>(c + 1);
      for (std::size_t q = 0; q < 3; ++q) {
        const bool above = *rc::gen::arbitrary<bool>();
        const int limit = *rc::gen::inRange(-60, 60);
        cases[c].conditions.push_back({q, above, static_cast<float>(limit) * 0.01F});
      }
    }
    const Places::Ramp ramp{0, -0.3F, 1 / 0.7F};
    std::vector<std::int32_t> share(width, 4001);
    const auto results = [&](InstructionSet set) {
      const PlaceKernels& kernels = place_kernels(set);
      std::vector<std::uint8_t> looks(width);
      kernels.look(cases, quantities, width, looks.data());
      // Of what a row's ranges leave of the cases comes the same.
      std::vector<ValueRange> ranges;
      for (const float* row : quantities) ranges.push_back(kernels.range(row, width));
      for (std::size_t q = 0; q < 3; ++q) {
        RC_ASSERT(ranges[q].low == *std::min_element(rows[q].begin(), rows[q].end()));
        RC_ASSERT(ranges[q].high == *std::max_element(rows[q].begin(), rows[q].end()));
      }
      std::vector<std::uint8_t> narrowed(width);
      kernels.look(NarrowedCases{cases}.in(ranges), quantities, width, narrowed.data());
      RC_ASSERT(narrowed == looks);
      std::vector<std::int32_t> kept(width);
      const std::uint64_t wanted = std::uint64_t{0b10110} | std::uint64_t{1} << 40;
      kernels.keep(wanted, looks.data(), share.data(), width, kept.data());
      for (std::size_t i = 0; i < width; ++i) {
        RC_ASSERT(kept[i] == ((wanted >> looks[i] & 1) != 0 ? share[i] : 0));
      }
      std::vector<std::int32_t> all(2 * width);
      kernels.thin(ramp, rows[0].data(), share.data(), width, all.data());
      kernels.thin_by_int32(ramp, share.data(), all.data(), width, all.data() + width);
      all.insert(all.end(), looks.begin(), looks.end());
      return all;
    };
    const auto plain = results(InstructionSet::scalar);
    for (const auto set : kInstructionSets) {
      if (runs_here(set)) RC_ASSERT(results(set) == plain);
    }
  }));
}

TEST_CASE("The cases that a row keeps do not depend on the rows before") {
  CHECK(rc::check([] {
    std::vector<Places::Case> cases(6);
    for (std::size_t c = 0; c < cases.size(); ++c) {
      cases[c].look = static_cast<std::uint8_t>(c + 1);
      for (int k = *rc::gen::inRange(0, 3); k > 0; --k) {
        const auto limit = static_cast<float>(*rc::gen::inRange(-4, 5));
        cases[c].conditions.push_back(
            {*rc::gen::inRange<std::size_t>(0, 3), *rc::gen::arbitrary<bool>(), limit});
      }
    }
    NarrowedCases kept{cases};
    std::vector<ValueRange> ranges(3);
    for (int row = 0; row < 60; ++row) {
      for (ValueRange& range : ranges) {
        if (*rc::gen::inRange(0, 3) != 0) continue;  // as most do not move far
        range.low = static_cast<float>(*rc::gen::inRange(-10, 11)) * 0.5F;
        range.high = range.low + static_cast<float>(*rc::gen::inRange(0, 6)) * 0.5F;
      }
      NarrowedCases anew{cases};
      const auto found = kept.in(ranges);
      const auto expected = anew.in(ranges);
      RC_ASSERT(found.size() == expected.size());
      for (std::size_t c = 0; c < found.size(); ++c) {
        RC_ASSERT(found[c].look == expected[c].look);
        RC_ASSERT(found[c].conditions.size() == expected[c].conditions.size());
        for (std::size_t k = 0; k < found[c].conditions.size(); ++k) {
          const Places::Condition& one = found[c].conditions[k];
          const Places::Condition& other = expected[c].conditions[k];
          RC_ASSERT(one.quantity == other.quantity && one.above == other.above && one.limit == other.limit);
        }
      }
    }
  }));
}

}  // namespace
}  // namespace talus::terrain
