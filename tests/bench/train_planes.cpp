// Finds the weights of the codec's planes: train_planes | clang-format-14 > core/voxel/src/plane_weights.h
//
// It fits the weights to the steps of the sample worlds' chunks, then counts what each class of scores comes
// to. The result is part of the payload's format: FORMAT.md lists it, and a change needs a new kCodecVersion.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <vector>

#include <talus/terrain/extraction.h>
#include <talus/terrain/generator.h>

#include "plane_model.h"

namespace {

using namespace talus;
using namespace talus::codec;

// A score counts sixteenths of log odds. From even odds on it is this far to the middle of all classes.
constexpr double kUnit = 16;
constexpr int kSameStart = 40;
constexpr int kUpStart = 64;
constexpr int kSweeps = 40;
constexpr double kProbabilityBits = 8;

/// By its place in the table of each pair: what a column did, weighted.
using Places = std::array<std::uint8_t, kPairs.size()>;
using Counts = std::array<double, 4>;
struct Context {
  Places places;
  Counts counts;
};
using Contexts = std::vector<Context>;
using Columns = std::map<Places, Counts>;
/// By kind of row; of even and of odd columns.
template <class Each>
using ByKind = std::array<std::array<Each, 2>, kRowKinds>;

void add_row(const RowsBefore& before, const Steps& steps, RowKind kind, double weight,
             ByKind<Columns>& found) {
  std::array<Symbol, kChunkSize> symbols;
  for (std::size_t x = 0; x < kChunkSize; ++x) {
    symbols[x] = symbol_of(steps[x] - (kind != kLevel && x > 0 ? steps[x - 1] : 0));
  }
  for (std::size_t x = 0; x < kChunkSize; ++x) {
    const Signs signs = signs_of(before, symbols, static_cast<int>(x));
    Places places{};
    for (std::size_t p = 0; p < pairs_of(x); ++p) {
      places[p] = static_cast<std::uint8_t>(place_of_pair(signs[kPairs[p][0]], signs[kPairs[p][1]]));
    }
    found[kind][x % 2][places][symbols[x]] += weight;
  }
}

void add_plane(const std::uint8_t* plane, const std::uint8_t* below, double weight, ByKind<Columns>& found) {
  Steps north{};
  for (std::size_t z = 0; z < kChunkSize; ++z) {
    const RowsBefore before = RowsBefore::of(plane, below, z, north);
    Steps steps;
    for (std::size_t x = 0; x < kChunkSize; ++x) {
      steps[x] = static_cast<std::int8_t>(plane[z * kChunkSize + x] - predicted_row(before, x));
    }
    add_row(before, steps, z == 0 ? kFirst : better_kind(steps), weight, found);
    north = steps;
  }
}

void add_chunk(const Chunk& chunk, double weight, ByKind<Columns>& found) {
  static constexpr std::array<std::uint8_t, kChunkArea> kFloorPlane{};
  const Layers* const layers = chunk.layers();
  for (std::size_t p = 0; p < layers->plane_count(); ++p) {
    add_plane(layers->plane(p).data(), p == 0 ? kFloorPlane.data() : layers->plane(p - 1).data(), weight,
              found);
  }
}

/// Patches of 4 x 4 tiles, spread over the world.
void add_world(const terrain::World& world, Lod lod, int patches, double weight, ByKind<Columns>& found) {
  constexpr int kTiles = 4;
  for (std::int64_t patch = 0; patch < patches; ++patch) {
    const std::int64_t tile_x = (patch * 7919 % 40 - 20) * 32 * (patch % 2 == 0 ? 37 : 1);
    const std::int64_t tile_z = (patch * 104729 % 50 - 25) * 32;
    const auto stacks = generate_stacks(
        world, {tile_x * kChunkSize, tile_z * kChunkSize, kTiles * kChunkSize, kTiles * kChunkSize, lod});
    for (int i = 0; i < kTiles * kTiles; ++i) {
      const auto x = static_cast<std::int32_t>(tile_x + i % kTiles);
      const auto z = static_cast<std::int32_t>(tile_z + i / kTiles);
      const terrain::MixedRange rows = mixed_range(world, stacks, x, z);
      for (std::int32_t y = rows.first; y <= rows.last; ++y) {
        add_chunk(extract_chunk(world, stacks, {x, y, z}), weight, found);
      }
    }
  }
}

using Tables = std::array<std::array<double, 16>, kPairs.size()>;

double total(const Counts& counts) {
  return counts[kSame] + counts[kUp] + counts[kDown] + counts[kOther];
}

/// Weights by which the sum over a context's pairs is the log odds of `is` within `of`, both parts of its
/// counts: each table in turn takes the step of Newton's method that is best for it.
template <class Is, class Of>
Tables fitted(const Contexts& contexts, std::size_t pairs, const Is& is, const Of& of) {
  Tables tables{};
  std::vector<double> scores(contexts.size());
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    for (std::size_t p = 0; p < pairs; ++p) {
      std::array<double, 16> slope{};
      std::array<double, 16> bend{};
      for (std::size_t i = 0; i < contexts.size(); ++i) {
        const double odds = 1 / (1 + std::exp(-scores[i]));
        const double all = of(contexts[i].counts);
        slope[contexts[i].places[p]] += is(contexts[i].counts) - all * odds;
        bend[contexts[i].places[p]] += all * odds * (1 - odds);
      }
      std::array<double, 16> step{};
      for (std::size_t v = 0; v < step.size(); ++v) {
        step[v] = std::clamp((slope[v] - 0.02 * tables[p][v]) / (bend[v] + 0.5), -2.0, 2.0);
        tables[p][v] += step[v];
      }
      for (std::size_t i = 0; i < contexts.size(); ++i) scores[i] += step[contexts[i].places[p]];
    }
  }
  return tables;
}

using RoundedTables = std::array<std::array<std::int8_t, 16>, kPairs.size()>;

/// In units, with where scores start in the first pair, of which every column has a value.
RoundedTables rounded(const Tables& tables, int start) {
  RoundedTables all{};
  for (std::size_t p = 0; p < kPairs.size(); ++p) {
    for (std::size_t v = 0; v < 16; ++v) {
      const auto value = static_cast<int>(std::lround(tables[p][v] * kUnit)) + (p == 0 ? start : 0);
      all[p][v] = static_cast<std::int8_t>(std::clamp(value, -127, 127));
    }
  }
  return all;
}

std::size_t class_in(const RoundedTables& weights, const Places& places, std::size_t odd) {
  int score = 0;
  for (std::size_t p = 0; p < pairs_of(odd); ++p) score = add_weight(score, weights[p][places[p]]);
  return class_of(score);
}

void print(const std::array<std::int8_t, 16>& weights) {
  std::printf("{");
  for (const int weight : weights) std::printf("%d,", weight);
  std::printf("},");
}

void print(const char* comment, const char* name, const std::array<int, kClasses>& intervals) {
  std::printf("/// %s\ninline constexpr std::array<std::uint8_t, kClasses> %s{", comment, name);
  for (const int each : intervals) std::printf("%d,", each);
  std::printf("};\n");
}

}  // namespace

int main() {
  ByKind<Columns> found;
  for (const std::string name : {"classic", "canyon", "hills"}) {
    std::ifstream file{std::string{TALUS_SOURCE_DIR "/core/worlds/"} + name + ".toml"};
    const std::string text{std::istreambuf_iterator<char>{file}, {}};
    const auto world = terrain::World::parse(text, name);
    if (!world) return std::fprintf(stderr, "core/worlds/%s.toml is not a world\n", name.c_str()), 1;
    for (int level = 0; level <= 4; ++level) {
      std::fprintf(stderr, "%s, level %d\n", name.c_str(), level);
      add_world(*world, Lod::of(level), level == 0 ? 16 : 5, level == 0 ? 1 : 0.3, found);
    }
  }
  ByKind<Contexts> contexts;
  ByKind<RoundedTables> same;
  ByKind<RoundedTables> up;
  std::array<Counts, kClasses> by_same{};
  std::array<Counts, kClasses> by_up{};
  for (std::size_t kind = 0; kind < kRowKinds; ++kind) {
    for (const std::size_t odd : {0U, 1U}) {
      Contexts& all = contexts[kind][odd];
      for (const auto& [places, counts] : found[kind][odd]) all.push_back({places, counts});
      same[kind][odd] = rounded(fitted(
                                    all, pairs_of(odd), [](const Counts& n) { return n[kSame]; }, total),
                                kSameStart);
      up[kind][odd] = rounded(fitted(
                                  all, pairs_of(odd), [](const Counts& n) { return n[kUp]; },
                                  [](const Counts& n) { return n[kUp] + n[kDown]; }),
                              kUpStart);
      for (const Context& context : all) {
        for (const Symbol symbol : {kSame, kUp, kDown, kOther}) {
          by_same[class_in(same[kind][odd], context.places, odd)][symbol] += context.counts[symbol];
          by_up[class_in(up[kind][odd], context.places, odd)][symbol] += context.counts[symbol];
        }
      }
    }
  }
  const auto part_of_256 = [](double part, double whole) {
    return static_cast<int>(std::lround(part / std::max(whole, 1e-9) * kProbabilityTotal));
  };
  std::array<int, kClasses> same_end{};
  std::array<int, kClasses> other_start{};
  std::array<int, kClasses> up_split{};
  for (std::size_t c = 0; c < kClasses; ++c) {
    const auto& n = by_same[c];
    other_start[c] = kProbabilityTotal - std::max(1, part_of_256(n[kOther], total(n)));
    same_end[c] = std::clamp(part_of_256(n[kSame], total(n)), 1, other_start[c] - 2);
    up_split[c] = std::clamp(part_of_256(by_up[c][kUp], by_up[c][kUp] + by_up[c][kDown]), 1, 255);
  }

  std::printf(
      R"(// What train_planes (tests/bench) found on the sample worlds at levels 0 to 4. Part of the payload's format:
// FORMAT.md lists the same numbers, and a change needs a new kCodecVersion.
#pragma once

#include "plane_model.h"

namespace talus::codec {

// clang-format off
/// By kind of row; of even and of odd columns; by pair.
inline constexpr std::array<std::array<Weights, 2>, kRowKinds> kWeights{{
)");
  for (std::size_t kind = 0; kind < kRowKinds; ++kind) {
    std::printf("{{\n");
    for (const std::size_t odd : {0U, 1U}) {
      std::printf("  {{\n");
      for (std::size_t p = 0; p < pairs_of(odd); ++p) {
        std::printf("    {");
        print(same[kind][odd][p]);
        std::printf("\n     ");
        print(up[kind][odd][p]);
        std::printf("},\n");
      }
      std::printf("  }},\n");
    }
    std::printf("}},\n");
  }
  std::printf("}};\n\n");
  print("By class of the score of kSame: where its interval ends.", "kSameEnd", same_end);
  print("Where the interval of kOther begins.", "kOtherStart", other_start);
  print("By class of the score of kUp: of 256, its part of what lies between.", "kUpSplit", up_split);
  std::printf("// clang-format on\n\n}  // namespace talus::codec\n");

  double bits = 0;
  double columns = 0;
  for (std::size_t kind = 0; kind < kRowKinds; ++kind) {
    for (const std::size_t odd : {0U, 1U}) {
      for (const auto& [places, counts] : contexts[kind][odd]) {
        const std::size_t c = class_in(same[kind][odd], places, odd);
        const std::size_t d = class_in(up[kind][odd], places, odd);
        const int down = same_end[c] + 1 + ((other_start[c] - same_end[c] - 2) * up_split[d] >> 8);
        const std::array<int, 5> starts{0, same_end[c], down, other_start[c], kProbabilityTotal};
        for (const Symbol symbol : {kSame, kUp, kDown, kOther}) {
          const int size = starts[symbol + 1U] - starts[symbol];
          bits += counts[symbol] * (kProbabilityBits - std::log2(size) + (symbol == kOther ? 8 : 0));
        }
        columns += total(counts);
      }
    }
  }
  std::fprintf(stderr, "%.4f bits a column\n", bits / columns);
}
