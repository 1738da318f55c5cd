// Finds the known name nearest to a mistyped one.
#pragma once

#include <span>
#include <string_view>

namespace talus {

/// The candidate with the fewest insertions, deletions and replacements from `word`; the first one on a tie.
/// REQUIRES: `candidates` is not empty.
[[nodiscard]] std::string_view nearest(std::string_view word, std::span<const std::string_view> candidates);

/// The nearest candidate if it needs at most one change per four characters, so that it was probably meant;
/// otherwise empty.
[[nodiscard]] std::string_view meant(std::string_view word, std::span<const std::string_view> candidates);

}  // namespace talus
