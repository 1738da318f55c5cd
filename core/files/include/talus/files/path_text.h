// Paths as text, which is UTF-8 on every system: from a char std::filesystem converts by the system's code
// page on Windows.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace talus::files {

[[nodiscard]] inline std::filesystem::path to_path(std::string_view text) {
  const auto* const first = reinterpret_cast<const char8_t*>(text.data());
  return {first, first + text.size()};
}

[[nodiscard]] inline std::string to_text(const std::filesystem::path& path) {
  const std::u8string text = path.u8string();
  return {text.begin(), text.end()};
}

}  // namespace talus::files
