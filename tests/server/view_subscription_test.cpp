#include "player/view/view_subscription.h"

#include <catch2/catch.hpp>

using namespace talus;
using namespace talus::server;

namespace {

View around(std::int64_t x, int radius = 0) {
  return {{x, 0, 0}, {}, radius, 0, {}};
}

ChunkKey at(std::int32_t x) {
  return {{x, 0, 0}, Lod{}};
}

constexpr ContentHash kHash{1, 2};

/// Takes what is next, and ends it.
std::optional<ChunkKey> send_next(ViewSubscription& view) {
  const auto key = view.stream().nearest();
  if (!key) return std::nullopt;
  view.stream().start(*key);
  view.done(*key);
  return key;
}

}  // namespace

TEST_CASE("a View counts from apply() on") {
  ViewSubscription view;
  view.request(around(1));
  CHECK(view.waits());
  CHECK(view.stream().nearest() == std::nullopt);
  view.apply();
  CHECK_FALSE(view.waits());
  CHECK(view.stream().nearest() == at(1));
}

TEST_CASE("a View with a horizon is another than that without") {
  View plain = around(1, 1);
  plain.rings = {{Lod::of(1), 4}};
  View horizon = plain;
  horizon.horizon = HeightRange{0, 100};
  CHECK_FALSE(same_chunks(plain, horizon));
  ViewSubscription view;
  view.request(plain);
  const ChunkKey above{{0, 1, 0}, Lod::of(1)};
  view.request(horizon);
  view.apply();
  CHECK(view.stream().wants(above));
  view.request(plain);
  view.apply();
  CHECK_FALSE(view.stream().wants(above));
}

TEST_CASE("a chunk in flight that left is no longer in flight") {
  ViewSubscription view;
  view.request(around(1));
  view.apply();
  view.stream().start(at(1));
  view.request(around(2));
  view.apply();
  CHECK_FALSE(view.stream().in_flight(at(1)));
}

TEST_CASE("a chunk that left in a View that was never applied must be sent again") {
  const int away = GENERATE(1, 7, 8, 9, 100);
  ViewSubscription view;
  view.request(around(1));
  view.apply();
  (void)send_next(view);
  for (int each = 0; each < away; ++each) view.request(around(1000 + each));
  view.request(around(1));
  view.apply();
  CHECK(send_next(view) == at(1));
}

TEST_CASE("a chunk that stayed in every View is not sent again") {
  const int views = GENERATE(1, 7, 8);
  ViewSubscription view;
  view.request(around(0));
  view.apply();
  (void)send_next(view);
  for (int each = 1; each <= views; ++each) view.request(around(each % 2, 1));
  view.apply();
  while (const auto key = send_next(view)) CHECK(*key != at(0));
}

TEST_CASE("the client knows a chunk by its hash") {
  ViewSubscription view;
  view.request(around(1));
  view.add_known(at(1), kHash);
  view.apply();
  CHECK(view.knows(at(1), kHash));
  CHECK_FALSE(view.knows(at(1), {1, 3}));
  CHECK_FALSE(view.knows(at(2), kHash));
}

TEST_CASE("a chunk that the client has is forgotten when the chunk is done") {
  ViewSubscription view;
  view.request(around(1));
  view.add_known(at(1), kHash);
  view.apply();
  (void)send_next(view);
  CHECK(view.known_chunks() == 0);
}

TEST_CASE("a chunk that the client has outside its View is forgotten by apply()") {
  ViewSubscription view;
  for (std::int32_t x = 0; x < 100; ++x) view.add_known(at(x), kHash);
  view.request(around(5));
  view.apply();
  CHECK(view.known_chunks() == 1);
}

TEST_CASE("a chunk known by a View that was never applied stays known while later Views have it") {
  ViewSubscription view;
  view.request(around(1, 1));
  view.add_known(at(1), kHash);
  view.request(around(2, 1));
  view.apply();
  CHECK(view.knows(at(1), kHash));
}

TEST_CASE("a chunk that left in a View that was never applied is not known when it returns") {
  ViewSubscription view;
  view.request(around(1));
  view.add_known(at(1), kHash);
  const bool applied = GENERATE(false, true);
  if (applied) view.apply();
  view.request(around(1000));
  view.request(around(1));
  view.apply();
  CHECK_FALSE(view.knows(at(1), kHash));
}

TEST_CASE("chunks known by Views that were never applied take no room from the newest") {
  ViewSubscription view;
  view.request(around(0, 100));
  for (std::int32_t x = 0; x < 20'000; ++x) view.add_known({{x % 100, 0, x / 100}, Lod{}}, kHash);
  view.request(around(5000));
  view.add_known(at(5000), kHash);
  view.apply();
  CHECK(view.knows(at(5000), kHash));
}

TEST_CASE("the number of chunks known to the client is bounded") {
  ViewSubscription view;
  for (std::int32_t x = 0; x < 20'000; ++x) view.add_known(at(x), kHash);
  CHECK(view.known_chunks() == ViewSubscription::kMaxKnownChunks);
}

TEST_CASE("a cleared subscription wants and knows nothing") {
  ViewSubscription view;
  view.request(around(1, 2));
  view.add_known(at(1), kHash);
  view.apply();
  const ChunkKey in_flight = *view.stream().nearest();
  view.stream().start(in_flight);
  view.request(around(2));
  view.clear();
  CHECK_FALSE(view.stream().in_flight(in_flight));
  CHECK_FALSE(view.waits());
  CHECK(view.known_chunks() == 0);
  CHECK(view.stream().nearest() == std::nullopt);
}
