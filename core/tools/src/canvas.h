// A picture on which text, boxes and other pictures are drawn.
#pragma once

#include <string_view>

#include <talus/pictures/stroke_font.h>
#include <talus/tools/image.h>

namespace talus::tools {

struct Box {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;
};

enum class Align { left, middle, right };

/// Everything outside the picture is clipped.
class Canvas {
 public:
  Canvas(int width, int height, terrain::Colour ground);

  [[nodiscard]] const Image& image() const { return image_; }
  [[nodiscard]] int height() const { return image_.height; }

  /// `part` is the opacity.
  void fill(const Box& box, terrain::Colour colour, float part = 1);
  /// Draws the outline of a box, `width` pixels wide, inside the box.
  void frame(const Box& box, terrain::Colour colour, int width = 1);
  void picture(int x, int y, const Image& image);
  /// The base line of the letters is the lower edge of row y.
  void text(int x, int y, std::string_view words, const pictures::TextStyle& style, terrain::Colour colour,
            Align align = Align::left);
  /// Draws text with a dark rim, for legibility on a picture.
  void text_on_picture(int x, int y, std::string_view words, const pictures::TextStyle& style,
                       Align align = Align::left);
  /// Removes everything below row `height`.
  void cut(int height);

 private:
  void blend(int x, int y, terrain::Colour colour, float part);
  Image image_;
};

/// Returns `words`, shortened and ended by two dots if they do not fit.
[[nodiscard]] std::string fitted(std::string_view words, const pictures::TextStyle& style, int width);

}  // namespace talus::tools
