// One bit per column. Private to core/terrain.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace talus::terrain {

/// The lowest `count` bits; 0 if negative, 64 at most.
[[nodiscard]] inline std::uint64_t bits_below(int count) {
  if (count <= 0) return 0;
  return count >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << count) - 1;
}

/// Rows of columns, 64 per word; column 0 is the lowest bit of a row's first word. Bits past a row's columns
/// are 0. A row has a spare word, so that kernels may set bits across two words.
class ColumnBits {
 public:
  /// Sets all bits to 0.
  void start(int width, int depth) {
    words_ = static_cast<std::size_t>(width) / 64 + 2;
    bits_.assign(words_ * static_cast<std::size_t>(depth), 0);
  }

  [[nodiscard]] std::uint64_t* row(int z) { return bits_.data() + words_ * static_cast<std::size_t>(z); }
  [[nodiscard]] const std::uint64_t* row(int z) const {
    return bits_.data() + words_ * static_cast<std::size_t>(z);
  }
  /// The bits of 64 columns from x on; bits outside of the row are 0.
  [[nodiscard]] std::uint64_t from(int z, int x) const {
    const int shift = x & 63;
    const int word = (x - shift) / 64;
    const std::uint64_t low = at(z, word) >> shift;
    return shift == 0 ? low : low | at(z, word + 1) << (64 - shift);
  }

 private:
  [[nodiscard]] std::uint64_t at(int z, int word) const {
    const auto i = static_cast<std::size_t>(word);  // huge if negative
    return i < words_ ? row(z)[i] : 0;
  }

  std::size_t words_ = 0;
  std::vector<std::uint64_t> bits_;
};

/// Calls body(x) for columns first <= x < last of a row whose bits are set. `word_at(i)` is the row's word i.
template <class WordAt, class Body>
void for_set_bits(int first, int last, const WordAt& word_at, const Body& body) {
  for (int word = first / 64; word * 64 < last; ++word) {
    std::uint64_t bits = word_at(static_cast<std::size_t>(word));
    bits &= bits_below(last - word * 64) & ~bits_below(first - word * 64);
    for (; bits != 0; bits &= bits - 1) body(word * 64 + std::countr_zero(bits));
  }
}

}  // namespace talus::terrain
