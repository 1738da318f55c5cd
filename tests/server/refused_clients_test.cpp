#include "chunks/generation/refused_clients.h"

#include <catch2/catch.hpp>

using namespace talus::server;

namespace {

MailboxPtr box(std::uint64_t client, std::uint64_t flow) {
  auto mailbox = std::make_shared<Mailbox>(ClientId{client}, [] {});
  mailbox->join(std::make_shared<FlowUse>(FlowId{flow}, FlowName{}));
  return mailbox;
}

constexpr auto kRoom = [](FlowId) { return true; };

}  // namespace

TEST_CASE("the earliest refused clients of a flow are taken first, each once, however often it was refused") {
  RefusedClients refused;
  const auto one = box(1, 7);
  const auto two = box(2, 7);
  const auto three = box(3, 7);
  for (const auto& each : {one, two, one, three, two}) refused.remember(each);
  CHECK(refused.take(9, kRoom) == std::vector{one});
  CHECK(refused.take(9, kRoom) == std::vector{two});
  refused.remember(one);
  CHECK(refused.take_all() == std::vector{three, one});
  CHECK(refused.empty());
}

TEST_CASE("flows with room are notified in turns, one client of each") {
  RefusedClients refused;
  const auto one = box(1, 7);
  const auto two = box(2, 7);
  const auto other = box(3, 8);
  const auto without_room = box(4, 9);
  for (const auto& each : {one, two, without_room, other}) refused.remember(each);
  const auto has_room = [](FlowId flow) { return flow != FlowId{9}; };
  CHECK(refused.take(2, has_room) == std::vector{one});
  CHECK(refused.take(3, has_room) == std::vector{other, two});
  CHECK(refused.take(9, has_room).empty());
  CHECK(refused.take_all() == std::vector{without_room});
}

TEST_CASE("a client that is gone takes no other client's place") {
  RefusedClients refused;
  refused.remember(box(1, 7));
  const auto two = box(2, 7);
  refused.remember(two);
  CHECK(refused.take(1, kRoom) == std::vector{two});
}

TEST_CASE("clients that come, are refused and go do not pile up") {
  RefusedClients refused;
  const auto first = box(0, 0);
  refused.remember(first);
  for (std::uint64_t client = 1; client < 10'000; ++client) refused.remember(box(client, client % 1000));
  CHECK(refused.size() <= 128);
  CHECK(refused.take_all() == std::vector{first});
}
