#include "requests.h"

#include <catch2/catch.hpp>

#include "peer.h"

using namespace talus;
using namespace talus::client;
using namespace talus::client::testing;

namespace {

Request request(int x) {
  return ChunkRequest{key_at(x, 0, 0), std::nullopt, [](const Result<ReceivedChunk>&) {}};
}

int place_of(const Request& request) {
  return std::get<ChunkRequest>(request).key.coord.x;
}

}  // namespace

TEST_CASE("requests are sent in their order, as many as may be in flight") {
  Requests requests;
  const auto first = requests.add(request(1));
  const auto second = requests.add(request(2));
  CHECK(first != 0);
  CHECK(second != first);
  CHECK(requests.in_flight(first) == nullptr);
  CHECK(requests.send_next(1) == first);
  CHECK(requests.in_flight(first) != nullptr);
  CHECK_FALSE(requests.send_next(1));
  CHECK(place_of(requests.take(first)) == 1);
  CHECK(requests.in_flight(first) == nullptr);
  CHECK(requests.send_next(1) == second);
  CHECK_FALSE(requests.send_next(9));
}

TEST_CASE("a request is cancelled where it stands") {
  Requests requests;
  const auto sent = requests.add(request(1));
  const auto waits = requests.add(request(2));
  REQUIRE(requests.send_next(1) == sent);
  CHECK(requests.cancel(sent) == Requests::CancelResult::in_flight);
  CHECK(requests.in_flight(sent) != nullptr);  // its answer may be on its way
  CHECK(requests.cancel(waits) == Requests::CancelResult::waiting);
  CHECK(place_of(requests.take(waits)) == 2);
  CHECK_FALSE(requests.send_next(9));
  CHECK(requests.cancel(waits) == Requests::CancelResult::unknown);
}

TEST_CASE(
    "after a broken connection what was in flight goes first, oldest first, but not what was cancelled") {
  Requests requests;
  const auto first = requests.add(request(1));
  const auto second = requests.add(request(2));
  const auto third = requests.add(request(3));
  const auto last = requests.add(request(4));
  for (const auto id : {first, second, third}) REQUIRE(requests.send_next(3) == id);
  REQUIRE(requests.cancel(second) == Requests::CancelResult::in_flight);
  const auto cancelled = requests.send_again();
  REQUIRE(cancelled.size() == 1);
  CHECK(place_of(cancelled[0]) == 2);
  for (const auto id : {first, third, last}) CHECK(requests.send_next(9) == id);
  CHECK_FALSE(requests.send_next(9));
}

TEST_CASE("a request that a server refused for now waits again in its order, unless it was cancelled") {
  Requests requests;
  const auto first = requests.add(request(1));
  const auto second = requests.add(request(2));
  const auto third = requests.add(request(3));
  const auto last = requests.add(request(4));
  for (const auto id : {first, second, third}) REQUIRE(requests.send_next(3) == id);
  REQUIRE(requests.cancel(third) == Requests::CancelResult::in_flight);
  CHECK(requests.put_back(second));
  CHECK(requests.put_back(first));
  CHECK_FALSE(requests.put_back(third));
  CHECK(place_of(requests.take(third)) == 3);
  for (const auto id : {first, second, last}) CHECK(requests.send_next(9) == id);
  CHECK_FALSE(requests.has_next(9));
}

TEST_CASE("all requests are taken out, oldest first") {
  Requests requests;
  for (const int x : {1, 2, 3}) (void)requests.add(request(x));
  REQUIRE(requests.send_next(1));
  const auto all = requests.take_all();
  REQUIRE(all.size() == 3);
  for (int i = 0; i < 3; ++i) CHECK(place_of(all[static_cast<std::size_t>(i)]) == i + 1);
  CHECK_FALSE(requests.send_next(9));
}
