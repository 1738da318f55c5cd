#include "progress.h"

#include <catch2/catch.hpp>

namespace talus::cli {

TEST_CASE("a progress line says how far, how fast and how long still") {
  CHECK(progress_line(0.5, 240, 2.0) == "[############............]  50 %  120 chunks/s  2 s left");
  CHECK(progress_line(0.25, 100, 100.0) == "[######..................]  25 %  1 chunks/s  5 min 0 s left");
}

TEST_CASE("a progress line stays a line before the beginning and past the end") {
  CHECK(progress_line(0, 0, 0) == "[........................]   0 %");
  CHECK(progress_line(1.7, 10, 10.0) == "[########################] 100 %  1 chunks/s  0 s left");
}

}  // namespace talus::cli
