// Describes a payload field by field, for authors of decoders. FORMAT.md defines the fields.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace talus {

/// A part of a payload: `size` bytes at `offset`. `size` is 0 if the value is read from states alone.
struct PayloadField {
  std::size_t offset = 0;
  std::size_t size = 0;
  std::string name;
  std::string meaning;
};

/// Returns the fields of a payload in decoding order, with the first `symbols` coded symbols, their intervals
/// and states. Accepts any bytes: if a decoder would stop, the last field is named "error" and follows the
/// fields read before.
[[nodiscard]] std::vector<PayloadField> explain(std::span<const std::byte> payload, std::size_t symbols = 16);

}  // namespace talus
