// Letters as strokes of a round pen, for text in pictures: needs no font file, and draws the same on every
// machine.
#pragma once

#include <functional>
#include <string_view>

namespace talus::pictures {

struct TextStyle {
  float size = 10;   // height of capitals, in pixels
  float pen = 1.4F;  // width of the strokes, in pixels
};

/// Width of a text in pixels. UTF-8; characters that the font lacks are drawn as boxes.
[[nodiscard]] float text_width(std::string_view text, const TextStyle& style);

/// Calls ink(x, y, part) for every pixel that the text covers, with the covered part, 0 to 1. Letters begin
/// at pixel x and stand on the lower edge of pixel row y.
void draw_text(std::string_view text, int x, int y, const TextStyle& style,
               const std::function<void(int, int, float)>& ink);

}  // namespace talus::pictures
