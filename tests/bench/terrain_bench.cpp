// The generator's stages, one thread unless said otherwise. Items are columns or noise samples.
#include <array>
#include <atomic>
#include <memory>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <libnoise/noise.h>

#include <talus/terrain/fbm.h>
#include <talus/terrain/generator.h>
#include <talus/terrain/ground_cache.h>
#include <talus/terrain/settle.h>
#include <talus/terrain/slope.h>
#include <talus/terrain/stacks.h>
#include <talus/terrain/strata.h>
#include <talus/terrain/surface.h>
#include <talus/vectors/instruction_set.h>

#include "fixtures.h"
#include "loose/settle_grid.h"
#include "reference.h"
#include "table.h"
#include "worlds.h"

namespace {

using namespace talus;
using namespace talus::terrain;
using benchmark::State;

constexpr int kNoiseSide = 256;
constexpr int kSide = 200;
constexpr int kViewRadius = 16;
constexpr int kPatchTiles = 4;

const World& world() {
  return bench::classic_world();
}

void noise(State& state) {
  const Fbm fbm{42, 128, 6};
  const auto columns = bench::line(0, kNoiseSide);
  std::vector<float> out(columns.size() * columns.size());
  for (auto _ : state) sample_fbm(fbm, columns, columns, out);
  bench::works_on(state, "sample", kNoiseSide * kNoiseSide);
}
BENCHMARK(noise);

void noise_libnoise(State& state) {
  ::noise::module::Perlin perlin;
  perlin.SetOctaveCount(6);
  perlin.SetFrequency(1.0 / 128);
  for (auto _ : state) {
    for (int z = 0; z < kNoiseSide; ++z) {
      for (int x = 0; x < kNoiseSide; ++x) benchmark::DoNotOptimize(perlin.GetValue(x, 0.5, z));
    }
  }
  bench::works_on(state, "sample", kNoiseSide * kNoiseSide);
}
BENCHMARK(noise_libnoise)->Name("noise/vs:libnoise Perlin, 3D");

void surface(State& state) {
  const Surface surface = surface_of(world().spec());
  const auto columns = bench::line(0, kSide);
  Field heights{kSide, kSide};
  for (auto _ : state) sample_surface(surface, columns, columns, heights.values);
  bench::works_on(state, "column", kSide * kSide);
}
BENCHMARK(surface);

Terrain terrain_of_side() {
  return generate_terrain(world(), {0, 0, kSide, kSide, Lod{}});
}

void slope(State& state) {
  const Field heights = terrain_of_side().surface;
  for (auto _ : state) benchmark::DoNotOptimize(slope_inside(heights));
  bench::works_on(state, "column", (kSide - 2) * (kSide - 2));
}
BENCHMARK(slope);

Field unsettled() {
  const LooseSpec& gravel = world().loose()[0];
  return starting_thickness(terrain_of_side().slope, gravel.t_fx, gravel.S_fx);
}

// What it does depends on no thickness, so that ground at rest takes as long as any.
void settle_alone(State& state) {
  const LooseSpec& gravel = world().loose()[0];
  SettleGrid grid{instruction_set()};
  grid.start(terrain_of_side().slope, gravel.t_fx, gravel.S_fx);
  for (auto _ : state) grid.settle(gravel.c_fx);
  bench::works_on(state, "column", kSide * kSide);
}
BENCHMARK(settle_alone)->Name("settle");

// As the generator does it: its start included, which is a part of every patch.
void settle(State& state) {
  const LooseSpec& gravel = world().loose()[0];
  const Field slope = terrain_of_side().slope;
  SettleGrid grid{instruction_set()};
  for (auto _ : state) {
    grid.start(slope, gravel.t_fx, gravel.S_fx);
    grid.settle(gravel.c_fx);
  }
  bench::works_on(state, "column", kSide * kSide);
}
BENCHMARK(settle)->Name("start and settle");

void settle_literal(State& state) {
  const Field start = unsettled();
  Field thickness;
  for (auto _ : state) {
    thickness = start;
    test::reference::remove_until_stable(thickness, world().loose()[0].c_fx);
  }
  bench::works_on(state, "column", kSide * kSide);
}
BENCHMARK(settle_literal)->Name("start and settle/vs:removal until nothing moves");

void whole_of(State& state, const World& world) {
  Generator generator{world};
  Stacks stacks;
  for (auto _ : state) generator.generate({0, 0, kSide, kSide, Lod{}}, stacks);
  bench::works_on(state, "column", kSide * kSide);
}

void whole(State& state) {
  whole_of(state, world());
}
BENCHMARK(whole)->Name("whole method, 200 x 200");

// What caves cost: the sample world that has them, and the same without.
void with_caves(State& state) {
  whole_of(state, bench::sample_world("features"));
}
BENCHMARK(with_caves)->Name("whole method with caves");
void without_caves(State& state) {
  whole_of(state, bench::without_caves("features"));
}
BENCHMARK(without_caves)->Name("whole method with caves/vs:the same world without");

// A view filled from cold: its patches one after another.
void stream(State& state) {
  const auto patch_tiles = static_cast<int>(state.range(0));
  const auto patches = bench::patches_of_view(kViewRadius, patch_tiles);
  Generator generator{world()};
  Stacks stacks;
  for (auto _ : state) {
    for (const Region& patch : patches) generator.generate(patch, stacks);
  }
  bench::works_on(state, "column", static_cast<std::int64_t>(patches.size() * patches.front().columns()));
}
BENCHMARK(stream)->Name("stream, tiles a patch side")->Arg(1)->Arg(2)->Arg(kPatchTiles)->Arg(8);

// What of that is noise: the surface with its halo, and of each layer the rows and columns not yet full.
void stream_noise(State& state) {
  const auto patches = bench::patches_of_view(kViewRadius, kPatchTiles);
  const Surface surface = surface_of(world().spec());
  const int ring = world().halo();
  constexpr int kColumns = kPatchTiles * kChunkSize;
  Field heights{kColumns + 2 * ring, kColumns + 2 * ring};
  for (auto _ : state) {
    for (const Region& patch : patches) {
      sample_surface(surface, bench::line(patch.x - ring, heights.width),
                     bench::line(patch.z - ring, heights.depth), heights.values);
    }
  }
  bench::works_on(state, "column", static_cast<std::int64_t>(patches.size() * patches.front().columns()));
}
BENCHMARK(stream_noise)->Name("stream, tiles a patch side/4/vs:its surface noise alone");

// A cold view of the default world, with the ground that patches share kept, as a server does, or computed
// anew for each.
void default_view(State& state, const std::vector<std::string>& without, std::size_t ground_bytes) {
  const World world = World::parse(test::sample_world_without("default", without), "default").value();
  auto patches = bench::patches_of_view(kViewRadius, kPatchTiles);
  for (Region& patch : patches) {  // over mesas, mountains and forest
    patch.x -= 2048;
    patch.z -= 6144;
  }
  Stacks stacks;
  for (auto _ : state) {
    Generator generator{world, ground_bytes == 0 ? nullptr : std::make_shared<GroundCache>(ground_bytes)};
    for (const Region& patch : patches) generator.generate(patch, stacks);
  }
  bench::works_on(state, "column", static_cast<std::int64_t>(patches.size() * patches.front().columns()));
}
constexpr std::size_t kGroundBytes = std::size_t{8} << 20;
const std::vector<std::string> kBare{"[talus]", "[[object]]"};
BENCHMARK_CAPTURE(default_view, all, {}, kGroundBytes)->Name("view of the default world");
BENCHMARK_CAPTURE(default_view, all_vs, {}, 0)->Name("view of the default world/vs:without shared ground");
BENCHMARK_CAPTURE(default_view, bare, kBare, kGroundBytes)
    ->Name("view of the default world without aprons and objects");
BENCHMARK_CAPTURE(default_view, bare_vs, kBare, 0)
    ->Name("view of the default world without aprons and objects/vs:without shared ground");

// Each keeps its generator and its memory from view to view, and takes the next patch when it is done with
// one, as a server's do.
void threads(State& state) {
  const auto patches = bench::patches_of_view(kViewRadius, kPatchTiles);
  const auto count = static_cast<std::size_t>(state.range(0));
  std::vector<std::pair<Generator, Stacks>> kept;
  for (std::size_t t = 0; t < count; ++t) kept.emplace_back(Generator{world()}, Stacks{});
  const auto fill_view = [&] {
    std::atomic<std::size_t> next{0};
    std::vector<std::jthread> pool;
    for (std::size_t t = 0; t < count; ++t) {
      pool.emplace_back([&, t] {
        auto& [generator, stacks] = kept[t];
        for (std::size_t i = next++; i < patches.size(); i = next++) generator.generate(patches[i], stacks);
      });
    }
    pool.clear();  // they end before what they count with
  };
  fill_view();
  for (auto _ : state) fill_view();
  bench::works_on(state, "column", static_cast<std::int64_t>(patches.size() * patches.front().columns()));
}
BENCHMARK(threads)->Name("generator threads")->Arg(1)->Arg(2)->UseRealTime();

}  // namespace

int main(int argc, char** argv) {
  return talus::bench::run(argc, argv);
}
