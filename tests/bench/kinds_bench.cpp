// What a world's choices cost: each kind of surface beside the thesis' Perlin, and the erosion method beside
// the slope method, on patches as they stream.
#include <cstdio>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include <talus/vectors/aligned.h>
#include <talus/vectors/tables.h>

#include <talus/terrain/generator.h>
#include <talus/terrain/slope.h>
#include <talus/terrain/stacks.h>
#include <talus/terrain/surface.h>

#include "fixtures.h"
#include "loose/aprons.h"
#include "made_height_map.h"
#include "noise/point_fbm.h"
#include "noise/rotated_fbm.h"
#include "surface/surface_rows.h"
#include "table.h"
#include "worlds.h"

namespace {

using namespace talus;
using namespace talus::terrain;
using benchmark::State;

constexpr int kPatchSide = 128;

// The classic world with other keys in its [surface], or before it.
World world_with(const std::string& root, const std::string& surface, bool noise = true) {
  std::string text = root + bench::text_of_world("classic");
  const std::size_t table = text.find("[surface]");
  const std::size_t amplitude = text.find("\namplitude", table) + 1;
  const std::size_t begin = text.find('\n', table) + 1;
  if (!noise) text.erase(begin, amplitude - begin);
  text.insert(begin, surface);
  auto world = World::parse(text, "classic", test::made_height_maps());
  if (!world) {
    std::fprintf(stderr, "%s\n", world.error().message.c_str());
    std::abort();
  }
  return *std::move(world);
}

World of_kind(const std::string& kind) {
  if (kind == "perlin") return bench::classic_world();
  if (kind == "ridged") return world_with("", "kind = \"ridged\"\n");
  if (kind == "warped") return world_with("", "kind = \"warped\"\nwarp = 0.6\n");
  return world_with("",
                    "kind = \"height_map\"\nheight_map = { file = \"made\", x = 0, z = 0, spacing = 0.05, "
                    "outside = \"repeat\" }\n",
                    false);
}

World by_method(int steps) {
  if (steps == 0) return bench::classic_world();
  return world_with("method = \"erosion\"\nerosion_steps = " + std::to_string(steps) + "\n", "");
}

void surface(State& state, const std::string& kind) {
  const Surface surface = surface_of(of_kind(kind).spec());
  const auto columns = bench::line(0, kPatchSide);
  Field heights{kPatchSide, kPatchSide};
  for (auto _ : state) sample_surface(surface, columns, columns, heights.values);
  bench::works_on(state, "column", kPatchSide * kPatchSide);
}

// What a warped surface would pay for its own noise without vectors.
void point_by_point(State& state) {
  PointFbm noise{surface_of(bench::classic_world().spec()).noise};
  for (auto _ : state) {
    for (int z = 0; z < kPatchSide; ++z) {
      for (int x = 0; x < kPatchSide; ++x) {
        benchmark::DoNotOptimize(noise.at(x * kSubvoxels + 3 * z, z * kSubvoxels + 5 * x));
      }
    }
  }
  bench::works_on(state, "column", kPatchSide * kPatchSide);
}

// One octave of the regions' shape.
void rotated(State& state, int k) {
  RotatedFbm rows{instruction_set()};
  const auto columns = bench::line(0, kPatchSide);
  rows.start({2019, 1400, 8, 0.47, 0}, columns);
  AlignedVector<float> row(padded(columns.size()));
  for (auto _ : state) {
    for (int z = 0; z < kPatchSide; ++z) {
      rows.octave(k, z, {row.data()});
      benchmark::DoNotOptimize(row.data());
    }
  }
  bench::works_on(state, "column", kPatchSide * kPatchSide);
}

// Among the mesas of a world of regions, where some 7 % of columns are walls.
struct Mesas {
  static constexpr ApronNumbers kNumbers{284, 179, 8 * kSubvoxels, 192, 8, 128 * kSubvoxels, 12, false, {}};
  const int halo = apron_halo(kNumbers);
  const int side = kPatchSide + 2 * halo;
  const std::vector<std::int64_t> xs = bench::line(-3400, side + 2);
  const std::vector<std::int64_t> zs = bench::line(-5100, side + 2);
  const Surface surface = surface_of(World::parse(test::regions_world_text(), "mesas").value().spec());
};

void aprons(State& state) {
  const Mesas mesas;
  Field around{mesas.side + 2, mesas.side + 2};
  sample_surface(mesas.surface, mesas.xs, mesas.zs, around.values);
  const Field height = around.cropped(1);
  const Field slope = slope_inside(around);
  Aprons aprons{instruction_set()};
  Field raised;
  Field cliff;
  for (auto _ : state) aprons.compute(height, slope, mesas.halo, Mesas::kNumbers, raised, cliff);
  bench::works_on(state, "column", std::int64_t{mesas.side} * mesas.side);
}

void surface_of_mesas(State& state) {
  const Mesas mesas;
  Field around{mesas.side + 2, mesas.side + 2};
  for (auto _ : state) sample_surface(mesas.surface, mesas.xs, mesas.zs, around.values);
  bench::works_on(state, "column", std::int64_t{mesas.side + 2} * (mesas.side + 2));
}

void patch(State& state, const World& world) {
  Generator generator{world};
  Stacks stacks;
  for (auto _ : state) generator.generate({0, 0, kPatchSide, kPatchSide, Lod{}}, stacks);
  bench::works_on(state, "column", kPatchSide * kPatchSide);
}

// The default world, or that with less in it, over mesas, mountains and forest.
void patch_of_regions(State& state, int level, const std::vector<std::string>& without) {
  const World world = World::parse(test::sample_world_without("default", without), "default").value();
  Generator generator{world};
  Stacks stacks;
  const Lod lod = Lod::of(level);
  for (auto _ : state) {
    generator.generate({-2000 >> level, -6200 >> level, kPatchSide, kPatchSide, lod}, stacks);
  }
  bench::works_on(state, "column", kPatchSide * kPatchSide);
}

void patch_of_classic(State& state, int level) {
  Generator generator{bench::classic_world()};
  Stacks stacks;
  for (auto _ : state) generator.generate({0, 0, kPatchSide, kPatchSide, Lod::of(level)}, stacks);
  bench::works_on(state, "column", kPatchSide * kPatchSide);
}

void ground_of_regions(State& state, int level) {
  const World world = World::parse(test::regions_world_text(), "regions").value();
  WorldSpec spec = world.spec();
  spec.places = {};
  const Surface surface = surface_of(spec);
  const auto rows = make_surface_rows(surface, instruction_set());
  std::vector<std::int64_t> xs;
  for (std::int64_t x = 0; x < kPatchSide; ++x) xs.push_back((x - 2000) << level);
  std::vector<std::int32_t> heights(xs.size());
  std::vector<std::int32_t> slopes(xs.size());
  for (auto _ : state) {
    const bool sloped = level > 0 && rows->starts_level(xs, Lod::of(level));
    if (!sloped) rows->start(xs);
    for (std::int64_t z = 0; z < kPatchSide; ++z) {
      if (sloped) {
        rows->sloped_row(z << level, heights.data(), slopes.data());
      } else {
        rows->row(z, heights.data());
      }
    }
    benchmark::DoNotOptimize(heights.data());
  }
  bench::works_on(state, "column", kPatchSide * kPatchSide);
}

void patch_of_kind(State& state, const std::string& kind) {
  patch(state, of_kind(kind));
}

void patch_by_method(State& state, int steps) {
  patch(state, by_method(steps));
}

BENCHMARK_CAPTURE(surface, ridged, "ridged")->Name("surface, ridged");
BENCHMARK_CAPTURE(surface, ridged_vs, "perlin")->Name("surface, ridged/vs:perlin");
BENCHMARK_CAPTURE(surface, warped, "warped")->Name("surface, warped");
BENCHMARK_CAPTURE(surface, warped_vs, "perlin")->Name("surface, warped/vs:perlin");
BENCHMARK(point_by_point)->Name("surface, warped/vs:its noise alone, a point at a time");
BENCHMARK_CAPTURE(surface, height_map, "height_map")->Name("surface, height_map");
BENCHMARK_CAPTURE(surface, height_map_vs, "perlin")->Name("surface, height_map/vs:perlin");
BENCHMARK_CAPTURE(rotated, wide, 3)->Name("noise, a rotated octave of 175 columns");
BENCHMARK_CAPTURE(surface, rotated_wide_vs, "perlin")
    ->Name("noise, a rotated octave of 175 columns/vs:perlin");
BENCHMARK_CAPTURE(rotated, narrow, 7)->Name("noise, a rotated octave of 11 columns");
BENCHMARK_CAPTURE(surface, rotated_narrow_vs, "perlin")
    ->Name("noise, a rotated octave of 11 columns/vs:perlin");
BENCHMARK(aprons)->Name("aprons and cliffs among mesas");
BENCHMARK(surface_of_mesas)->Name("aprons and cliffs among mesas/vs:their surface");
BENCHMARK_CAPTURE(ground_of_regions, level_0, 0)->Name("surface, regions, level 0");
BENCHMARK_CAPTURE(surface, regions_0_vs, "perlin")->Name("surface, regions, level 0/vs:perlin at level 0");
BENCHMARK_CAPTURE(ground_of_regions, level_1, 1)->Name("surface, regions, level 1");
BENCHMARK_CAPTURE(surface, regions_1_vs, "perlin")->Name("surface, regions, level 1/vs:perlin at level 0");
BENCHMARK_CAPTURE(ground_of_regions, level_2, 2)->Name("surface, regions, level 2");
BENCHMARK_CAPTURE(surface, regions_2_vs, "perlin")->Name("surface, regions, level 2/vs:perlin at level 0");
BENCHMARK_CAPTURE(ground_of_regions, level_3, 3)->Name("surface, regions, level 3");
BENCHMARK_CAPTURE(surface, regions_3_vs, "perlin")->Name("surface, regions, level 3/vs:perlin at level 0");
BENCHMARK_CAPTURE(ground_of_regions, level_6, 6)->Name("surface, regions, level 6");
BENCHMARK_CAPTURE(surface, regions_6_vs, "perlin")->Name("surface, regions, level 6/vs:perlin at level 0");
BENCHMARK_CAPTURE(patch_of_regions, all_0, 0, {})->Name("patch, default world, level 0");
BENCHMARK_CAPTURE(patch_of_classic, all_0_vs, 0)->Name("patch, default world, level 0/vs:classic");
BENCHMARK_CAPTURE(patch_of_regions, all_1, 1, {})->Name("patch, default world, level 1");
BENCHMARK_CAPTURE(patch_of_classic, all_1_vs, 1)->Name("patch, default world, level 1/vs:classic");
BENCHMARK_CAPTURE(patch_of_regions, all_2, 2, {})->Name("patch, default world, level 2");
BENCHMARK_CAPTURE(patch_of_classic, all_2_vs, 2)->Name("patch, default world, level 2/vs:classic");
BENCHMARK_CAPTURE(patch_of_regions, all_3, 3, {})->Name("patch, default world, level 3");
BENCHMARK_CAPTURE(patch_of_classic, all_3_vs, 3)->Name("patch, default world, level 3/vs:classic");
BENCHMARK_CAPTURE(patch_of_regions, all_6, 6, {})->Name("patch, default world, level 6");
BENCHMARK_CAPTURE(patch_of_classic, all_6_vs, 6)->Name("patch, default world, level 6/vs:classic");
BENCHMARK_CAPTURE(patch_of_regions, bare, 0, {"[talus]", "[[object]]", "[caves]", "[[veins]]"})
    ->Name("patch, default world without talus, objects, caves and ores");
BENCHMARK_CAPTURE(patch_of_classic, bare_vs, 0)
    ->Name("patch, default world without talus, objects, caves and ores/vs:classic");
BENCHMARK_CAPTURE(patch_of_kind, ridged, "ridged")->Name("patch, ridged");
BENCHMARK_CAPTURE(patch_of_kind, ridged_vs, "perlin")->Name("patch, ridged/vs:perlin");
BENCHMARK_CAPTURE(patch_of_kind, warped, "warped")->Name("patch, warped");
BENCHMARK_CAPTURE(patch_of_kind, warped_vs, "perlin")->Name("patch, warped/vs:perlin");
BENCHMARK_CAPTURE(patch_of_kind, height_map, "height_map")->Name("patch, height_map");
BENCHMARK_CAPTURE(patch_of_kind, height_map_vs, "perlin")->Name("patch, height_map/vs:perlin");
BENCHMARK_CAPTURE(patch_by_method, one, 1)->Name("patch, erosion of 1 step");
BENCHMARK_CAPTURE(patch_by_method, one_vs, 0)->Name("patch, erosion of 1 step/vs:slope method");
BENCHMARK_CAPTURE(patch_by_method, eight, 8)->Name("patch, erosion of 8 steps");
BENCHMARK_CAPTURE(patch_by_method, eight_vs, 0)->Name("patch, erosion of 8 steps/vs:slope method");

}  // namespace
