// Text from parts. Not by std::ostream, whose locales would be a tenth of core/wasm. Private to core/terrain.
#pragma once

#include <concepts>
#include <string>
#include <string_view>
#include <utility>

namespace talus::terrain {

class TextWriter {
 public:
  TextWriter& operator<<(std::string_view part) {
    text_ += part;
    return *this;
  }
  TextWriter& operator<<(std::same_as<char> auto part) {
    text_ += part;
    return *this;
  }
  /// In decimal. Not a byte, which may be a character or a number: convert it.
  template <std::integral Number>
  requires(sizeof(Number) > 1) TextWriter& operator<<(Number number) {
    text_ += std::to_string(number);
    return *this;
  }

  [[nodiscard]] std::string take() && { return std::move(text_); }

 private:
  std::string text_;
};

}  // namespace talus::terrain
