// The work queue where some is wanted soon.
#include <array>
#include <catch2/catch.hpp>
#include <map>
#include <vector>

#include "failing_allocations.h"
#include "work_queue_helpers.h"

using namespace talus;
using namespace talus::server;

namespace {

/// Whose turns come, each piece ended at once.
std::vector<std::pair<ClientId, Urgency>> turns_of(WorkQueue& queue) {
  std::vector<std::pair<ClientId, Urgency>> turns;
  while (auto work = queue.take({.patch = 100})) {
    turns.emplace_back(work->turn.client, work->turn.urgency);
    if (const auto* batch = std::get_if<WorkQueue::Batch>(&work->what)) queue.release(batch->patch);
    queue.reconcile(*work, 100);
  }
  return turns;
}

}  // namespace

TEST_CASE("work wanted soon goes before work that others wanted earlier") {
  WorkQueue queue{kPatch, 1000};
  const auto far = client_box();
  const auto near = client_box();
  for (int i = 0; i < 8; ++i) REQUIRE(add(queue, far, at(100 * i)));
  REQUIRE(queue.add({near}, std::array{at(-100), at(-200), at(-300)}, Urgency::soon) == 3);
  const auto turns = turns_of(queue);
  REQUIRE(turns.size() == 11);
  for (const std::size_t i : {0U, 1U, 2U}) CHECK(turns[i].first == near->owner());
}

TEST_CASE(
    "a flow that always wants some soon goes first for a while, and has no more in all than the others") {
  WorkQueue queue{kPatch, 100'000};
  // All of one flow, or each of its own.
  const bool one_flow = GENERATE(false, true);
  const auto box = [&] { return one_flow ? client_box(kFlow) : client_box(); };
  std::map<ClientId, int> pieces;
  std::int32_t asked = 0;
  const auto ask = [&](const MailboxPtr& client, Urgency urgency) {
    REQUIRE(queue.add({client}, std::array{at(kPatch * ++asked)}, urgency) == 1);
  };
  std::vector<MailboxPtr> far;
  for (int i = 0; i < 10; ++i) {
    far.push_back(box());
    for (int patch = 0; patch < 200; ++patch) ask(far.back(), Urgency::later);
  }
  const auto piece = [&] {
    const auto work = queue.take({.patch = 100});
    const auto& batch = std::get<WorkQueue::Batch>(work->what);
    queue.release(batch.patch);
    queue.reconcile(*work, 100);
    ++pieces[work->turn.client];
    return work->turn.client;
  };
  for (int i = 0; i < 100; ++i) (void)piece();
  const auto jumper = box();
  int first = 0;
  for (bool goes_first = true; goes_first;) {
    ask(jumper, Urgency::soon);
    goes_first = piece() == jumper->owner();
    first += goes_first ? 1 : 0;
  }
  CHECK(first == Approx(WorkQueue::kPatchesAhead).margin(2));
  for (int i = 0; i < 1000; ++i) {
    ask(jumper, Urgency::soon);
    (void)piece();
  }
  for (const auto& client : far) CHECK(pieces[client->owner()] == Approx(pieces[jumper->owner()]).margin(20));
  // A player who joins has the nearest chunks before all that.
  const auto joins = box();
  for (int patch = 0; patch < 4; ++patch) ask(joins, Urgency::soon);
  for (int patch = 0; patch < 4; ++patch) CHECK(piece() == joins->owner());
}

TEST_CASE("within one client, too, work wanted soon goes first") {
  WorkQueue queue{kPatch, 1000};
  const auto client = client_box();
  queue.add(HeightsTask{client, 1, HeightsQuery{.columns = {{0, 0}}}});
  REQUIRE(add(queue, client, at(0)));
  REQUIRE(queue.add({client}, std::array{at(100)}, Urgency::soon) == 1);
  auto work = queue.take();
  REQUIRE(work.has_value());
  CHECK(work->turn.urgency == Urgency::soon);
  CHECK(std::get<WorkQueue::Batch>(work->what).keys == std::vector{at(100)});
}

TEST_CASE("a patch that comes to be wanted soon is, with all that the client waits for of it") {
  WorkQueue queue{kPatch, 1000};
  const auto client = client_box();
  const auto other = client_box();
  REQUIRE(queue.add({client}, std::array{at(0), at(1), at(100)}) == 3);
  REQUIRE(add(queue, other, at(200)));
  const bool by_asking_again = GENERATE(true, false);
  if (by_asking_again) {
    REQUIRE(queue.add({client}, std::array{at(1)}, Urgency::soon) == 1);
  } else {
    queue.hasten(client->owner(), at(1));
    queue.hasten(client->owner(), at(1));
    queue.hasten(client->owner(), at(7000));  // for which it does not wait
    queue.hasten(other->owner(), at(1));      // nor this one
    queue.hasten(ClientId{999'999}, at(1));
  }
  auto work = queue.take();
  REQUIRE(work.has_value());
  CHECK(work->turn.urgency == Urgency::soon);
  CHECK(std::get<WorkQueue::Batch>(work->what).keys == std::vector{at(0), at(1)});
  queue.release(patch_of(at(0), kPatch));
  queue.reconcile(*work, 1);
  CHECK(turns_of(queue).size() == 2);
  CHECK(queue.clients() == 0);
}

TEST_CASE("a client whose far chunks wait is not refused its near ones") {
  WorkQueue queue{kPatch, 8, 4};
  const auto client = client_box();
  std::vector<ChunkKey> far;
  for (int i = 0; i < 8; ++i) far.push_back(at(100 * i));
  REQUIRE(queue.add({client}, far) == 8);
  CHECK(queue.add({client}, std::array{at(-100)}) == 0);
  CHECK(queue.add({client}, std::array{at(-100), at(-200), at(-300), at(-400)}, Urgency::soon) == 4);
  CHECK(queue.add({client}, std::array{at(-500)}, Urgency::soon) == 0);
}

TEST_CASE("work wanted soon is still wanted soon after it gives way") {
  WorkQueue queue{kPatch, 1000};
  const auto client = client_box();
  const auto beside = client_box();
  REQUIRE(queue.add({client}, std::array{at(0)}, Urgency::soon) == 1);
  auto work = queue.take();
  REQUIRE(work.has_value());
  REQUIRE(add(queue, beside, at(0)));
  auto& batch = std::get<WorkQueue::Batch>(work->what);
  batch.begun = std::make_unique<BegunPatch>();
  queue.put_back(std::move(batch), work->turn);
  queue.reconcile(*work, 1);
  work = queue.take();
  REQUIRE(work.has_value());
  CHECK(work->turn.urgency == Urgency::soon);
}

TEST_CASE("work hastened while a thread works on it is wanted soon when it gives way") {
  WorkQueue queue{kPatch, 1000};
  const auto client = client_box();
  const auto other = client_box();
  REQUIRE(add(queue, client, at(0)));
  auto work = queue.take();
  REQUIRE(work.has_value());
  const int how = GENERATE(0, 1, 2);
  if (how == 0) queue.hasten(client->owner(), at(0));
  if (how == 1) REQUIRE(queue.add({other}, std::array{at(0)}, Urgency::soon) == 1);
  if (how == 2) queue.hasten(other->owner(), at(0));  // who does not wait for it
  auto& batch = std::get<WorkQueue::Batch>(work->what);
  batch.begun = std::make_unique<BegunPatch>();
  queue.put_back(std::move(batch), work->turn);
  queue.reconcile(*work, 1);
  const auto turns = turns_of(queue);
  REQUIRE(turns.size() == 1);
  CHECK(turns.front().second == (how == 2 ? Urgency::later : Urgency::soon));
}

TEST_CASE("if any allocation fails while a chunk is hastened, it is wanted either soon or later") {
  bool failed = true;
  for (std::size_t allocations = 0; failed; ++allocations) {
    CAPTURE(allocations);
    WorkQueue queue{kPatch, 100};
    const auto client = client_box();
    REQUIRE(queue.add({client}, std::array{at(0), at(1)}) == 2);
    {
      const talus::test::FailingAllocations failing{allocations};
      try {
        queue.hasten(client->owner(), at(0));
      } catch (const std::bad_alloc&) {
      }
      failed = failing.has_failed();
    }
    const auto turns = turns_of(queue);
    REQUIRE(turns.size() == 1);
    CHECK(turns.front().second == (failed ? Urgency::later : Urgency::soon));
    CHECK(queue.jobs() == 0);
    CHECK(queue.clients() == 0);
  }
}
