// Finds the known name nearest to a mistyped one.
#pragma once

#include <span>
#include <string_view>

namespace talus {

/// Returns the candidate with the fewest changes from `word`, the first one on a tie. Empty if each candidate
/// needs more than one change, and more than one per four characters of `word`. A change is an insertion, a
/// deletion, a replacement or an exchange of two neighbours.
[[nodiscard]] std::string_view meant(std::string_view word, std::span<const std::string_view> candidates);

}  // namespace talus
