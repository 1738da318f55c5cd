#include "measure/histogram.h"

#include <rapidcheck/catch.h>
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

using namespace talus::measure;
using std::chrono::microseconds;
using std::chrono::nanoseconds;

namespace {

Histogram of(const std::vector<std::uint32_t>& waits_us) {
  Histogram histogram;
  for (const std::uint32_t us : waits_us) histogram.record(microseconds{us});
  return histogram;
}

}  // namespace

TEST_CASE("a percentile is the sorted one, or a thousandth more") {
  rc::prop("for any waits", [] {
    auto waits = *rc::gen::nonEmpty(rc::gen::arbitrary<std::vector<std::uint32_t>>());
    const double part = *rc::gen::inRange(0, 1001) / 1000.0;
    const Histogram histogram = of(waits);
    std::sort(waits.begin(), waits.end());
    const auto rank = std::max<std::size_t>(
        1, static_cast<std::size_t>(std::ceil(part * static_cast<double>(waits.size()))));
    const double exact = waits[rank - 1] / 1e3;
    RC_ASSERT(histogram.percentile_ms(part) >= exact);
    RC_ASSERT(histogram.percentile_ms(part) <= exact * 1.001);
  });
}

TEST_CASE("merging two is recording all in one") {
  rc::prop("for any waits", [](const std::vector<std::uint32_t>& a, const std::vector<std::uint32_t>& b) {
    std::vector<std::uint32_t> all = a;
    all.insert(all.end(), b.begin(), b.end());
    Histogram merged = of(a);
    merged.merge(of(b));
    const Histogram whole = of(all);
    RC_ASSERT(merged.count() == whole.count());
    RC_ASSERT(merged.max_ms() == whole.max_ms());
    for (const double part : {0.0, 0.5, 0.9, 1.0}) {
      RC_ASSERT(merged.percentile_ms(part) == whole.percentile_ms(part));
    }
  });
}

TEST_CASE("a wait is never made shorter") {
  Histogram histogram;
  histogram.record(nanoseconds{1});
  CHECK(histogram.max_ms() == 0.001);
}

TEST_CASE("an empty histogram has zeros") {
  const Histogram none;
  CHECK(none.percentile_ms(0.99) == 0);
  CHECK(none.max_ms() == 0);
  CHECK(none.mean_ms() == 0);
}

TEST_CASE("a wait beyond all bounds takes no memory beyond them") {
  Histogram histogram;
  histogram.record(nanoseconds::max());
  histogram.record(nanoseconds{-5});
  CHECK(histogram.count() == 2);
  CHECK(histogram.percentile_ms(0.5) == 0);
  CHECK(histogram.max_ms() < 1e8);
}
