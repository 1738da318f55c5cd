// Edits that are not answered yet: which are sent, in which order and with which sequence.
#include "open_writes.h"

#include <catch2/catch.hpp>

using namespace talus::load;

namespace {

std::vector<std::uint64_t> sent(OpenWrites& open) {
  std::vector<std::uint64_t> all;
  while (const auto next = open.send_next()) all.push_back(*next);
  return all;
}

}  // namespace

TEST_CASE("after a lost connection all go again, in order and as they were") {
  OpenWrites open;
  (void)open.attached(false, 0);
  for (int i = 0; i < 3; ++i) (void)open.add({});
  CHECK(sent(open) == std::vector<std::uint64_t>{1, 2, 3});
  CHECK(sent(open).empty());
  (void)open.take(2);
  open.put_all_back();
  CHECK_FALSE(open.in_flight(OpenWrites::id_of(1)));
  CHECK(open.attached(true, 3).empty());
  CHECK(sent(open) == std::vector<std::uint64_t>{1, 3});
  CHECK(open.in_flight(OpenWrites::id_of(3)) == 3);
}

TEST_CASE("one that is refused for now goes with its sequence, one that did not happen with a new one") {
  OpenWrites open;
  for (int i = 0; i < 2; ++i) (void)open.add({});
  (void)sent(open);
  open.put_back(1);
  CHECK(sent(open) == std::vector<std::uint64_t>{1});
  open.renew(1);
  CHECK(sent(open) == std::vector<std::uint64_t>{3});
}

TEST_CASE("if the server has forgotten their editor, writes end as unknown") {
  OpenWrites open;
  (void)open.add({.cell = 5});
  (void)sent(open);
  const auto lost = open.attached(false, 40);
  REQUIRE(lost.size() == 1);
  CHECK(lost.front().cell == 5);
  CHECK(open.empty());
  CHECK(open.add({}) == 41);
}
