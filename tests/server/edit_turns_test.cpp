// Whose edit goes next.
#include "edits/edit_turns.h"

#include <map>

#include <catch2/catch.hpp>

using namespace talus::server;

namespace {

struct Crowd {
  EditTurns turns;
  std::map<ClientId, FlowId> flow_of;
  std::map<ClientId, std::size_t> voxels_of;  // of each of its edits
  std::map<ClientId, int> went;

  void join(std::uint64_t session, std::uint64_t flow, std::size_t voxels = 1) {
    flow_of[ClientId{session}] = FlowId{flow};
    voxels_of[ClientId{session}] = voxels;
    enter(ClientId{session});
  }
  void enter(ClientId session) { turns.enter(flow_of.at(session), session, voxels_of.at(session)); }
  /// One edit; who went has more, but for `seldom`.
  ClientId step(ClientId seldom = {}) {
    const auto next = turns.next();
    REQUIRE(next.has_value());
    if (*next != seldom) enter(*next);
    ++went[*next];
    return *next;
  }
};

}  // namespace

TEST_CASE("who digs alone waits for few edits of others, of another flow or the same") {
  const bool same_flow = GENERATE(true, false);
  const std::size_t voxels = GENERATE(1, 65'536);
  Crowd crowd;
  for (std::uint64_t session = 1; session <= 100; ++session) crowd.join(session, 1, voxels);
  for (int i = 0; i < 1'000; ++i) crowd.step();
  constexpr ClientId kAlone{777};
  crowd.flow_of[kAlone] = FlowId{same_flow ? 1U : 2U};
  crowd.voxels_of[kAlone] = 1;
  for (int round = 0; round < 20; ++round) {
    crowd.enter(kAlone);
    int waits = 0;
    while (crowd.step(kAlone) != kAlone) ++waits;
    // One of each who has sent edits of the same size, in the same flow.
    CHECK(waits <= (same_flow && voxels == 1 ? 101 : 2));
    for (int others = 0; others < 50; ++others) crowd.step();
  }
}

TEST_CASE("flows have equal shares by cost, however many sessions they have, and so have a flow's sessions") {
  Crowd crowd;
  crowd.join(1, 1);
  for (std::uint64_t session = 2; session <= 11; ++session) crowd.join(session, 2);
  crowd.join(12, 3, 65 * 9 - 64);  // as dear as nine
  for (int i = 0; i < 19'000; ++i) crowd.step();
  CHECK(crowd.went[ClientId{1}] == Approx(9'000).margin(20));
  for (std::uint64_t session = 2; session <= 11; ++session) {
    CHECK(crowd.went[ClientId{session}] == Approx(900).margin(20));
  }
  CHECK(crowd.went[ClientId{12}] == Approx(1'000).margin(20));
}

TEST_CASE("nobody's turn comes where nobody has entered") {
  EditTurns turns;
  CHECK_FALSE(turns.next().has_value());
  turns.enter(FlowId{1}, ClientId{1}, 5);
  CHECK(turns.entered() == 1);
  CHECK(turns.next() == ClientId{1});
  CHECK(turns.entered() == 0);
  CHECK_FALSE(turns.next().has_value());
}
