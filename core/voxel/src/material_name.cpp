#include "talus/voxel/material_name.h"

#include <algorithm>

namespace talus {
namespace {

/// Length in bytes of the text's first character; 0 if it is not valid UTF-8.
std::size_t character_bytes(std::string_view text) {
  const auto at = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U; };
  const unsigned first = at(0);
  if (first < 0x80) return 1;
  if (first < 0xC2 || first > 0xF4) return 0;
  // Overlong, a surrogate, or above U+10FFFF.
  if ((first == 0xE0 && at(1) < 0xA0) || (first == 0xED && at(1) > 0x9F) || (first == 0xF0 && at(1) < 0x90) ||
      (first == 0xF4 && at(1) > 0x8F)) {
    return 0;
  }
  const std::size_t bytes = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  for (std::size_t i = 1; i < bytes; ++i) {
    if (at(i) < 0x80 || at(i) > 0xBF) return 0;
  }
  return bytes;
}

bool is_utf8(std::string_view text) {
  while (!text.empty()) {
    const std::size_t bytes = character_bytes(text);
    if (bytes == 0) return false;
    text.remove_prefix(bytes);
  }
  return true;
}

}  // namespace

std::optional<std::string> material_name_fault(std::string_view name) {
  if (name.empty() || name.size() > kMaxMaterialNameBytes) {
    return "a name has 1 to " + std::to_string(kMaxMaterialNameBytes) + " bytes, this has " +
           std::to_string(name.size());
  }
  if (!is_utf8(name)) return "a name is text in UTF-8, and this is not";
  if (std::any_of(name.begin(), name.end(),
                  [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == '\x7F'; })) {
    return "a name is printed as it is, so it holds no control characters";
  }
  if (name == "air" || name == "water") {
    return "'" + std::string{name} + "' is the world's own; choose another name";
  }
  return std::nullopt;
}

}  // namespace talus
