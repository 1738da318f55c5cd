#include "rate_model.h"

#include <catch2/catch.hpp>

using std::chrono::milliseconds;
using talus::load::RateModel;

namespace {

// A server that sends what is wanted within the rate of a bucket with `full` tokens, for a minute.
RateModel observed(double wanted_per_second, double full) {
  constexpr double kStep = 0.5;
  RateModel model{1'000, milliseconds{10'000}};
  double bucket = full;
  double waiting = 0;
  for (int step = 0; step < 120; ++step) {
    bucket = std::min(10'000.0, bucket + 1'000 * kStep);
    waiting += wanted_per_second * kStep;
    const double sent = std::min(bucket, waiting);
    bucket -= sent;
    waiting -= sent;
    model.add(kStep, sent, true);
  }
  return model;
}

}  // namespace

TEST_CASE("a rate above the demand delays no player") {
  CHECK(observed(900, 10'000).held() == 0);
}

TEST_CASE("a rate holds from when its burst is used up") {
  const double held = observed(1'500, 10'000).held();  // 20 of 60 s are the burst's
  CHECK(held > 0.6);
  CHECK(held < 0.75);
}

TEST_CASE("a bucket that was empty before shows by its rate") {
  CHECK(observed(3'000, 0).held() == 1);
}

TEST_CASE("time that does not count fills and empties the bucket all the same") {
  RateModel model{1'000, milliseconds{10'000}};
  model.add(1, 11'000, false);
  CHECK(model.held() == 0);
  model.add(1, 1'000, true);
  model.add(9, 0, true);
  CHECK(model.held() == Approx(0.1));
}

TEST_CASE("no limit delays no player") {
  RateModel model{0, milliseconds{0}};
  model.add(1, 1e9, true);
  CHECK(model.held() == 0);
}
