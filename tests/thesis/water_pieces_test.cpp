#include "water_pieces.h"

#include <algorithm>
#include <string>
#include <vector>

#include <rapidcheck.h>
#include <catch2/catch.hpp>

using namespace talus::tools;

namespace {

WaterPieces pieces_of(const std::vector<std::string>& rows) {
  std::vector<std::uint8_t> wet;
  for (const std::string& row : rows) {
    for (const char column : row) wet.push_back(column == '~' ? 1 : 0);
  }
  return water_pieces(wet, static_cast<int>(rows.front().size()), static_cast<int>(rows.size()));
}

}  // namespace

TEST_CASE("Pieces of water meet at corners, and go on beyond the edge") {
  const WaterPieces pieces = pieces_of({
      "~.........",  //
      ".~........",  // one piece with the corner
      "....~~....",  //
      "...~...~..",  // one inland piece of three, one of one
      "..........",
  });
  CHECK(pieces.water == 6);
  CHECK(pieces.inland == 4);
  CHECK(pieces.lone == 4);
}

TEST_CASE("Two pieces of eight columns that meet at a corner, on either side, are not lone pieces") {
  const std::vector<std::string> leftward{
      "............",  //
      "......~~~~..",  //
      "......~~~~..",  //
      "..~~~~......",  //
      "..~~~~......",  //
      "............",
  };
  CHECK(pieces_of(leftward).lone == 0);
  CHECK(pieces_of({leftward.rbegin(), leftward.rend()}).lone == 0);
  CHECK(pieces_of(leftward).inland == 16);
}

TEST_CASE("A lone piece has fewer than 16 columns") {
  std::vector<std::string> rows(6, "........");
  for (int z = 1; z < 4; ++z) rows[static_cast<std::size_t>(z)] = ".~~~~~..";
  CHECK(pieces_of(rows).lone == 15);
  rows[4] = ".~......";
  CHECK(pieces_of(rows).lone == 0);
  CHECK(pieces_of(rows).inland == 16);
}

TEST_CASE("All water is in some piece, whichever way the map lies") {
  CHECK(rc::check([] {
    const int width = *rc::gen::inRange(1, 30);
    const int depth = *rc::gen::inRange(1, 30);
    const auto wet = *rc::gen::container<std::vector<std::uint8_t>>(static_cast<std::size_t>(width * depth),
                                                                    rc::gen::inRange<std::uint8_t>(0, 2));
    const WaterPieces pieces = water_pieces(wet, width, depth);
    RC_ASSERT(pieces.water == std::count(wet.begin(), wet.end(), 1));
    RC_ASSERT(pieces.lone <= pieces.inland);
    std::vector<std::uint8_t> turned(wet.rbegin(), wet.rend());
    const WaterPieces back = water_pieces(turned, width, depth);
    RC_ASSERT(back.lone == pieces.lone);
    RC_ASSERT(back.inland == pieces.inland);
  }));
}
