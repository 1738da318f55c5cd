#include "generation/refused_clients.h"

#include <catch2/catch.hpp>

using namespace talus::server;

namespace {

MailboxPtr box(std::uint64_t client) {
  return std::make_shared<Mailbox>(ClientId{client}, [] {});
}

}  // namespace

TEST_CASE("those refused first are taken first, each once, however often it was refused") {
  RefusedClients refused;
  const auto one = box(1);
  const auto two = box(2);
  const auto three = box(3);
  for (const auto& each : {one, two, one, three, two}) refused.remember(each);
  CHECK(refused.take(2) == std::vector{one, two});
  refused.remember(one);
  CHECK(refused.take(9) == std::vector{three, one});
  CHECK(refused.empty());
}

TEST_CASE("a client that is gone takes nobody's place") {
  RefusedClients refused;
  refused.remember(box(1));
  const auto two = box(2);
  refused.remember(two);
  CHECK(refused.take(1) == std::vector{two});
}

TEST_CASE("clients that come, are refused and go do not pile up") {
  RefusedClients refused;
  const auto first = box(0);
  refused.remember(first);
  for (std::uint64_t client = 1; client < 10'000; ++client) refused.remember(box(client));
  CHECK(refused.size() <= 128);
  CHECK(refused.take(1) == std::vector{first});
}
