// Chunks: coding, hashing, voxelising. Items are chunks; "bytes" is the mean size of what was coded.
#include <algorithm>
#include <chrono>
#include <cstring>
#include <memory>
#include <numeric>
#include <string>
#include <vector>

#include <lz4.h>
#include <zstd.h>

#include <talus/terrain/extraction.h>
#include <talus/terrain/generator.h>
#include <talus/voxel/codec.h>
#include <talus/voxel/content_hash.h>

#include "fixtures.h"
#include "fixtures/game_chunks.h"
#include "table.h"
#include "volume.h"

namespace {

using namespace talus;
using benchmark::State;

using Chunks = std::vector<Chunk>;

const Chunks& chunks() {
  static const Chunks chunks = bench::mixed_chunks();
  return chunks;
}

template <class Change>
Chunks changed(const Chunks& chunks, const Change& change) {
  Chunks all;
  for (const Chunk& chunk : chunks) all.push_back(change(chunk));
  return all;
}

Chunk dense(const Chunk& chunk) {
  const auto voxels = std::make_unique<DenseVoxels>();
  chunk.copy_to(*voxels);
  return Chunk::from_dense(*voxels);
}

/// What else the codec meets, and what its bytes are compared for.
struct Content {
  const char* name;
  Chunks (*make)();
};
constexpr Content kContents[] = {
    {"canyon", [] { return bench::mixed_chunks(bench::sample_world("canyon")); }},
    {"hills", [] { return bench::mixed_chunks(bench::sample_world("hills")); }},
    {"default", [] { return bench::mixed_chunks(terrain::default_world()); }},
    {"default, level 2", [] { return bench::mixed_chunks(terrain::default_world(), Lod::of(2)); }},
    {"archipelago", [] { return bench::mixed_chunks(bench::sample_world("archipelago")); }},
    {"classic, level 2", [] { return bench::mixed_chunks(bench::classic_world(), Lod::of(2)); }},
    {"chunks with caves", [] { return bench::cave_chunks(true); }},
    {"those without their caves", [] { return bench::cave_chunks(false); }},
    {"classic, folds and faults",
     [] {
       return bench::mixed_chunks(bench::classic_world_with(std::string{bench::kFolds} + bench::kFaults));
     }},
    {"classic, four ores", [] { return bench::mixed_chunks(bench::classic_world_with(bench::kOre)); }},
    {"classic, with tunnels", [] { return changed(chunks(), bench::with_hole); }},
    {"classic, edited", [] { return changed(chunks(), bench::edited); }},
    {"a game's chunks", [] { return bench::game_chunks(1); }},
    {"a forest, as overrides", [] { return bench::forest_chunks(chunks()); }},
    {"a forest, dense", [] { return changed(bench::forest_chunks(chunks()), dense); }},
    {"very rough terrain", [] { return bench::mixed_chunks(bench::rough_world(5, 1)); }},
    {"random, 4 materials",
     [] {
       Chunks all;
       for (std::uint32_t seed = 1; seed <= 8; ++seed) all.push_back(bench::random_chunk(seed, 4, 1));
       return all;
     }},
    {"random, runs of 20",
     [] {
       Chunks all;
       for (std::uint32_t seed = 1; seed <= 8; ++seed) all.push_back(bench::random_chunk(seed, 4, 20));
       return all;
     }},
};

/// Runs `work(i)` for chunk after chunk of `count`; it returns bytes, whose mean over all is shown.
/// "least_ns" is the mean over all of the least time of each: of a machine under load it says more than the
/// mean does.
template <class Work>
void over(State& state, std::size_t count, const Work& work) {
  using Clock = std::chrono::steady_clock;
  std::size_t bytes = 0;
  for (std::size_t i = 0; i < count; ++i) bytes += work(i);
  std::vector<double> least(count, 1e9);
  std::size_t next = 0;
  std::size_t rounds = 0;
  for (auto _ : state) {
    const auto begin = Clock::now();
    benchmark::DoNotOptimize(work(next));
    const std::chrono::duration<double, std::nano> time = Clock::now() - begin;
    least[next] = std::min(least[next], time.count());
    if (++next < count) continue;
    next = 0;
    ++rounds;
  }
  bench::works_on(state, "chunk", 1);
  state.counters["bytes"] = static_cast<double>(bytes) / static_cast<double>(count);
  if (rounds > 0) {
    state.counters["least_ns"] =
        std::accumulate(least.begin(), least.end(), 0.0) / static_cast<double>(count);
  }
}

template <class Work>
void over_chunks(State& state, const Work& work) {
  over(state, chunks().size(), work);
}

/// The usual way: in dense order a byte a voxel, or two where a chunk has ids above 255.
std::vector<std::vector<std::uint8_t>> dense_bytes(const Chunks& chunks) {
  std::vector<std::vector<std::uint8_t>> all;
  const auto voxels = std::make_unique<DenseVoxels>();
  for (const Chunk& chunk : chunks) {
    chunk.copy_to(*voxels);
    const bool wide =
        std::any_of(voxels->begin(), voxels->end(), [](MaterialId id) { return to_integer(id) > 255; });
    auto& bytes = all.emplace_back();
    for (const MaterialId voxel : *voxels) {
      bytes.push_back(static_cast<std::uint8_t>(to_integer(voxel) & 0xFF));
      if (wide) bytes.push_back(static_cast<std::uint8_t>(to_integer(voxel) >> 8));
    }
  }
  return all;
}

void encode_all(State& state, const Chunks& chunks) {
  std::vector<std::byte> payload;
  over(state, chunks.size(), [&](std::size_t i) {
    payload.clear();
    encode(chunks[i], payload);
    return payload.size();
  });
}

void decode_all(State& state, const Chunks& chunks) {
  std::vector<std::vector<std::byte>> payloads;
  for (const Chunk& chunk : chunks) encode(chunk, payloads.emplace_back());
  over(state, chunks.size(), [&](std::size_t i) {
    benchmark::DoNotOptimize(decode(payloads[i]));
    return payloads[i].size();
  });
}

/// Volumes by the kernels of one instruction set, whatever set the rest of the process uses.
void volumes_by(State& state, const Chunks& chunks, InstructionSet set, bool decodes) {
  const codec::VolumeKernels kernels = codec::volume_kernels(set);
  std::vector<DenseVoxels> voxels(chunks.size());
  std::vector<std::vector<std::byte>> payloads(chunks.size());
  for (std::size_t i = 0; i < chunks.size(); ++i) {
    chunks[i].copy_to(voxels[i]);
    (void)codec::encode_volume(voxels[i], payloads[i], kernels);
  }
  std::vector<std::byte> payload;
  over(state, chunks.size(), [&](std::size_t i) {
    if (decodes) {
      benchmark::DoNotOptimize(codec::decode_volume(payloads[i], kernels));
    } else {
      payload.clear();
      (void)codec::encode_volume(voxels[i], payload, kernels);
    }
    return payloads[i].size() + 2;
  });
}

void zstd_all(State& state, const Chunks& chunks) {
  const auto dense = dense_bytes(chunks);
  std::vector<char> out(ZSTD_compressBound(sizeof(DenseVoxels)));
  over(state, chunks.size(), [&](std::size_t i) {
    return ZSTD_compress(out.data(), out.size(), dense[i].data(), dense[i].size(), 3);
  });
}

void encode_chunk(State& state) {
  encode_all(state, chunks());
}
BENCHMARK(encode_chunk)->Name("encode");

void encode_zstd(State& state) {
  zstd_all(state, chunks());
}
BENCHMARK(encode_zstd)->Name("encode/vs:zstd -3 of dense bytes");

void encode_lz4(State& state) {
  const auto dense = dense_bytes(chunks());
  std::vector<char> out(static_cast<std::size_t>(LZ4_compressBound(kChunkVolume)));
  over_chunks(state, [&](std::size_t i) {
    return static_cast<std::size_t>(LZ4_compress_default(reinterpret_cast<const char*>(dense[i].data()),
                                                         out.data(), kChunkVolume,
                                                         static_cast<int>(out.size())));
  });
}
BENCHMARK(encode_lz4)->Name("encode/vs:LZ4 of dense bytes");

void decode_chunk(State& state) {
  std::vector<std::vector<std::byte>> payloads;
  for (const Chunk& chunk : chunks()) encode(chunk, payloads.emplace_back());
  const auto voxels = std::make_unique<DenseVoxels>();
  over_chunks(state, [&](std::size_t i) {
    decode(payloads[i])->copy_to(*voxels);
    benchmark::DoNotOptimize(voxels->data());
    return payloads[i].size();
  });
}
BENCHMARK(decode_chunk)->Name("decode, to dense voxels");

void decode_zstd(State& state) {
  std::vector<std::vector<char>> payloads;
  for (const auto& dense : dense_bytes(chunks())) {
    auto& payload = payloads.emplace_back(ZSTD_compressBound(kChunkVolume));
    payload.resize(ZSTD_compress(payload.data(), payload.size(), dense.data(), kChunkVolume, 3));
  }
  std::vector<std::uint8_t> out(kChunkVolume);
  over_chunks(state, [&](std::size_t i) {
    ZSTD_decompress(out.data(), out.size(), payloads[i].data(), payloads[i].size());
    benchmark::DoNotOptimize(out.data());
    return payloads[i].size();
  });
}
BENCHMARK(decode_zstd)->Name("decode, to dense voxels/vs:zstd to bytes");

void voxelise(State& state) {
  const auto voxels = std::make_unique<DenseVoxels>();
  over_chunks(state, [&](std::size_t i) {
    chunks()[i].copy_to(*voxels);
    benchmark::DoNotOptimize(voxels->data());
    return sizeof(DenseVoxels);
  });
}
BENCHMARK(voxelise);

void voxelise_memset(State& state) {
  const auto voxels = std::make_unique<DenseVoxels>();
  over_chunks(state, [&](std::size_t i) {
    std::memset(voxels->data(), static_cast<int>(i), sizeof(DenseVoxels));
    benchmark::DoNotOptimize(voxels->data());
    return sizeof(DenseVoxels);
  });
}
BENCHMARK(voxelise_memset)->Name("voxelise/vs:memset of the same bytes");

void hash(State& state) {
  over_chunks(state, [&](std::size_t i) {
    benchmark::DoNotOptimize(content_hash(chunks()[i]));
    return sizeof(DenseVoxels);
  });
}
BENCHMARK(hash)->Name("content hash");

void extract(State& state) {
  const auto& world = bench::classic_world();
  const terrain::Stacks stacks = generate_stacks(world, {0, 0, 128, 128, Lod{}});
  std::vector<ChunkCoord> coords;
  for (std::int32_t i = 0; i < 16; ++i) {
    const auto rows = mixed_range(world, stacks, i % 4, i / 4);
    for (std::int32_t y = rows.first; y <= rows.last; ++y) coords.push_back({i % 4, y, i / 4});
  }
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(extract_chunk(world, stacks, coords[i++ % coords.size()]));
  bench::works_on(state, "chunk", 1);
}
BENCHMARK(extract)->Name("slab of a patch");

}  // namespace

int main(int argc, char** argv) {
  for (const Content& content : kContents) {
    const std::string name = std::string{"encode: "} + content.name;
    benchmark::RegisterBenchmark(name.c_str(),
                                 [make = content.make](State& state) { encode_all(state, make()); });
    benchmark::RegisterBenchmark((std::string{"decode: "} + content.name).c_str(),
                                 [make = content.make](State& state) { decode_all(state, make()); });
    benchmark::RegisterBenchmark((name + "/vs:zstd -3 of dense bytes").c_str(),
                                 [make = content.make](State& state) { zstd_all(state, make()); });
  }
  for (const auto set : {InstructionSet::avx512, InstructionSet::avx2, InstructionSet::scalar}) {
    if (!runs_here(set)) continue;
    for (const bool decodes : {false, true}) {
      const std::string name =
          std::string{decodes ? "decode" : "encode"} + " volumes of a game, " + std::string{to_string(set)};
      benchmark::RegisterBenchmark(name.c_str(), [set, decodes](State& state) {
        volumes_by(state, bench::game_chunks(1), set, decodes);
      });
    }
  }
  return talus::bench::run(argc, argv);
}
