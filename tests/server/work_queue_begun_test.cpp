// The work queue with what was begun and gave way.
#include <array>
#include <catch2/catch.hpp>
#include <map>
#include <utility>
#include <vector>

#include "work_queue_helpers.h"

using namespace talus;
using namespace talus::server;

namespace {

const WorkCosts kCosts{.patch = 100, .longest_piece = 25, .max_begun = 2};

class Nothing final : public HeightsBuild {
 public:
  [[nodiscard]] bool step() override { return true; }
  [[nodiscard]] HeightsResult take() override { return {}; }
};

WorkQueue::Work take(WorkQueue& queue) {
  auto work = queue.take(kCosts);
  REQUIRE(work.has_value());
  return *std::move(work);
}

WorkQueue::Batch& batch_of(WorkQueue::Work& work) {
  return std::get<WorkQueue::Batch>(work.what);
}

/// As a thread that has begun the patch and gives way.
BegunPatch* pause(WorkQueue& queue, WorkQueue::Work& work) {
  auto& batch = batch_of(work);
  if (batch.begun == nullptr) batch.begun = std::make_unique<BegunPatch>();
  BegunPatch* const begun = batch.begun.get();
  queue.put_back(std::move(batch), work.turn);
  queue.reconcile(work, 25);
  return begun;
}

void finish(WorkQueue& queue, WorkQueue::Work& work) {
  auto& batch = batch_of(work);
  for (const ChunkKey key : batch.keys) {
    if (queue.begin(key)) (void)queue.finish(key);
  }
  queue.release(batch.patch);
  queue.reconcile(work, 25);
}

}  // namespace

TEST_CASE("a patch that was begun is gone on with, in turns with what others want") {
  WorkQueue queue{kPatch, 100};
  const auto dear = client_box();
  const auto other = client_box();
  REQUIRE(queue.add({dear}, std::array{at(0), at(1)}) == 2);
  auto work = take(queue);
  REQUIRE(queue.add({other}, std::array{at(100), at(200), at(300)}) == 3);
  std::vector<bool> was_dear;
  const BegunPatch* const begun = pause(queue, work);
  CHECK(queue.begun() == 1);
  for (int turn = 0; turn < 4; ++turn) {
    auto next = take(queue);
    const bool is_dear = next.turn.client == dear->owner();
    was_dear.push_back(is_dear);
    if (!is_dear) {
      finish(queue, next);
      continue;
    }
    CHECK(batch_of(next).begun.get() == begun);
    CHECK(batch_of(next).keys == std::vector{at(0), at(1)});
    CHECK(pause(queue, next) == begun);
  }
  CHECK((was_dear == std::vector{false, true, false, true} ||
         was_dear == std::vector{true, false, true, false}));
}

TEST_CASE("a client that joins a begun patch continues it") {
  WorkQueue queue{kPatch, 100};
  const auto first = client_box();
  const auto second = client_box();
  REQUIRE(add(queue, first, at(0)));
  auto work = take(queue);
  (void)pause(queue, work);
  REQUIRE(add(queue, second, at(1)));
  queue.cancel(first->owner(), at(0));
  auto next = take(queue);
  CHECK(next.turn.client == second->owner());
  CHECK(batch_of(next).begun != nullptr);
  CHECK(batch_of(next).keys == std::vector{at(1)});
  CHECK(queue.begun() == 0);
  finish(queue, next);
  CHECK(queue.clients() == 0);
}

TEST_CASE("a begun patch is dropped with the last job that waits for it") {
  WorkQueue queue{kPatch, 100};
  const auto client = client_box();
  REQUIRE(add(queue, client, at(0)));
  auto work = take(queue);
  (void)pause(queue, work);
  REQUIRE(queue.begun() == 1);
  queue.cancel(client->owner(), at(0));
  CHECK(queue.begun() == 0);
  CHECK(queue.take_dropped() != nullptr);
  CHECK(queue.take_dropped() == nullptr);
  CHECK(queue.jobs() == 0);
  CHECK(queue.clients() == 0);
  // Where the last left while it was taken.
  REQUIRE(add(queue, client, at(0)));
  work = take(queue);
  queue.cancel(client->owner(), at(0));
  (void)pause(queue, work);
  CHECK(queue.begun() == 0);
  CHECK(queue.jobs() == 0);
  CHECK(queue.clients() == 0);
}

TEST_CASE("a piece gives way if another client could begin something") {
  WorkQueue queue{kPatch, 100};
  const auto client = client_box(kFlow);
  const auto other = client_box(kOtherFlow);
  REQUIRE(add(queue, client, at(0)));
  auto work = take(queue);
  CHECK_FALSE(queue.should_give_way(work.turn, 150, kCosts));
  REQUIRE(add(queue, client, at(100)));  // its own
  CHECK_FALSE(queue.should_give_way(work.turn, 150, kCosts));
  REQUIRE(add(queue, other, at(1)));  // of the patch that is taken
  CHECK_FALSE(queue.should_give_way(work.turn, 150, kCosts));
  const Urgency urgency = GENERATE(Urgency::soon, Urgency::later);
  REQUIRE(queue.add({other}, std::array{at(200)}, urgency) == 1);
  CHECK(queue.should_give_way(work.turn, 150, kCosts));
}

TEST_CASE("a piece gives way to what is likely to take less time than its rest") {
  WorkQueue queue{kPatch, 100};
  const auto other = client_box();
  REQUIRE(add(queue, client_box(), at(0)));
  const auto work = take(queue);
  WorkCosts costs{.patch = 100, .height = 10, .max_begun = 2};
  SECTION("not to a patch that is as expensive, until this one has taken more than most") {
    REQUIRE(add(queue, other, at(100)));
    CHECK_FALSE(queue.should_give_way(work.turn, 25, costs));
    CHECK_FALSE(queue.should_give_way(work.turn, 100, costs));
    CHECK(queue.should_give_way(work.turn, 101, costs));
  }
  SECTION("to one in memory at once") {
    REQUIRE(add(queue, other, at(100)));
    costs.in_memory = [&](const PatchKey& patch) { return patch == patch_of(at(100), kPatch); };
    CHECK(queue.should_give_way(work.turn, 25, costs));
  }
  SECTION("to heights, if they are few") {
    queue.add(HeightsTask{other, 1, HeightsQuery{.columns = {{0, 0}, {1, 1}, {2, 2}}}});
    CHECK(queue.should_give_way(work.turn, 25, costs));
    CHECK_FALSE(queue.should_give_way(work.turn, 80, costs));
  }
}

TEST_CASE("if much was put back, nothing more gives way, and all clients may begin their work") {
  WorkQueue queue{kPatch, 100};
  const bool one_flow = GENERATE(true, false);
  std::vector<MailboxPtr> clients;
  for (std::uint64_t i = 0; i < 5; ++i) clients.push_back(client_box(one_flow ? kFlow : FlowId{100 + i}));
  for (std::size_t i = 0; i < 5; ++i) REQUIRE(add(queue, clients[i], at(static_cast<std::int32_t>(i) * 100)));
  const WorkCosts costs{.patch = 100,
                        .longest_piece = 25,
                        .max_begun = one_flow ? 5U : 2U,
                        .max_begun_of_flow = one_flow ? 2U : 1U};
  std::vector<WorkQueue::Work> taken;
  for (int i = 0; i < 3; ++i) taken.push_back(take(queue));
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(queue.should_give_way(taken[i].turn, 150, costs) == (i < 2));
    if (i < 2) (void)pause(queue, taken[i]);
  }
  finish(queue, taken[2]);
  // Those that were put back and the others, each in its turn.
  int pieces = 0;
  while (auto work = queue.take(costs)) {
    finish(queue, *work);
    ++pieces;
  }
  CHECK(pieces == 4);
  CHECK(queue.begun() == 0);
  CHECK(queue.clients() == 0);
}

TEST_CASE("two heights of one client in the making are both gone on with") {
  WorkQueue queue{kPatch, 100};
  const auto client = client_box();
  for (std::uint64_t ticket = 1; ticket <= 2; ++ticket) {
    queue.add(HeightsTask{client, ticket, HeightsQuery{.columns = {{0, 0}, {1000, 0}}}});
  }
  auto first = take(queue);
  auto second = take(queue);
  std::get<HeightsTask>(second.what).build() = std::make_unique<Nothing>();
  queue.put_back(std::move(std::get<HeightsTask>(second.what)));
  queue.reconcile(second, 25);
  std::get<HeightsTask>(first.what).add({{7}, {}, {}});
  queue.put_back(std::move(std::get<HeightsTask>(first.what)));
  queue.reconcile(first, 25);
  int pieces = 0;
  while (auto work = queue.take(kCosts)) {
    std::get<HeightsTask>(work->what).give_up();
    queue.reconcile(*work, 25);
    ++pieces;
  }
  CHECK(pieces == 2);
  CHECK(queue.begun() == 0);
  CHECK(queue.clients() == 0);
}

TEST_CASE("heights that were begun count until they are gone on with or cancelled") {
  WorkQueue queue{kPatch, 100};
  const auto client = client_box();
  queue.add(HeightsTask{client, 1, HeightsQuery{.columns = {{0, 0}}}});
  for (const bool cancelled : {false, true}) {
    auto work = take(queue);
    auto& task = std::get<HeightsTask>(work.what);
    CHECK(task.is_begun() == cancelled);
    CHECK(queue.begun() == 0);
    if (!task.is_begun()) task.build() = std::make_unique<Nothing>();
    queue.put_back(std::move(task));
    queue.reconcile(work, 25);
    CHECK(queue.begun() == 1);
    if (cancelled) queue.cancel_heights(client->owner(), 1);
  }
  CHECK(queue.begun() == 0);
  CHECK_FALSE(queue.take(kCosts).has_value());
  CHECK(queue.clients() == 0);
}

namespace {

/// A flow may have two expensive pieces open, and all together three.
const WorkCosts kFewOpen{.patch = 100,
                         .longest_piece = 25,
                         .max_begun = 3,
                         .max_begun_of_flow = 2,
                         .max_open = 3,
                         .max_open_of_flow = 2};

MailboxPtr add_tile(WorkQueue& queue, FlowId flow) {
  static std::int64_t last = 0;
  MailboxPtr client = client_box(flow);
  queue.add(HeightsTask{client, 1, HeightsQuery{.tile = map::Tile{12, ++last, 0}}});
  return client;
}

/// As a thread that draws a tile and gives way.
void pause_tile(WorkQueue& queue, WorkQueue::Work& work) {
  auto& task = std::get<HeightsTask>(work.what);
  if (!task.is_begun()) task.build() = std::make_unique<Nothing>();
  queue.put_back(std::move(task));
  queue.reconcile(work, 25);
}

void finish_tile(WorkQueue& queue, WorkQueue::Work& work) {
  std::get<HeightsTask>(work.what).give_up();
  queue.reconcile(work, 25);
}

bool is_begun(const WorkQueue::Work& work) {
  return std::get<HeightsTask>(work.what).is_begun();
}

}  // namespace

TEST_CASE("if no more of a flow may be put back, it begins no other tile and goes on with the begun ones") {
  WorkQueue queue{kPatch, 100};
  for (int client = 0; client < 40; ++client) (void)add_tile(queue, kFlow);
  std::vector<WorkQueue::Work> drawn;
  for (int thread = 0; thread < 2; ++thread) drawn.push_back(*queue.take(kFewOpen));
  CHECK_FALSE(queue.take(kFewOpen).has_value());  // both may be put back, a third might not
  const auto player = client_box();
  REQUIRE(add(queue, player, at(0)));
  for (auto& work : drawn) {
    CHECK(queue.should_give_way(work.turn, 200, kFewOpen));
    pause_tile(queue, work);
  }
  auto patch = *queue.take(kFewOpen);
  CHECK(patch.turn.client == player->owner());
  finish(queue, patch);
  int begun = 2;
  for (int piece = 0; begun < 40; ++piece) {
    const bool all_open = queue.begun() == 2;
    auto work = *queue.take(kFewOpen);
    if (all_open) CHECK(is_begun(work));
    if (!is_begun(work)) ++begun;
    piece % 4 == 3 ? finish_tile(queue, work) : pause_tile(queue, work);
    CHECK(queue.begun() <= 2);
  }
  while (auto work = queue.take(kFewOpen)) finish_tile(queue, *work);
  CHECK(queue.begun() == 0);
  CHECK(queue.clients() == 0);
}

TEST_CASE("flows whose tiles may not be begun yet come in turns, and none is forgotten") {
  WorkQueue queue{kPatch, 100};
  std::map<FlowId, int> drawn;
  for (int client = 0; client < 30; ++client) (void)add_tile(queue, kFlow);
  std::vector<WorkQueue::Work> open;
  open.push_back(*queue.take(kFewOpen));
  for (int client = 0; client < 10; ++client) (void)add_tile(queue, kOtherFlow);
  for (std::uint64_t flow = 0; flow < 10; ++flow) (void)add_tile(queue, FlowId{100 + flow});
  const auto gone = add_tile(queue, FlowId{200});
  while (auto work = queue.take(kFewOpen)) open.push_back(*std::move(work));
  CHECK(open.size() == 3);
  queue.cancel_heights(gone->owner(), 1);
  std::size_t alone = 0;
  for (int tile = 0; !open.empty(); ++tile) {
    ++drawn[open.front().turn.flow];
    finish_tile(queue, open.front());
    open.erase(open.begin());
    while (auto work = queue.take(kFewOpen)) open.push_back(*std::move(work));
    CHECK(open.size() <= 3);
    if (tile == 15) alone = drawn.size();
  }
  CHECK(alone >= 10);  // flows, of 12
  CHECK(drawn[kFlow] == 30);
  CHECK(drawn[kOtherFlow] == 10);
  CHECK(drawn.size() == 12);
  CHECK(queue.clients() == 0);
}

TEST_CASE("far chunks whose patches are expensive begin like tiles, near ones and those in memory at once") {
  WorkQueue queue{kPatch, 100};
  const auto client = client_box(kFlow);
  for (int patch = 0; patch < 5; ++patch) REQUIRE(add(queue, client, at(100 * patch)));
  WorkCosts costs = kFewOpen;
  costs.in_memory = [](const PatchKey& patch) { return patch == patch_of(at(400), kPatch); };
  std::vector<PatchKey> taken;
  while (auto work = queue.take(costs)) taken.push_back(batch_of(*work).patch);
  CHECK(taken == std::vector{patch_of(at(0), kPatch), patch_of(at(100), kPatch), patch_of(at(400), kPatch)});
  REQUIRE(queue.add({client}, std::array{at(-100)}, Urgency::soon) == 1);
  auto near = take(queue);
  CHECK(batch_of(near).keys == std::vector{at(-100)});
}

TEST_CASE("a begun patch continues although its clients' other far patches may not be begun") {
  WorkQueue queue{kPatch, 100};
  const WorkCosts costs{.patch = 100,
                        .longest_piece = 25,
                        .max_begun = 1,
                        .max_begun_of_flow = 1,
                        .max_open = 1,
                        .max_open_of_flow = 1};
  const auto first = client_box();
  const bool is_soon = GENERATE(true, false);
  const auto last = is_soon ? first : client_box();
  REQUIRE(queue.add({first}, std::array{at(0)}, is_soon ? Urgency::soon : Urgency::later) == 1);
  auto work = *queue.take(costs);
  REQUIRE(queue.add({last}, std::array{at(1), at(100)}) == 2);
  CHECK_FALSE(queue.take(costs).has_value());
  if (!is_soon) queue.cancel(first->owner(), at(0));
  const BegunPatch* const begun = pause(queue, work);
  auto next = queue.take(costs);
  REQUIRE(next.has_value());
  CHECK(next->turn.client == last->owner());
  CHECK(next->turn.urgency == (is_soon ? Urgency::soon : Urgency::later));
  CHECK(batch_of(*next).begun.get() == begun);
  CHECK(batch_of(*next).keys.size() == (is_soon ? 2 : 1));
  finish(queue, *next);
  next = queue.take(costs);
  REQUIRE(next.has_value());
  CHECK(batch_of(*next).keys == std::vector{at(100)});
}
