#include "cluster/jetstream/refused_subscription.h"

#include <catch2/catch.hpp>

#include "cluster/jetstream/told_reason.h"

using namespace talus::server::jetstream;
using namespace std::chrono_literals;
using Due = RefusedSubscription::Due;

namespace {

constexpr RefusedSubscription::TimePoint kStart{1h};
constexpr auto kTry = RefusedSubscription::kBetweenTries;

}  // namespace

TEST_CASE("a subscription that was refused is tried again until a try is not refused") {
  RefusedSubscription subscription;
  CHECK(subscription.due(kStart) == Due::nothing);
  CHECK(subscription.refused("why", kStart));
  CHECK(subscription.due(kStart + kTry - 1ms) == Due::nothing);
  CHECK(subscription.due(kStart + kTry) == Due::try_again);
  CHECK_FALSE(subscription.refused("why again", kStart + kTry + 1ms));
  CHECK(subscription.why() == "why");
  CHECK(subscription.due(kStart + 2 * kTry) == Due::try_again);
  CHECK(subscription.due(kStart + 2 * kTry + 1ms) == Due::nothing);
  CHECK(subscription.due(kStart + 3 * kTry) == Due::restored);
  CHECK(subscription.why().empty());
  CHECK(subscription.due(kStart + 4 * kTry) == Due::nothing);
  CHECK(subscription.refused("once more", kStart + 4 * kTry));
}

TEST_CASE("a try before the connection broke says nothing") {
  RefusedSubscription subscription;
  CHECK(subscription.refused("why", kStart));
  CHECK(subscription.due(kStart + kTry) == Due::try_again);
  subscription.disconnected();
  CHECK(subscription.due(kStart + 2 * kTry) == Due::try_again);
  CHECK(subscription.due(kStart + 3 * kTry) == Due::restored);
}

TEST_CASE("a reason is told once in a while, however often it comes") {
  ToldReason told;
  CHECK_FALSE(told.is_told("why", kStart));
  CHECK(told.is_told("why", kStart + 1s));
  CHECK(told.is_told("why", kStart + ToldReason::kBetween));
  CHECK_FALSE(told.is_told("why", kStart + ToldReason::kBetween + 1s));
  CHECK_FALSE(told.is_told("another", kStart + ToldReason::kBetween + 2s));
  CHECK_FALSE(told.is_told("why", kStart + ToldReason::kBetween + 3s));
}
