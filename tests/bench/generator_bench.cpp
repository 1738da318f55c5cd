// Each stage of the generator and the codec beside its reference, in one run: compare within a run, never
// between machines. Items are columns, or chunks where the name says so.
#include <benchmark/benchmark.h>

#include <vector>

#include <talus/terrain/settle.h>
#include <talus/terrain/stacks.h>
#include <talus/terrain/surface.h>
#include <talus/voxel/codec.h>
#include <talus/voxel/content_hash.h>

#include "reference.h"

namespace {

using namespace talus;

constexpr int kWidth = 200;

std::vector<std::int64_t> line(int count) {
  std::vector<std::int64_t> columns;
  for (int i = 0; i < count; ++i) columns.push_back(i);
  return columns;
}

terrain::Field unsettled() {
  const auto& world = terrain::default_world();
  const terrain::Terrain ground = terrain::generate_terrain(world, {0, 0, kWidth, kWidth, Lod{}});
  return terrain::starting_thickness(ground.slope, world.loose()[0].t_fx, world.loose()[0].S_fx);
}

void count_columns(benchmark::State& state, int columns) {
  state.SetItemsProcessed(state.iterations() * columns);
}

void surface(benchmark::State& state) {
  const auto surface = terrain::surface_of(terrain::default_world().spec());
  const auto columns = line(kWidth);
  terrain::Field heights{kWidth, kWidth};
  for (auto _ : state) terrain::sample_surface(surface, columns, columns, heights.values);
  count_columns(state, kWidth * kWidth);
}
BENCHMARK(surface);

void settle_two_passes(benchmark::State& state) {
  const terrain::Field start = unsettled();
  for (auto _ : state) {
    terrain::Field g = start;
    terrain::settle(g, terrain::default_world().loose()[0].c_fx);
    benchmark::DoNotOptimize(g.values.data());
  }
  count_columns(state, kWidth * kWidth);
}
BENCHMARK(settle_two_passes);

void settle_literal_removal(benchmark::State& state) {
  const terrain::Field start = unsettled();
  for (auto _ : state) {
    terrain::Field g = start;
    test::reference::remove_until_stable(g, terrain::default_world().loose()[0].c_fx);
    benchmark::DoNotOptimize(g.values.data());
  }
  count_columns(state, kWidth * kWidth);
}
BENCHMARK(settle_literal_removal);

void whole_method(benchmark::State& state) {
  const int width = static_cast<int>(state.range(0));
  for (auto _ : state) {
    benchmark::DoNotOptimize(terrain::generate_stacks(terrain::default_world(), {0, 0, width, width, Lod{}}));
  }
  count_columns(state, width * width);
}
BENCHMARK(whole_method)->Arg(32)->Arg(64)->Arg(128)->Arg(200);

// The mixed chunks of a patch.
std::vector<Chunk> mixed_chunks() {
  const auto& world = terrain::default_world();
  const terrain::Stacks stacks = terrain::generate_stacks(world, {0, 0, 256, 256, Lod{}});
  std::vector<Chunk> chunks;
  for (std::int32_t i = 0; i < 64; ++i) {
    const terrain::MixedRange rows = terrain::mixed_range(world, stacks, i % 8, i / 8);
    for (std::int32_t y = rows.first; y <= rows.last; ++y) {
      chunks.push_back(terrain::extract_chunk(world, stacks, {i % 8, y, i / 8}));
    }
  }
  return chunks;
}

void encode_chunk(benchmark::State& state) {
  const std::vector<Chunk> chunks = mixed_chunks();
  std::size_t bytes = 0;
  std::size_t i = 0;
  std::vector<std::byte> payload;
  for (auto _ : state) {
    payload.clear();
    encode(chunks[i++ % chunks.size()], payload);
    bytes += payload.size();
  }
  state.SetItemsProcessed(state.iterations());
  state.counters["bytes_a_chunk"] = static_cast<double>(bytes) / static_cast<double>(state.iterations());
}
BENCHMARK(encode_chunk);

void decode_chunk(benchmark::State& state) {
  std::vector<std::vector<std::byte>> payloads;
  for (const Chunk& chunk : mixed_chunks()) encode(chunk, payloads.emplace_back());
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(decode(payloads[i++ % payloads.size()]));
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(decode_chunk);

void hash_chunk(benchmark::State& state) {
  const std::vector<Chunk> chunks = mixed_chunks();
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(content_hash(chunks[i++ % chunks.size()]));
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(hash_chunk);

}  // namespace
