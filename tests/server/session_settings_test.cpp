#include "app/session_settings.h"

#include <catch2/catch.hpp>

using namespace talus::server;

TEST_CASE("every rate of the configuration has its burst") {
  Rates config;
  config.session_chunks = 1000;
  config.address_bytes = 0;
  config.burst_ms = 500;
  const RateLimits limits = rate_limits(config);
  CHECK(limits.session.chunks == Rate{1000, 500});
  CHECK_FALSE(limits.address.bytes.limited());
}

TEST_CASE("the default burst holds the mixed chunks of a View of the largest radius") {
  const Config config;
  const std::uint64_t columns =
      (2 * config.limits.view_horizontal_radius + 1) * (2 * config.limits.view_horizontal_radius + 1);
  CHECK(rate_limits(config.rates).session.chunks.burst >= 3 * columns);
}
