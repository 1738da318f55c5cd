#include "limits/flows/flow_ids.h"

#include <array>
#include <catch2/catch.hpp>
#include <set>
#include <string>

using namespace talus::server;

TEST_CASE("a flow keeps its id, and another gets another") {
  const FlowIds ids;
  const std::array<unsigned char, 4> address{192, 0, 2, 1};
  CHECK(ids.of_address(address) == ids.of_address(address));
  std::set<FlowId> all{ids.of_address(address)};
  for (int i = 0; i < 1000; ++i) all.insert(ids.of_subject(std::to_string(i)));
  CHECK(all.size() == 1001);
}

TEST_CASE("an address and a subject of the same bytes are two flows") {
  const FlowIds ids;
  const std::array<unsigned char, 4> address{'a', 'b', 'c', 'd'};
  CHECK(ids.of_address(address) != ids.of_subject("abcd"));
}

TEST_CASE("each process has its own ids, so that a client cannot choose one") {
  CHECK(FlowIds{}.of_subject("player") != FlowIds{}.of_subject("player"));
}
