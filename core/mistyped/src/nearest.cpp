#include <talus/mistyped/nearest.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>
#include <vector>

namespace talus {
namespace {

constexpr std::size_t kMaxCompared = 128;  // bytes of a word compared, to bound the time

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({replaced, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row.back();
}

}  // namespace

std::string_view nearest(std::string_view word, std::span<const std::string_view> candidates) {
  std::string_view best;
  std::size_t least = std::numeric_limits<std::size_t>::max();
  for (const std::string_view candidate : candidates) {
    const std::size_t distance = edit_distance(word.substr(0, kMaxCompared), candidate);
    if (distance < least) {
      least = distance;
      best = candidate;
    }
  }
  return best;
}

std::string_view meant(std::string_view word, std::span<const std::string_view> candidates) {
  constexpr std::size_t kCharactersPerChange = 4;
  if (candidates.empty()) return {};
  const std::string_view best = nearest(word, candidates);
  const std::size_t most = (word.size() + kCharactersPerChange - 1) / kCharactersPerChange;
  return edit_distance(word.substr(0, kMaxCompared), best) <= most ? best : std::string_view{};
}

}  // namespace talus
