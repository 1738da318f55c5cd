#include "likeness.h"

#include <cmath>

#include <catch2/catch.hpp>

#include "worlds.h"

using namespace talus;
using namespace talus::tools;

namespace {

terrain::Field row(const terrain::Field::Values& values) {
  terrain::Field field{static_cast<int>(values.size()), 1};
  field.values = values;
  return field;
}

}  // namespace

TEST_CASE("Cover, overlap and correlation are right for two small rows") {
  const Alike rows = alike(row({4, 2, 0, 0}), row({2, 0, 1, 0}));
  CHECK(rows.cover_a == 0.5);
  CHECK(rows.cover_b == 0.5);
  CHECK(rows.overlap == Approx(1.0 / 3));
  CHECK(rows.unrelated == Approx(0.25 / 0.75));
  // Deviations 2.5, 0.5, -1.5, -1.5 and 1.25, -0.75, 0.25, -0.75.
  CHECK(rows.correlation == Approx(3.5 / std::sqrt(11.0 * 2.75)));
}

TEST_CASE("A layer is wholly like itself, and unlike its complement") {
  const auto some = row({3, 0, 7, 0});
  CHECK(alike(some, some).overlap == 1);
  CHECK(alike(some, some).correlation == Approx(1));
  CHECK(alike(some, row({0, 5, 0, 5})).overlap == 0);
  CHECK(alike(some, row({0, 5, 0, 5})).correlation < 0);
}

TEST_CASE("Even layers have no correlation, and empty ones nothing in which to differ") {
  CHECK(alike(row({2, 2, 2}), row({1, 2, 3})).correlation == 0);
  CHECK(alike(row({0, 0}), row({0, 0})).overlap == 1);
}

TEST_CASE("Both methods lay their loose material in the same places more than by chance") {
  const WorldText text{test::sample_world_text("classic"), "here.toml"};
  ProgressBar progress{"likeness", "seeds"};
  const auto likeness = measure_likeness(text, 2, progress);
  REQUIRE(likeness);
  REQUIRE(likeness->rows.size() == 1 + test::sample_world("classic").loose().size());
  const LikenessRow& all = likeness->rows.front();
  CHECK(all.name == "all");
  CHECK(all.overlap.mean > all.unrelated.mean);
}
