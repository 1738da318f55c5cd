#include <talus/pictures/stroke_font.h>

#include <map>
#include <string>
#include <utility>

#include <rapidcheck.h>
#include <catch2/catch.hpp>

using namespace talus::pictures;

namespace {

struct Ink {
  std::map<std::pair<int, int>, float> pixels;
  float most = 0;
};

Ink ink_of(std::string_view text, const TextStyle& style, int x = 100, int y = 100) {
  Ink ink;
  draw_text(text, x, y, style, [&](int px, int py, float part) {
    ink.pixels[{px, py}] = std::max(ink.pixels[{px, py}], part);
    ink.most = std::max(ink.most, part);
  });
  return ink;
}

}  // namespace

TEST_CASE("Every printable character is drawn within its line") {
  const TextStyle style{14, 2};
  for (char letter = '!'; letter <= '~'; ++letter) {
    INFO(letter);
    const std::string text{letter};
    const Ink ink = ink_of(text, style);
    CHECK(ink.most > 0.9F);
    for (const auto& [pixel, part] : ink.pixels) {
      CHECK(pixel.first >= 98);
      CHECK(static_cast<float>(pixel.first) <= 102 + text_width(text, style));
      CHECK(pixel.second >= 100 - 18);
      CHECK(pixel.second <= 100 + 7);
      CHECK(part > 0);
      CHECK(part <= 1);
    }
  }
  CHECK(ink_of(" ", style).pixels.empty());
}

TEST_CASE("Letters differ, and stand on the line") {
  const TextStyle style{14, 2};
  const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789.,:;%()+-/";
  std::map<std::map<std::pair<int, int>, float>, char> seen;
  for (const char letter : letters) {
    INFO(letter);
    CHECK(seen.emplace(ink_of(std::string{letter}, style).pixels, letter).second);
  }
  const Ink stem = ink_of("I", style);
  CHECK(stem.pixels.at({100, 99}) > 0.9F);
  CHECK(stem.pixels.at({100, 100}) > 0.5F);  // the round end of the stroke
  CHECK_FALSE(stem.pixels.contains({100, 101}));
}

TEST_CASE("A text moves as a whole, and is as wide as its parts with the gap between") {
  const TextStyle style{11, 1.4F};
  const Ink here = ink_of("Talus", style, 10, 20);
  const Ink there = ink_of("Talus", style, 17, 15);
  REQUIRE(here.pixels.size() == there.pixels.size());
  for (const auto& [pixel, part] : here.pixels) {
    CHECK(there.pixels.at({pixel.first + 7, pixel.second - 5}) == part);
  }
  CHECK(text_width("", style) == style.pen);
  CHECK(text_width("aa", style) > 2 * text_width("a", style) - style.pen);
}

TEST_CASE("Any bytes are text: unknown letters are boxes") {
  const TextStyle style{10, 1.2F};
  CHECK(text_width("\u00E9", style) == text_width("\u6F22", style));
  CHECK(ink_of("\u00E9", style).pixels == ink_of("\u6F22", style).pixels);
  CHECK(rc::check([&] {
    const auto bytes = *rc::gen::container<std::string>(rc::gen::arbitrary<char>());
    const Ink ink = ink_of(bytes, style);
    RC_ASSERT(text_width(bytes, style) >= 0);
    for (const auto& [pixel, part] : ink.pixels) {
      RC_ASSERT(static_cast<float>(pixel.first) <= 103 + text_width(bytes, style));
      RC_ASSERT(part <= 1);
    }
  }));
}
