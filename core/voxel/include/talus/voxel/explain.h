// A payload field by field, for somebody who writes a decoder: FORMAT.md has the meaning of each.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace talus {

/// A part of a payload: `size` bytes from `offset` on, or 0 where what is read comes from states alone.
struct PayloadField {
  std::size_t offset = 0;
  std::size_t size = 0;
  std::string name;
  std::string meaning;
};

/// The fields of a payload in the order in which a decoder reads them, with the first `symbols` coded
/// symbols, their intervals and states. Whatever the bytes are: where a decoder would stop the last field is
/// named "error", and any others are as far as it came.
[[nodiscard]] std::vector<PayloadField> explain(std::span<const std::byte> payload, std::size_t symbols = 16);

}  // namespace talus
