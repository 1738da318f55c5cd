// The work queue with what was begun and gave way.
#include <array>
#include <catch2/catch.hpp>
#include <utility>
#include <vector>

#include "work_queue_helpers.h"

using namespace talus;
using namespace talus::server;

namespace {

const WorkCosts kCosts{.patch = 100, .longest_piece = 25, .max_begun = 2};

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
  REQUIRE(queue.add(dear, std::array{at(0), at(1)}) == 2);
  auto work = take(queue);
  REQUIRE(queue.add(other, std::array{at(100), at(200), at(300)}) == 3);
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

TEST_CASE("whoever comes to wait for a patch that was begun goes on with it") {
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

TEST_CASE("what was begun goes with the last job that waits for it") {
  WorkQueue queue{kPatch, 100};
  const auto client = client_box();
  REQUIRE(add(queue, client, at(0)));
  auto work = take(queue);
  (void)pause(queue, work);
  REQUIRE(queue.begun() == 1);
  queue.cancel(client->owner(), at(0));
  CHECK(queue.begun() == 0);
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

TEST_CASE("a flow that has begun something begins nothing else but what is in memory") {
  WorkQueue queue{kPatch, 100};
  const auto client = client_box(kFlow);
  const auto same_flow = client_box(kFlow);
  const auto other = client_box(kOtherFlow);
  REQUIRE(add(queue, client, at(0)));
  auto work = take(queue);
  (void)pause(queue, work);
  REQUIRE(add(queue, same_flow, at(100)));
  queue.add(HeightsTask{same_flow, 1, {{0, 0}}});
  REQUIRE(add(queue, other, at(200)));
  CHECK(queue.others_wait(client->owner(), kCosts));  // the other flow's
  CHECK_FALSE(queue.others_wait(other->owner(), {.patch = 100, .max_begun = 0}) ==
              false);  // its own begun patch
  std::vector<ClientId> taken;
  for (int i = 0; i < 2; ++i) taken.push_back(take(queue).turn.client);
  CHECK(std::find(taken.begin(), taken.end(), same_flow->owner()) == taken.end());
  // Nothing is begun any more that was put back, so all may begin.
  CHECK(take(queue).turn.client == same_flow->owner());
}

TEST_CASE("of a flow that has begun something what is in memory is taken") {
  WorkQueue queue{kPatch, 100};
  const auto client = client_box(kFlow);
  const auto same_flow = client_box(kFlow);
  REQUIRE(add(queue, client, at(0)));
  auto work = take(queue);
  (void)pause(queue, work);
  REQUIRE(add(queue, same_flow, at(100)));
  WorkCosts costs = kCosts;
  const PatchKey there = patch_of(at(100), kPatch);
  costs.in_memory = [&](const PatchKey& patch) { return patch == there; };
  CHECK(queue.others_wait(client->owner(), costs));
  CHECK_FALSE(queue.others_wait(client->owner(), kCosts));
}

TEST_CASE("of all flows so much is begun at most, and then that is gone on with") {
  WorkQueue queue{kPatch, 100};
  std::vector<MailboxPtr> clients;
  for (int i = 0; i < 4; ++i) clients.push_back(client_box());
  for (std::size_t i = 0; i < 4; ++i) REQUIRE(add(queue, clients[i], at(static_cast<std::int32_t>(i) * 100)));
  std::vector<WorkQueue::Work> begun;
  for (int i = 0; i < 2; ++i) begun.push_back(take(queue));
  for (auto& work : begun) (void)pause(queue, work);
  REQUIRE(queue.begun() == kCosts.max_begun);
  for (int i = 0; i < 6; ++i) {
    auto next = take(queue);
    REQUIRE(batch_of(next).begun != nullptr);
    if (i < 5) {
      (void)pause(queue, next);
    } else {
      finish(queue, next);
    }
  }
  auto next = take(queue);
  if (batch_of(next).begun != nullptr) {
    (void)pause(queue, next);
    next = take(queue);
  }
  CHECK(batch_of(next).begun == nullptr);
}

TEST_CASE("heights that were begun count until they are gone on with or cancelled") {
  class Nothing final : public HeightsMaking {
   public:
    [[nodiscard]] bool step() override { return true; }
    [[nodiscard]] std::vector<std::int32_t> take() override { return {}; }
  };
  WorkQueue queue{kPatch, 100};
  const auto client = client_box();
  queue.add(HeightsTask{client, 1, {{0, 0}}});
  for (const bool cancelled : {false, true}) {
    auto work = take(queue);
    auto& task = std::get<HeightsTask>(work.what);
    CHECK(task.is_begun() == cancelled);
    CHECK(queue.begun() == 0);
    if (!task.is_begun()) task.making() = std::make_unique<Nothing>();
    queue.put_back(std::move(task));
    queue.reconcile(work, 25);
    CHECK(queue.begun() == 1);
    if (cancelled) queue.cancel_heights(client->owner(), 1);
  }
  CHECK(queue.begun() == 0);
  CHECK_FALSE(queue.take(kCosts).has_value());
  CHECK(queue.clients() == 0);
}
