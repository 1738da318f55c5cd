#include "limits/memory/trim_policy.h"

#include <catch2/catch.hpp>

using talus::server::TrimPolicy;

namespace {

constexpr std::uint64_t kMany = 10 * TrimPolicy::kWorthBytes;

}  // namespace

TEST_CASE("memory that grows, or falls a little, is not trimmed") {
  TrimPolicy policy;
  for (std::uint64_t used = 0; used < kMany; used += TrimPolicy::kQuietBytes) CHECK_FALSE(policy.due(used));
  for (int second = 0; second < 10; ++second) {
    CHECK_FALSE(policy.due(kMany - TrimPolicy::kWorthBytes + 1));
  }
}

TEST_CASE("memory that fell much is trimmed once, when it has come to rest") {
  TrimPolicy policy;
  CHECK_FALSE(policy.due(kMany));
  CHECK_FALSE(policy.due(kMany / 2));
  CHECK_FALSE(policy.due(kMany / 4));
  CHECK(policy.due(kMany / 4 + TrimPolicy::kQuietBytes - 1));
  for (int second = 0; second < 10; ++second) CHECK_FALSE(policy.due(kMany / 4));
}

TEST_CASE("memory that grew and fell again is trimmed again") {
  TrimPolicy policy;
  for (int load = 0; load < 3; ++load) {
    CHECK_FALSE(policy.due(kMany));
    CHECK_FALSE(policy.due(0));
    CHECK(policy.due(0));
  }
}
