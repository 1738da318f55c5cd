// Finds the probabilities of the codec's volumes: train_volume | clang-format-14 >
// core/voxel/src/volume_tables.h
//
// It counts what the voxels of many chunks are in each context, sorts the chunks into kVolumeTables groups so
// that each group's own probabilities cost the fewest bits, and rounds all probabilities to kVolumeClasses
// classes. The result is part of the payload's format: FORMAT.md lists it, and a change needs a new
// kCodecVersion. train_volume --document prints the tables as FORMAT.md has them.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <limits>
#include <memory>
#include <numeric>
#include <string>
#include <vector>

#include "fixtures.h"
#include "fixtures/game_chunks.h"
#include "volume_model.h"

namespace {

using namespace talus;
using namespace talus::codec;

constexpr std::size_t kTables = 8;
constexpr std::size_t kClasses = 62;
constexpr char kDigits[] = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz";
constexpr int kRounds = 30;
constexpr double kTotal = 256;

using Counts = std::array<double, 4>;
using ByContext = std::array<Counts, kVolumeContexts>;
using Ends = std::array<int, 3>;

ByContext counted(const Chunk& chunk) {
  ByContext counts{};
  const auto voxels = std::make_unique<DenseVoxels>();
  chunk.copy_to(*voxels);
  std::array<MaterialId, kChunkSize> row_zero;
  row_zero.fill(voxels->front());
  for (int y = 0; y < kChunkSize; ++y) {
    for (int z = 0; z < kChunkSize; ++z) {
      const MaterialId* const row = voxels->data() + (y * kChunkSize + z) * kChunkSize;
      const RowsAround around = rows_around(voxels->data(), row_zero.data(), y, z);
      for (int x = 0; x < kChunkSize; ++x) {
        const Prediction prediction = predict(around, row, x);
        if (prediction.steady) continue;
        std::size_t symbol = 0;
        while (symbol < prediction.candidates && prediction.candidate[symbol] != row[x]) ++symbol;
        if (symbol == prediction.candidates) symbol = kEscape;
        counts[static_cast<std::size_t>(prediction.context)][symbol] += 1;
      }
    }
  }
  return counts;
}

double total(const Counts& counts) {
  return std::accumulate(counts.begin(), counts.end(), 0.0);
}

/// What the counts' symbols cost by the probabilities of `model`, in bits.
double bits(const Counts& counts, const Counts& model) {
  double sum = 0;
  for (std::size_t s = 0; s < 4; ++s) sum += counts[s] == 0 ? 0 : -counts[s] * std::log2(model[s]);
  return sum;
}

Counts probabilities(const Counts& counts) {
  Counts model;
  for (std::size_t s = 0; s < 4; ++s) model[s] = std::max(counts[s] / total(counts), 1 / kTotal);
  const double sum = total(model);
  for (double& each : model) each /= sum;
  return model;
}

Ends rounded(const Counts& model) {
  Ends ends;
  double sum = 0;
  int last = 0;
  for (int s = 0; s < 3; ++s) {
    sum += model[static_cast<std::size_t>(s)] * kTotal;
    last = std::clamp(static_cast<int>(std::lround(sum)), last + 1, 253 + s);
    ends[static_cast<std::size_t>(s)] = last;
  }
  return ends;
}

Counts model_of(const Ends& ends) {
  return {ends[0] / kTotal, (ends[1] - ends[0]) / kTotal, (ends[2] - ends[1]) / kTotal,
          (kTotal - ends[2]) / kTotal};
}

std::vector<ByContext> all_counts() {
  std::vector<ByContext> all;
  const auto add = [&all](const std::vector<Chunk>& chunks) {
    for (const Chunk& chunk : chunks) all.push_back(counted(chunk));
  };
  const auto base = bench::mixed_chunks();
  const auto changed = [&base](const auto& change) {
    std::vector<Chunk> chunks;
    for (const Chunk& chunk : base) chunks.push_back(change(chunk));
    return chunks;
  };
  for (const std::uint32_t seed : {1U, 50U, 100U, 150U}) add(bench::game_chunks(seed));
  add(bench::forest_chunks(base));
  add(changed(bench::edited));
  add(changed(bench::with_hole));
  add(bench::mixed_chunks(bench::classic_world(), Lod::of(2)));
  add(bench::mixed_chunks(bench::sample_world("canyon"), Lod::of(1)));
  add(bench::cave_chunks(true));
  for (const int times : {1, 2, 4, 8}) add(bench::mixed_chunks(bench::rough_world(7, times)));
  for (std::uint32_t seed = 1; seed <= 4; ++seed) {
    add({bench::random_chunk(seed, 4, 1), bench::random_chunk(seed, 40, 3),
         bench::random_chunk(seed, 8, 60)});
  }
  return all;
}

/// The models of each table: chunks go to the table that is best for them, tables are made of their chunks.
std::vector<ByContext> grouped(const std::vector<ByContext>& chunks, std::vector<ByContext>& weights) {
  ByContext prior{};
  for (Counts& each : prior) each = {0.5, 0.1, 0.1, 0.2};
  for (const ByContext& chunk : chunks) {
    for (std::size_t c = 0; c < prior.size(); ++c) {
      for (std::size_t s = 0; s < 4; ++s) prior[c][s] += chunk[c][s] * 0.01;
    }
  }
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t i = 0; i < chunks.size(); ++i) {
    double coded = 1;
    double first = 0;
    for (const Counts& each : chunks[i]) {
      coded += total(each);
      first += each[0];
    }
    order.emplace_back(first / coded, i);
  }
  std::sort(order.begin(), order.end());
  std::vector<std::size_t> table_of(chunks.size());
  for (std::size_t i = 0; i < order.size(); ++i) table_of[order[i].second] = i * kTables / order.size();
  std::vector<ByContext> models(kTables);
  for (int round = 0; round < kRounds; ++round) {
    for (std::size_t t = 0; t < kTables; ++t) {
      weights[t] = prior;
      for (Counts& each : weights[t]) {
        const double sum = total(each);
        for (double& count : each) count *= 8 / sum;
      }
      for (std::size_t i = 0; i < chunks.size(); ++i) {
        if (table_of[i] != t) continue;
        for (std::size_t c = 0; c < prior.size(); ++c) {
          for (std::size_t s = 0; s < 4; ++s) weights[t][c][s] += chunks[i][c][s];
        }
      }
      for (std::size_t c = 0; c < prior.size(); ++c) models[t][c] = probabilities(weights[t][c]);
    }
    for (std::size_t i = 0; i < chunks.size(); ++i) {
      double least = std::numeric_limits<double>::max();
      for (std::size_t t = 0; t < kTables; ++t) {
        double cost = 0;
        for (std::size_t c = 0; c < prior.size(); ++c) cost += bits(chunks[i][c], models[t][c]);
        if (cost < least) {
          least = cost;
          table_of[i] = t;
        }
      }
    }
  }
  return models;
}

}  // namespace

int main(int argc, char** argv) {
  const auto chunks = all_counts();
  std::vector<ByContext> weights(kTables);
  const auto models = grouped(chunks, weights);

  // Classes: each context of each table goes to the class that costs it the fewest bits.
  std::vector<Counts> points;
  for (const ByContext& each : weights) points.insert(points.end(), each.begin(), each.end());
  std::vector<std::size_t> by_first(points.size());
  std::iota(by_first.begin(), by_first.end(), std::size_t{0});
  std::sort(by_first.begin(), by_first.end(), [&](std::size_t a, std::size_t b) {
    return points[a][0] / total(points[a]) < points[b][0] / total(points[b]);
  });
  std::vector<std::size_t> class_of(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) class_of[by_first[i]] = i * kClasses / points.size();
  std::vector<Ends> classes(kClasses);
  for (int round = 0; round < kRounds; ++round) {
    for (std::size_t k = 0; k < kClasses; ++k) {
      Counts sum{0.1, 0.1, 0.1, 0.1};
      for (std::size_t i = 0; i < points.size(); ++i) {
        if (class_of[i] != k) continue;
        for (std::size_t s = 0; s < 4; ++s) sum[s] += points[i][s];
      }
      classes[k] = rounded(probabilities(sum));
    }
    std::vector<double> loss(points.size());
    std::vector<std::size_t> members(kClasses);
    for (std::size_t i = 0; i < points.size(); ++i) {
      double least = std::numeric_limits<double>::max();
      for (std::size_t k = 0; k < kClasses; ++k) {
        const double cost = bits(points[i], model_of(classes[k]));
        if (cost >= least) continue;
        least = cost;
        class_of[i] = k;
      }
      loss[i] = least - bits(points[i], probabilities(points[i]));
      ++members[class_of[i]];
    }
    // A class that nothing chose takes the context that loses most.
    for (std::size_t k = 0; k < kClasses && round + 1 < kRounds; ++k) {
      if (members[k] > 0) continue;
      const auto worst = static_cast<std::size_t>(std::max_element(loss.begin(), loss.end()) - loss.begin());
      class_of[worst] = k;
      loss[worst] = 0;
    }
  }

  std::vector<std::string> lines(kTables);
  for (std::size_t i = 0; i < points.size(); ++i) lines[i / kVolumeContexts] += kDigits[class_of[i]];
  if (argc == 2 && std::strcmp(argv[1], "--document") == 0) {
    std::printf("```volume-ends\n");
    for (std::size_t k = 0; k < kClasses; ++k) {
      std::printf("%3d %3d %3d%s", classes[k][0], classes[k][1], classes[k][2],
                  k % 8 == 7 || k + 1 == kClasses ? "\n" : "   ");
    }
    std::printf("```\n\n");
    for (const std::string& line : lines) {
      std::printf("```volume-classes\n");
      for (std::size_t at = 0; at < line.size(); at += 64) std::printf("%s\n", line.substr(at, 64).c_str());
      std::printf("```\n\n");
    }
    return 0;
  }
  std::printf(
      "// The probabilities of volumes: made by train_volume (tests/bench), part of the payload's format.\n"
      "// FORMAT.md lists the same numbers, and a change needs a new kCodecVersion.\n"
      "#pragma once\n\n#include <array>\n#include <cstdint>\n#include <string_view>\n\n"
      "namespace talus::codec {\n\n"
      "/// By class: where the intervals of symbols 0, 1 and 2 end; that of symbol 3 ends at 256.\n"
      "inline constexpr std::array<std::array<std::uint8_t, 3>, %zu> kVolumeEnds{{",
      kClasses);
  for (const Ends& ends : classes) std::printf("{%d, %d, %d}, ", ends[0], ends[1], ends[2]);
  std::printf(
      "}};\n\n/// By table and context: a class, as a digit: 0 to 9, A to Z, a to z.\n"
      "inline constexpr std::array<std::string_view, %zu> kVolumeClasses{",
      kTables);
  for (const std::string& line : lines) std::printf("\"%s\",\n", line.c_str());
  std::printf("};\n\n}  // namespace talus::codec\n");
}
