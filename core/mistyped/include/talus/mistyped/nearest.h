// Finds the known name nearest to a mistyped one.
#pragma once

#include <span>
#include <string_view>

namespace talus {

/// The candidate with the fewest changes from `word`, the first one on a tie; empty if all need more than one
/// change per four characters, and more than one at all, so that none was probably meant. A change is an
/// insertion, a deletion, a replacement or an exchange of two neighbours.
[[nodiscard]] std::string_view meant(std::string_view word, std::span<const std::string_view> candidates);

}  // namespace talus
