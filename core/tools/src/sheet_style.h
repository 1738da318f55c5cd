// Shared style of a sheet's parts: measures, colours, lettering and number formats.
#pragma once

#include <array>
#include <cstdint>
#include <cstdio>
#include <string>

#include <talus/pictures/stroke_font.h>
#include <talus/terrain/world.h>

#include "canvas.h"

namespace talus::tools::sheet {

// Pixels.
inline constexpr int kMargin = 56;
inline constexpr int kMapSide = 616;
inline constexpr int kMapGap = 32;
inline constexpr int kInside = 3 * kMapSide + 2 * kMapGap;
inline constexpr int kWidth = kInside + 2 * kMargin;

inline constexpr terrain::Colour kPaper{246, 243, 236};
inline constexpr terrain::Colour kInk{38, 42, 50};
inline constexpr terrain::Colour kPale{88, 90, 94};
inline constexpr terrain::Colour kRule{214, 208, 196};
inline constexpr terrain::Colour kWhite{255, 255, 255};
inline constexpr terrain::Colour kNight{20, 24, 30};

inline constexpr pictures::TextStyle kHeading{30, 3.2F};
inline constexpr pictures::TextStyle kTitle{15, 2};
inline constexpr pictures::TextStyle kWords{11, 1.4F};
inline constexpr pictures::TextStyle kSmall{10, 1.25F};

/// Formats like printf, up to 255 bytes.
template <typename... Values>
[[nodiscard]] std::string words_of(const char* format, Values... values) {
  std::array<char, 256> text{};
  std::snprintf(text.data(), text.size(), format, values...);
  return text.data();
}
/// Formats with thousands separators: 39,424.
[[nodiscard]] std::string counted(std::int64_t number);
/// Rounds to the nearest integer and formats it like counted().
[[nodiscard]] std::string rounded(double number);

/// Draws a title followed by a remark, in a line of `width`.
void title(Canvas& canvas, int x, int y, int width, const std::string& words, const std::string& remark);
/// Draws a square of colour on the base line of a text.
void swatch(Canvas& canvas, int x, int y, terrain::Colour colour);

}  // namespace talus::tools::sheet
