#include "chunks/generation/cost_model.h"

#include <algorithm>

namespace talus::server {
namespace {

// Guesses before any was measured, in nanoseconds.
constexpr std::uint64_t kGuessedPatch = 2'000'000;
constexpr std::uint64_t kGuessedChunk = 20'000;
constexpr std::uint64_t kGuessedHeight = 500;

std::uint64_t mean(std::chrono::nanoseconds time, std::uint64_t count, std::uint64_t guess) {
  if (count == 0) return guess;
  return std::max<std::uint64_t>(1, static_cast<std::uint64_t>(time.count()) / count);
}

}  // namespace

void CostModel::add(const MeasuredWork& work) {
  total_.patch_time += work.patch_time;
  total_.chunk_time += work.chunk_time;
  total_.height_time += work.height_time;
  total_.patches += work.patches;
  total_.chunks += work.chunks;
  total_.heights += work.heights;
}

WorkCosts CostModel::costs() const {
  WorkCosts costs;
  costs.patch = mean(total_.patch_time, total_.patches, kGuessedPatch);
  costs.chunk = mean(total_.chunk_time, total_.chunks, kGuessedChunk);
  costs.height = mean(total_.height_time, total_.heights, kGuessedHeight);
  return costs;
}

}  // namespace talus::server
