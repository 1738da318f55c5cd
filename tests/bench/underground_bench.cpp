// What folds, faults and ore cost, beside the same ground without them.
#include <string>
#include <vector>

#include <talus/terrain/extraction.h>
#include <talus/terrain/generator.h>
#include <talus/terrain/stacks.h>

#include "fixtures.h"
#include "table.h"

namespace {

using namespace talus;
using namespace talus::terrain;
using benchmark::State;

constexpr int kTiles = 4;
constexpr Region kPatch{0, 0, kTiles* kChunkSize, kTiles* kChunkSize, Lod{}};

void generate(State& state, const char* sections) {
  const World world = bench::classic_world_with(sections);
  Generator generator{world};
  Stacks stacks;
  for (auto _ : state) generator.generate(kPatch, stacks);
  bench::works_on(state, "column", static_cast<std::int64_t>(kPatch.columns()));
}

void extract(State& state, const char* sections) {
  const World world = bench::classic_world_with(sections);
  const Stacks stacks = generate_stacks(world, kPatch);
  std::vector<ChunkCoord> coords;
  for (std::int32_t i = 0; i < kTiles * kTiles; ++i) {
    const MixedRange rows = mixed_range(world, stacks, i % kTiles, i / kTiles);
    for (std::int32_t y = rows.first; y <= rows.last; ++y) coords.push_back({i % kTiles, y, i / kTiles});
  }
  for (auto _ : state) {
    for (const ChunkCoord coord : coords) benchmark::DoNotOptimize(extract_chunk(world, stacks, coord));
  }
  bench::works_on(state, "column", static_cast<std::int64_t>(kPatch.columns()));
}

BENCHMARK_CAPTURE(generate, folds, bench::kFolds)->Name("a patch with folds");
BENCHMARK_CAPTURE(generate, level, "")->Name("a patch with folds/vs:level strata");
BENCHMARK_CAPTURE(generate, faults, bench::kFaults)->Name("a patch with two sets of faults");
BENCHMARK_CAPTURE(generate, whole, "")->Name("a patch with two sets of faults/vs:whole strata");
BENCHMARK_CAPTURE(extract, ore, bench::kOre)->Name("slabs with four ores");
BENCHMARK_CAPTURE(extract, barren, "")->Name("slabs with four ores/vs:barren rock");

}  // namespace
