#include <talus/mistyped/nearest.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace talus {
namespace {

constexpr std::size_t kMaxCompared = 128;  // bytes of a word compared, to bound the time

/// Number of insertions, deletions, replacements and exchanges of neighbours.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> older(b.size() + 1);
  std::vector<std::size_t> above(b.size() + 1);
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    older.swap(above);
    above.swap(row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = above[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({replaced, above[j] + 1, row[j - 1] + 1});
      const bool exchanged = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (exchanged) row[j] = std::min(row[j], older[j - 2] + 1);
    }
  }
  return row.back();
}

}  // namespace

std::string_view meant(std::string_view word, std::span<const std::string_view> candidates) {
  constexpr std::size_t kCharactersPerChange = 4;
  word = word.substr(0, kMaxCompared);
  std::string_view best;
  std::size_t least = std::max<std::size_t>(1, word.size() / kCharactersPerChange) + 1;
  for (const std::string_view candidate : candidates) {
    const std::size_t distance = edit_distance(word, candidate);
    if (distance < least) {
      least = distance;
      best = candidate;
    }
  }
  return best;
}

}  // namespace talus
