// Fixed work for an instruction counter: bench_work STAGE does the stage's set-up and then its work in
// talus_counted_work(), the only function whose instructions are collected.
#include <cstdio>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <talus/terrain/extraction.h>
#include <talus/terrain/fbm.h>
#include <talus/terrain/generator.h>
#include <talus/terrain/stacks.h>
#include <talus/vectors/instruction_set.h>
#include <talus/voxel/codec.h>

#include "fixtures.h"
#include "fixtures/game_chunks.h"
#include "loose/settle_grid.h"

namespace {

using namespace talus;
using Stage = std::pair<std::string, std::function<void()>>;

void count_noise() {
  const auto columns = bench::line(0, 256);
  std::vector<float> out(columns.size() * columns.size());
  talus_counted_work([&] { terrain::sample_fbm({42, 128, 6}, columns, columns, out); });
}

void count_settle() {
  const auto& gravel = bench::classic_world().loose()[0];
  const auto ground = generate_terrain(bench::classic_world(), {0, 0, 200, 200, Lod{}});
  terrain::SettleGrid grid{instruction_set()};
  talus_counted_work([&] {
    grid.start(ground.slope, gravel.t_fx, gravel.S_fx);
    grid.settle(gravel.c_fx);
  });
}

void count_whole() {
  terrain::Generator generator{bench::classic_world()};
  terrain::Stacks stacks;
  generator.generate({0, 0, 200, 200, Lod{}}, stacks);
  talus_counted_work([&] { generator.generate({0, 0, 200, 200, Lod{}}, stacks); });
}

void count_default(int level) {
  terrain::Generator generator{terrain::default_world()};
  terrain::Stacks stacks;
  const terrain::Region patch{-2000 >> level, -6200 >> level, 96, 96, Lod::of(level)};
  generator.generate(patch, stacks);
  talus_counted_work([&] { generator.generate(patch, stacks); });
}

// Nine patches, each beside those before it, with the ground that they share kept.
void count_default_view() {
  terrain::Stacks stacks;
  terrain::Generator{terrain::default_world()}.generate({0, 0, 96, 96, Lod{}}, stacks);
  terrain::Generator generator{terrain::default_world(), std::make_shared<terrain::GroundCache>(8U << 20U)};
  talus_counted_work([&] {
    for (int i = 0; i < 9; ++i) {
      generator.generate({-2048 + 128 * (i % 3), -6272 + 128 * (i / 3), 128, 128, Lod{}}, stacks);
    }
  });
}

// What a cold View has most of beside its ground: all mixed chunks of a patch, with their ores and forest.
void count_default_slabs() {
  const auto& world = terrain::default_world();
  const auto stacks = generate_stacks(world, {-64 * kChunkSize, -194 * kChunkSize, 128, 128, Lod{}});
  talus_counted_work([&] {
    for (std::int32_t z = -194; z < -190; ++z) {
      for (std::int32_t x = -64; x < -60; ++x) {
        const terrain::MixedRange rows = mixed_range(world, stacks, x, z);
        for (std::int32_t y = rows.first; y <= rows.last; ++y) (void)extract_chunk(world, stacks, {x, y, z});
      }
    }
  });
}

// From the text of the default world to its first chunk.
void count_start() {
  talus_counted_work([] {
    const auto world = terrain::World::parse(terrain::default_world_toml(), "default.toml");
    const auto stacks = generate_stacks(*world, {-2048, -6208, kChunkSize, kChunkSize, Lod{}});
    (void)extract_chunk(*world, stacks, {-64, mixed_range(*world, stacks, -64, -194).first, -194});
  });
}

void count_slabs() {
  const auto& world = bench::classic_world();
  const auto stacks = generate_stacks(world, {0, 0, 128, 128, Lod{}});
  talus_counted_work([&] {
    for (std::int32_t y = 0; y < 4; ++y) (void)extract_chunk(world, stacks, {1, y, 1});
  });
}

void count_encode() {
  const auto chunks = bench::mixed_chunks();
  std::vector<std::byte> payload;
  talus_counted_work([&] {
    for (const Chunk& chunk : chunks) {
      payload.clear();
      encode(chunk, payload);
    }
  });
}

void count_decode() {
  std::vector<std::vector<std::byte>> payloads;
  for (const Chunk& chunk : bench::mixed_chunks()) encode(chunk, payloads.emplace_back());
  talus_counted_work([&] {
    for (const auto& payload : payloads) (void)decode(payload);
  });
}

void count_encode_volumes() {
  const auto chunks = bench::game_chunks(1);
  std::vector<std::byte> payload;
  talus_counted_work([&] {
    for (const Chunk& chunk : chunks) {
      payload.clear();
      encode(chunk, payload);
    }
  });
}

void count_decode_volumes() {
  std::vector<std::vector<std::byte>> payloads;
  for (const Chunk& chunk : bench::game_chunks(1)) encode(chunk, payloads.emplace_back());
  talus_counted_work([&] {
    for (const auto& payload : payloads) (void)decode(payload);
  });
}

void count_encode_forest() {
  const auto chunks = bench::forest_chunks(bench::mixed_chunks());
  std::vector<std::byte> payload;
  talus_counted_work([&] {
    for (const Chunk& chunk : chunks) {
      payload.clear();
      encode(chunk, payload);
    }
  });
}

void count_voxelise() {
  const auto chunks = bench::mixed_chunks();
  const auto voxels = std::make_unique<DenseVoxels>();
  talus_counted_work([&] {
    for (const Chunk& chunk : chunks) chunk.copy_to(*voxels);
  });
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<Stage> stages{{"noise", count_noise},
                                  {"settle", count_settle},
                                  {"whole", count_whole},
                                  {"slabs", count_slabs},
                                  {"default", [] { count_default(0); }},
                                  {"default_view", count_default_view},
                                  {"default_level_3", [] { count_default(3); }},
                                  {"default_level_6", [] { count_default(6); }},
                                  {"default_slabs", count_default_slabs},
                                  {"start", count_start},
                                  {"encode", count_encode},
                                  {"decode", count_decode},
                                  {"voxelise", count_voxelise},
                                  {"encode_volumes", count_encode_volumes},
                                  {"decode_volumes", count_decode_volumes},
                                  {"encode_forest", count_encode_forest}};
  if (argc == 2 && std::string{argv[1]} == "--list") {
    for (const Stage& stage : stages) std::printf("%s\n", stage.first.c_str());
    return 0;
  }
  for (const Stage& stage : stages) {
    if (argc == 2 && stage.first == argv[1]) return stage.second(), 0;
  }
  std::fprintf(stderr, "usage: bench_work STAGE; --list names the stages\n");
  return 2;
}
