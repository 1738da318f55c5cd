// Text of talus_last_error(), in a fixed buffer, so that reporting a failed allocation needs no memory.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <string_view>

namespace talus::c_api {

class ErrorLine {
 public:
  /// "FUNCTION: WHAT", truncated if too long, but not inside a character.
  void set(std::string_view function, std::string_view what) noexcept {
    end_ = 0;
    append(function);
    append(": ");
    append(what);
    text_[end_] = '\0';
  }
  [[nodiscard]] const char* text() const noexcept { return text_.data(); }

 private:
  void append(std::string_view part) noexcept {
    std::size_t bytes = std::min(part.size(), text_.size() - 1 - end_);
    const auto continues = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; };  // UTF-8
    while (bytes > 0 && bytes < part.size() && continues(part[bytes])) --bytes;
    std::memcpy(text_.data() + end_, part.data(), bytes);
    end_ += bytes;
  }

  std::array<char, 512> text_{};
  std::size_t end_ = 0;
};

}  // namespace talus::c_api
