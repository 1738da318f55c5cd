#include <talus/progress/progress_bar.h>

#include <catch2/catch.hpp>

using talus::progress_line;

TEST_CASE("a progress line says how far, how fast and how long still") {
  CHECK(progress_line(0.5, 240, 2.0, "chunks") ==
        "[############............]  50 %  120.0 chunks/s  2 s left");
  CHECK(progress_line(0.25, 100, 100.0, "chunks") ==
        "[######..................]  25 %  1.0 chunks/s  5 min 0 s left");
}

TEST_CASE("a high rate has a prefix") {
  CHECK(progress_line(1, 2'400, 1, "columns") ==
        "[########################] 100 %  2.4 k columns/s  0 s left");
  CHECK(progress_line(1, 3'000'000, 1, "columns") ==
        "[########################] 100 %  3.0 M columns/s  0 s left");
}

TEST_CASE("a progress line stays a line before the beginning and past the end") {
  CHECK(progress_line(0, 0, 0, "rows") == "[........................]   0 %");
  CHECK(progress_line(1.7, 10, 10.0, "rows") == "[########################] 100 %  1.0 rows/s  0 s left");
}
