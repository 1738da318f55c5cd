#include "canvas.h"

#include <string>

#include <catch2/catch.hpp>

#include "colour_scale.h"
#include "sheet_style.h"

using namespace talus;
using namespace talus::tools;

namespace {

constexpr terrain::Colour kBlack{0, 0, 0};
constexpr terrain::Colour kRed{200, 0, 0};

}  // namespace

TEST_CASE("Drawings beyond a canvas' edges are cut off") {
  Canvas canvas{20, 10, kBlack};
  canvas.fill({-5, -5, 8, 8}, kRed);
  canvas.fill({18, 8, 100, 100}, kRed, 0.5F);
  CHECK(canvas.image().at(2, 2) == kRed);
  CHECK(canvas.image().at(3, 2) == kBlack);
  CHECK(canvas.image().at(19, 9) == terrain::Colour{100, 0, 0});
  canvas.frame({-3, 4, 40, 3}, kRed);
  CHECK(canvas.image().at(10, 4) == kRed);
  CHECK(canvas.image().at(10, 5) == kBlack);
  canvas.text(-30, 2, "words that leave on both sides", {10, 2}, kRed);
  canvas.picture(15, 7, canvas.image());
  canvas.cut(4);
  CHECK(canvas.height() == 4);
  CHECK(canvas.image().rgb.size() == 20 * 4 * 3);
}

TEST_CASE("Text is shortened to the width it has") {
  const pictures::TextStyle style{10, 1.4F};
  CHECK(fitted("short", style, 1000) == "short");
  const std::string cut = fitted("a name that is too long \u00E9\u00E9\u00E9\u00E9", style, 90);
  CHECK(text_width(cut, style) <= 90);
  CHECK_THAT(cut, Catch::StartsWith("a name") && Catch::EndsWith(".."));
  CHECK(fitted("\u00E9\u00E9\u00E9", style, 0).size() <= 4);
  CHECK(fitted("", style, 0).empty());
}

TEST_CASE("Numbers are written with their thousands apart") {
  CHECK(sheet::counted(0) == "0");
  CHECK(sheet::counted(999) == "999");
  CHECK(sheet::counted(1000) == "1,000");
  CHECK(sheet::counted(-1234567) == "\u22121,234,567");
  CHECK(sheet::rounded(-0.4) == "0");
  CHECK(sheet::rounded(1999.6) == "2,000");
}

TEST_CASE("A scale gives its ends and stays within them") {
  const ColourScale scale = scale_of("temperature");
  CHECK(scale.at(0) == scale.colours.front());
  CHECK(scale.at(1) == scale.colours.back());
  CHECK(scale.at(-3) == scale.colours.front());
  CHECK(scale.at(7) == scale.colours.back());
  // Under water blue, above it not; without a sea nothing is blue.
  const terrain::Colour deep = colour_of_height(-50, -60, 300, true);
  CHECK(deep.blue > deep.red + 30);
  const terrain::Colour hill = colour_of_height(60, -60, 300, true);
  CHECK(hill.blue < hill.red);
  const terrain::Colour dry = colour_of_height(-50, -60, 300, false);
  CHECK(dry.blue < dry.green);
}
