// The known name nearest to a mistyped one.
#pragma once

#include <span>
#include <string_view>

namespace talus {

/// The candidate with the fewest insertions, deletions and replacements from `word`; the first on a tie.
/// `candidates` is not empty.
[[nodiscard]] std::string_view nearest(std::string_view word, std::span<const std::string_view> candidates);

/// The nearest, where so few changes make it of `word` that it was hardly meant otherwise: one for each four
/// characters. Else empty.
[[nodiscard]] std::string_view meant(std::string_view word, std::span<const std::string_view> candidates);

}  // namespace talus
