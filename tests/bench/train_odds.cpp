// Finds the odds of the codec's planes: train_odds | clang-format-14 > core/voxel/src/layered_odds.h
//
// It counts every step of the sample worlds' chunks in each of its contexts, then merges the contexts whose
// odds are alike until few distributions are left, at each merge the one that costs the fewest bits. The
// result is part of the payload's format: FORMAT.md lists it, and a change needs a new kCodecVersion.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

#include <talus/terrain/stacks.h>

#include "kernels.h"

namespace {

using namespace talus;

constexpr std::size_t kKept = 48;
constexpr std::size_t kPlaces = 16;
constexpr int kTotal = 4096;
constexpr int kLeastShare = 3;  // a step that training never met stays affordable

using Counts = std::array<double, 4>;  // as predicted, one up, one down, further

struct Statistics {
  std::vector<Counts> steps = std::vector<Counts>(codec::kContexts);
  std::array<double, kPlaces> further{};
};

void count_plane(const std::uint8_t* plane, const std::uint8_t* below, double weight, Statistics& found) {
  std::array<codec::Steps, kChunkSize> steps;
  for (std::size_t z = 0; z < kChunkSize; ++z) {
    codec::RowGuess guess;
    codec::RowSymbols row;
    const auto before = codec::RowsBefore::of(plane, below, z, steps[z == 0 ? 0 : z - 1]);
    voxel_kernels().guess(before, guess);
    voxel_kernels().classify(plane + z * kChunkSize, guess, steps[z], row);
    for (std::size_t x = 0; x < kChunkSize; ++x) {
      found.steps[row.context[x]][row.symbol[x]] += weight;
      if (row.symbol[x] != codec::kFurtherOff) continue;
      const int change = codec::change_of(steps[z].data()[x], steps[z].padded[x]);
      found.further[std::min<std::size_t>(codec::place_of(change), kPlaces - 1)] += weight;
    }
  }
}

void count_chunk(const Chunk& chunk, double weight, Statistics& found) {
  const Layers* const layers = chunk.layers();
  for (std::size_t p = 0; p < layers->plane_count(); ++p) {
    count_plane(layers->plane(p).data(), p == 0 ? nullptr : layers->plane(p - 1).data(), weight, found);
  }
}

/// Patches of 4 x 4 tiles, spread over the world.
void count_world(const terrain::World& world, Lod lod, int patches, double weight, Statistics& found) {
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
        count_chunk(extract_chunk(world, stacks, {x, y, z}), weight, found);
      }
    }
  }
}

double total(const Counts& counts) {
  return counts[0] + counts[1] + counts[2] + counts[3];
}

Counts sum(const Counts& a, const Counts& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2], a[3] + b[3]};
}

/// Bits of all counted steps by their own odds.
double cost(const Counts& counts) {
  double bits = 0;
  for (const double count : counts) {
    if (count > 0) bits -= count * std::log2(count / total(counts));
  }
  return bits;
}

/// Shares of kTotal, none below kLeastShare.
template <std::size_t size>
std::array<int, size> shares(const std::array<double, size>& counts) {
  double sum = 0;
  for (const double count : counts) sum += count;
  std::array<int, size> shares{};
  int given = 0;
  for (std::size_t i = 0; i < size; ++i) {
    shares[i] = std::max(kLeastShare, static_cast<int>(std::lround(counts[i] / sum * kTotal)));
    given += shares[i];
  }
  *std::max_element(shares.begin(), shares.end()) += kTotal - given;
  return shares;
}

/// Merges groups of contexts until kKept are left. Each group remembers its cheapest partner.
std::vector<Counts> merged(std::vector<Counts> groups) {
  struct Partner {
    std::size_t index = 0;
    double loss = std::numeric_limits<double>::infinity();
  };
  const auto find_partner = [&groups](std::size_t i) {
    Partner best;
    for (std::size_t j = 0; j < groups.size(); ++j) {
      if (j == i || total(groups[j]) == 0) continue;
      const double loss = cost(sum(groups[i], groups[j])) - cost(groups[i]) - cost(groups[j]);
      if (loss < best.loss) best = {j, loss};
    }
    return best;
  };
  std::erase_if(groups, [](const Counts& counts) { return total(counts) == 0; });
  std::vector<Partner> partners;
  for (std::size_t i = 0; i < groups.size(); ++i) partners.push_back(find_partner(i));
  for (std::size_t left = groups.size(); left > kKept; --left) {
    const auto cheapest = static_cast<std::size_t>(
        std::min_element(partners.begin(), partners.end(),
                         [](const Partner& a, const Partner& b) { return a.loss < b.loss; }) -
        partners.begin());
    const std::size_t taken = partners[cheapest].index;
    groups[cheapest] = sum(groups[cheapest], groups[taken]);
    groups[taken] = {};
    partners[taken] = {};
    partners[cheapest] = find_partner(cheapest);
    for (std::size_t i = 0; i < groups.size(); ++i) {
      if (total(groups[i]) == 0 || i == cheapest) continue;
      if (partners[i].index == taken || partners[i].index == cheapest) partners[i] = find_partner(i);
    }
  }
  std::erase_if(groups, [](const Counts& counts) { return total(counts) == 0; });
  std::sort(groups.begin(), groups.end(),
            [](const Counts& a, const Counts& b) { return a[0] / total(a) > b[0] / total(b); });
  return groups;
}

/// Of `kept`, the one whose shares cost a context's steps least; what was never met goes by `usual`.
std::size_t best_of(const std::vector<std::array<int, 4>>& kept, const Counts& counts, const Counts& usual) {
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < kept.size(); ++k) {
    double bits = 0;
    for (std::size_t s = 0; s < counts.size(); ++s) {
      bits -= (counts[s] + usual[s] / total(usual) / 1000) * std::log2(kept[k][s]);
    }
    if (bits < least) {
      least = bits;
      best = k;
    }
  }
  return best;
}

char digit(std::size_t value) {
  return "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijkl"[value];
}

void print(const std::vector<std::array<int, 4>>& kept, const std::string& of_context,
           const std::array<int, kPlaces>& further) {
  std::printf(
      R"(// How likely each step is in each context, as train_odds (tests/bench) found it on the sample worlds at
// levels 0 to 4. Part of the payload's format: FORMAT.md lists the same numbers, and a change needs a new
// kCodecVersion.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "row_guess.h"

namespace talus::codec {

/// Of 4096: where the shares of "one up", "one down" and "further" begin; "as predicted" begins at 0.
struct Odds {
  std::uint16_t up;
  std::uint16_t down;
  std::uint16_t further;
};

// clang-format off
inline constexpr std::array<Odds, %zu> kOdds{{
)",
      kept.size());
  for (std::size_t k = 0; k < kept.size(); ++k) {
    const auto& share = kept[k];
    std::printf("%s{%d, %d, %d},%s", k % 4 == 0 ? "    " : " ", share[0], share[0] + share[1],
                share[0] + share[1] + share[2], k % 4 == 3 ? "\n" : "");
  }
  std::printf(
      "}};\n\n/// By context, which of kOdds: 0 to 9, A to Z, a to l.\n"
      "inline constexpr std::string_view kOddsOfContext =\n");
  constexpr std::size_t kLine = 81;
  for (std::size_t i = 0; i < of_context.size(); i += kLine) {
    std::printf("    \"%s\"%s\n", of_context.substr(i, kLine).c_str(),
                i + kLine >= of_context.size() ? ";" : "");
  }
  std::printf(
      "static_assert(kOddsOfContext.size() == kContexts);\n\n"
      "/// Of 4096: where the share of each place of the list 2, -2, 3, -3, ... begins; the last share, up "
      "to\n"
      "/// 4096, is that of all places from 15 on.\n"
      "inline constexpr std::array<std::uint16_t, %zu> kFurther{\n   ",
      kPlaces + 1);
  int start = 0;
  for (const int share : further) {
    std::printf(" %d,", start);
    start += share;
  }
  std::printf(" %d};\n// clang-format on\n\n}  // namespace talus::codec\n", start);
}

}  // namespace

int main() {
  Statistics found;
  for (const std::string name : {"default", "canyon", "hills"}) {
    std::ifstream file{std::string{TALUS_SOURCE_DIR "/core/worlds/"} + name + ".toml"};
    const std::string text{std::istreambuf_iterator<char>{file}, {}};
    const auto world = terrain::World::parse(text, name);
    if (!world) return std::fprintf(stderr, "core/worlds/%s.toml is no world\n", name.c_str()), 1;
    for (int level = 0; level <= 4; ++level) {
      std::fprintf(stderr, "%s, level %d\n", name.c_str(), level);
      count_world(*world, Lod::of(level), level == 0 ? 16 : 5, level == 0 ? 1 : 0.3, found);
    }
  }
  Counts usual{};
  for (const Counts& counts : found.steps) usual = sum(usual, counts);
  std::vector<std::array<int, 4>> kept;
  for (const Counts& group : merged(found.steps)) kept.push_back(shares(group));
  std::string of_context;
  for (const Counts& counts : found.steps) of_context += digit(best_of(kept, counts, usual));
  print(kept, of_context, shares(found.further));
}
