// Letters as strokes of a round pen, for pictures that carry words: no font file is needed, and every machine
// draws the same.
#pragma once

#include <functional>
#include <string_view>

namespace talus::pictures {

struct TextStyle {
  float size = 10;   // height of capitals, in pixels
  float pen = 1.4F;  // width of the strokes, in pixels
};

/// How far a text reaches to the right, in pixels. UTF-8; what is no letter of the font is drawn as a box.
[[nodiscard]] float text_width(std::string_view text, const TextStyle& style);

/// Calls ink(x, y, part) for every pixel that the text covers some part of, 0 to 1; letters begin at pixel x
/// and stand on the bottom of pixel row y.
void draw_text(std::string_view text, int x, int y, const TextStyle& style,
               const std::function<void(int, int, float)>& ink);

}  // namespace talus::pictures
