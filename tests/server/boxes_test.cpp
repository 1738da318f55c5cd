// Lists of boxes, as settings and tokens have them.
#include "config/boxes.h"

#include <string>

#include <catch2/catch.hpp>

namespace talus::server {
namespace {

std::string error_of(std::string_view text) {
  const auto boxes = Boxes::parse(text);
  REQUIRE_FALSE(boxes.has_value());
  CHECK(boxes.error().find('\n') == std::string::npos);
  return boxes.error();
}

}  // namespace

TEST_CASE("boxes are read with corners in any order, and written as they are read") {
  const auto boxes = Boxes::parse(" 16,-16 : -16,16; 71,90,31:40,60,0 ");
  REQUIRE(boxes.has_value());
  REQUIRE(boxes->size() == 2);
  CHECK(boxes->text() == "-16,-16:16,16; 40,60,0:71,90,31");
  CHECK(Boxes::parse(boxes->text()) == boxes);
  const Box& columns = *boxes->begin();
  CHECK(columns.holds({{-16, -40'000, -16}, {16, 40'000, 16}}));
  CHECK_FALSE(columns.holds({{-16, 0, -16}, {17, 0, 16}}));
  CHECK(columns.meets({{16, 7, 16}, {90, 7, 90}}));
  CHECK_FALSE(columns.meets({{17, 7, 0}, {90, 7, 90}}));
  const Box room{{40, 60, 0}, {71, 90, 31}};
  CHECK(room.holds(room));
  CHECK_FALSE(room.meets({{40, 91, 0}, {71, 95, 31}}));
  CHECK(Boxes::parse(" ")->empty());
}

TEST_CASE("an invalid box is named in one line") {
  for (const char* text : {"1,2", "1,2:3", "1,2:3,4,5", "1,2,3,4:1,2,3,4", "a,2:3,4", "1,2:3,4;", ";1,2:3,4",
                           "1,,2:3,4", "1.5,2:3,4", "68719476736,0:0,0", "99999999999999999999,0:0,0"}) {
    CAPTURE(text);
    CHECK_THAT(error_of(text), Catch::Contains("is not a box of the world; write boxes as X,Z:X,Z"));
  }
  CHECK_THAT(error_of("1,2:3,4; 5,6:7"), Catch::StartsWith("\"5,6:7\""));
  std::string many = "0,0:1,1";
  for (std::size_t i = 1; i < Boxes::kMax; ++i) many += ";0,0:1,1";
  CHECK(Boxes::parse(many)->size() == Boxes::kMax);
  CHECK_THAT(error_of(many + ";0,0:1,1"), Catch::Contains("more than 64 boxes"));
}

}  // namespace talus::server
