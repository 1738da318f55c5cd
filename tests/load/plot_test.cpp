#include "plot.h"

#include <catch2/catch.hpp>

using namespace talus::load;
using std::chrono::milliseconds;

TEST_CASE("a plot names its curves and escapes its texts") {
  talus::measure::Histogram waits;
  for (int i = 1; i <= 1000; ++i) waits.record(milliseconds{i});
  const std::string svg = plot("a < b", "c & d", {{"travel", &waits}});
  CHECK(svg.find("a &lt; b") != std::string::npos);
  CHECK(svg.find("c &amp; d") != std::string::npos);
  CHECK(svg.find(">travel<") != std::string::npos);
  CHECK(svg.find("p99 990 ms, max 1 s") != std::string::npos);
}

TEST_CASE("a plot of one wait has only finite numbers") {
  talus::measure::Histogram waits;
  waits.record(milliseconds{0});
  const std::string svg = plot("", "", {{"one", &waits}});
  CHECK(svg.find("nan") == std::string::npos);
  CHECK(svg.find("inf") == std::string::npos);
}
