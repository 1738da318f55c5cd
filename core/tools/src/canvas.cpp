#include "canvas.h"

#include <algorithm>
#include <cmath>

namespace talus::tools {
namespace {

int left_of(int x, std::string_view words, const pictures::TextStyle& style, Align align) {
  if (align == Align::left) return x;
  const int width = static_cast<int>(std::lround(text_width(words, style)));
  return align == Align::right ? x - width : x - width / 2;
}

}  // namespace

Canvas::Canvas(int width, int height, terrain::Colour ground) : image_{width, height} {
  fill({0, 0, width, height}, ground);
}

void Canvas::blend(int x, int y, terrain::Colour colour, float part) {
  if (x < 0 || y < 0 || x >= image_.width || y >= image_.height) return;
  // Letters keep their weight if channel values are mixed directly instead of as light.
  const terrain::Colour under = image_.at(x, y);
  const auto mixed = [&](std::uint8_t from, std::uint8_t to) {
    return static_cast<std::uint8_t>(
        std::lround(static_cast<float>(from) + part * static_cast<float>(to - from)));
  };
  image_.set(
      x, y, {mixed(under.red, colour.red), mixed(under.green, colour.green), mixed(under.blue, colour.blue)});
}

void Canvas::fill(const Box& box, terrain::Colour colour, float part) {
  for (int y = box.y; y < box.y + box.height; ++y) {
    for (int x = box.x; x < box.x + box.width; ++x) blend(x, y, colour, part);
  }
}

void Canvas::frame(const Box& box, terrain::Colour colour, int width) {
  fill({box.x, box.y, box.width, width}, colour);
  fill({box.x, box.y + box.height - width, box.width, width}, colour);
  fill({box.x, box.y + width, width, box.height - 2 * width}, colour);
  fill({box.x + box.width - width, box.y + width, width, box.height - 2 * width}, colour);
}

void Canvas::picture(int x, int y, const Image& image) {
  for (int row = 0; row < image.height; ++row) {
    for (int column = 0; column < image.width; ++column) {
      blend(x + column, y + row, image.at(column, row), 1);
    }
  }
}

void Canvas::text(int x, int y, std::string_view words, const pictures::TextStyle& style,
                  terrain::Colour colour, Align align) {
  pictures::draw_text(words, left_of(x, words, style, align), y, style,
                      [&](int px, int py, float part) { blend(px, py, colour, part); });
}

void Canvas::text_on_picture(int x, int y, std::string_view words, const pictures::TextStyle& style,
                             Align align) {
  const int left = left_of(x, words, style, align);
  pictures::TextStyle rim = style;
  rim.pen += 4;
  const auto moved = static_cast<int>(std::lround(2.0F));
  pictures::draw_text(words, left - moved, y + moved, rim, [&](int px, int py, float part) {
    blend(px, py, {20, 24, 30}, 0.5F * part);
  });
  pictures::draw_text(words, left, y, style, [&](int px, int py, float part) {
    blend(px, py, {255, 255, 255}, part);
  });
}

void Canvas::cut(int height) {
  image_.height = std::min(image_.height, height);
  image_.rgb.resize(static_cast<std::size_t>(image_.width) * static_cast<std::size_t>(image_.height) * 3);
}

std::string fitted(std::string_view words, const pictures::TextStyle& style, int width) {
  std::string text{words};
  while (!words.empty() && text_width(text, style) > static_cast<float>(width)) {
    // Multi-byte characters are removed whole.
    std::size_t end = words.size() - 1;
    while (end > 0 && (static_cast<unsigned char>(words[end]) & 0xC0U) == 0x80) --end;
    words = words.substr(0, end);
    text = std::string{words} + "..";
  }
  return text;
}

}  // namespace talus::tools
