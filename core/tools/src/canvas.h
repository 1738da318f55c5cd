// A picture that words, boxes and other pictures are put on.
#pragma once

#include <string_view>

#include <talus/pictures/stroke_font.h>

#include "image.h"

namespace talus::tools {

struct Box {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;
};

enum class Align { left, middle, right };

/// Everything outside of the picture is cut off.
class Canvas {
 public:
  Canvas(int width, int height, terrain::Colour ground);

  [[nodiscard]] const Image& image() const { return image_; }
  [[nodiscard]] int height() const { return image_.height; }

  /// `part` of 1 covers what was there.
  void fill(const Box& box, terrain::Colour colour, float part = 1);
  /// The outline of a box, so many pixels wide, inside it.
  void frame(const Box& box, terrain::Colour colour, int width = 1);
  void picture(int x, int y, const Image& image);
  /// The letters' base line is the lower edge of row y.
  void text(int x, int y, std::string_view words, const pictures::TextStyle& style, terrain::Colour colour,
            Align align = Align::left);
  /// The same with a dark rim, to be read on a picture.
  void text_on_picture(int x, int y, std::string_view words, const pictures::TextStyle& style,
                       Align align = Align::left);
  /// Without what lies below row `height`.
  void cut(int height);

 private:
  void blend(int x, int y, terrain::Colour colour, float part);
  Image image_;
};

/// So much of a text as fits, ended by two dots where that is not all.
[[nodiscard]] std::string fitted(std::string_view words, const pictures::TextStyle& style, int width);

}  // namespace talus::tools
