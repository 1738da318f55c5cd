// The work queue where allocations fail.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <new>
#include <vector>

#include "failing_allocations.h"
#include "work_queue_helpers.h"

using namespace talus;
using namespace talus::server;

TEST_CASE("if any allocation fails while chunks are requested, the queue is intact") {
  bool failed = true;
  for (std::size_t allocations = 0; failed; ++allocations) {
    CAPTURE(allocations);
    WorkQueue queue{kPatch, 100};
    const auto client = client_box(kFlow);
    const auto other = client_box(kFlow);
    const std::array shared{at(0), at(1)};
    const std::array keys{at(0), at(1), at(2), at(100), at(101)};
    REQUIRE(queue.add({other}, shared) == 2);
    {
      const talus::test::FailingAllocations failing{allocations};
      try {
        (void)queue.add({client}, keys);
      } catch (const std::bad_alloc&) {
      }
      failed = failing.has_failed();
    }
    queue.cancel(other->owner(), at(0));
    queue.cancel(other->owner(), at(1));
    // Those before the one that failed, in their order, and nothing else.
    std::vector<ChunkKey> got;
    while (auto work = queue.take()) {
      const auto& batch = std::get<WorkQueue::Batch>(work->what);
      for (const ChunkKey key : batch.keys) {
        got.push_back(key);
        REQUIRE(end_job(queue, key) == std::vector{client});
      }
      queue.release(batch.patch);
      queue.reconcile(*work, 1);
    }
    REQUIRE(std::equal(got.begin(), got.end(), keys.begin()));
    CHECK((got.size() == keys.size()) == !failed);
    REQUIRE(queue.jobs() == 0);
    REQUIRE(queue.clients() == 0);
    CHECK(queue.add({client}, keys) == keys.size());
  }
}

TEST_CASE("if any allocation fails while a chunk is cancelled, it is either cancelled or not") {
  bool failed = true;
  for (std::size_t allocations = 0; failed; ++allocations) {
    CAPTURE(allocations);
    WorkQueue queue{kPatch, 100};
    const auto first = client_box(kFlow);
    const auto second = client_box(kOtherFlow);
    REQUIRE(add(queue, first, at(0)));
    REQUIRE(add(queue, second, at(0)));
    {
      const talus::test::FailingAllocations failing{allocations};
      try {
        queue.cancel(first->owner(), at(0));
      } catch (const std::bad_alloc&) {
      }
      failed = failing.has_failed();
    }
    const auto work = queue.take();
    REQUIRE(work.has_value());
    CHECK(queue.finish(at(0)).size() == (failed ? 2U : 1U));
    queue.release(std::get<WorkQueue::Batch>(work->what).patch);
    queue.reconcile(*work, 1);
    while (queue.take()) {
    }
    CHECK(queue.jobs() == 0);
    CHECK(queue.clients() == 0);
  }
}

TEST_CASE("heights that cannot be put back for want of memory are the caller's still") {
  bool failed = true;
  for (std::size_t allocations = 0; failed; ++allocations) {
    CAPTURE(allocations);
    WorkQueue queue{kPatch, 100};
    const auto client = client_box();
    queue.add(HeightsTask{client, 1, HeightsQuery{.columns = {{0, 0}, {1000, 0}}}});
    auto work = queue.take();
    REQUIRE(work.has_value());
    auto& task = std::get<HeightsTask>(work->what);
    {
      const talus::test::FailingAllocations failing{allocations};
      try {
        queue.put_back(std::move(task));
      } catch (const std::bad_alloc&) {
      }
      failed = failing.has_failed();
    }
    if (failed) CHECK(task.mailbox() == client);
    queue.reconcile(*work, 1);
    CHECK(queue.take().has_value() == !failed);
  }
}

TEST_CASE("if any allocation fails while a piece is taken, it is taken the next time") {
  bool failed = true;
  for (std::size_t allocations = 0; failed; ++allocations) {
    CAPTURE(allocations);
    WorkQueue queue{kPatch, 100};
    const auto client = client_box(kFlow);
    const std::array keys{at(0), at(1), at(2)};
    REQUIRE(queue.add({client}, keys) == 3);
    queue.add(HeightsTask{client, 1, HeightsQuery{.columns = {{0, 0}}}});
    std::vector<WorkQueue::Work> taken;
    taken.reserve(2);
    {
      const talus::test::FailingAllocations failing{allocations};
      try {
        while (auto work = queue.take()) taken.push_back(*std::move(work));
      } catch (const std::bad_alloc&) {
      }
      failed = failing.has_failed();
    }
    while (auto work = queue.take()) taken.push_back(*std::move(work));
    REQUIRE(taken.size() == 2);
    for (const auto& work : taken) {
      if (const auto* batch = std::get_if<WorkQueue::Batch>(&work.what)) {
        CHECK(batch->keys == std::vector(keys.begin(), keys.end()));
        queue.release(batch->patch);
      }
      queue.reconcile(work, 1);
    }
    REQUIRE(queue.jobs() == 0);
    REQUIRE(queue.clients() == 0);
  }
}

TEST_CASE("if any allocation fails while a patch is put back, its jobs are still taken, or wait") {
  bool failed = true;
  for (std::size_t allocations = 0; failed; ++allocations) {
    CAPTURE(allocations);
    WorkQueue queue{kPatch, 100};
    const auto first = client_box(kFlow);
    const auto second = client_box(kOtherFlow);
    REQUIRE(queue.add({first}, std::array{at(0), at(1)}) == 2);
    REQUIRE(queue.add({second}, std::array{at(1), at(2)}) == 2);
    auto work = queue.take();
    REQUIRE(work.has_value());
    auto& batch = std::get<WorkQueue::Batch>(work->what);
    batch.begun = std::make_unique<BegunPatch>();
    {
      const talus::test::FailingAllocations failing{allocations};
      try {
        queue.put_back(std::move(batch), work->turn);
      } catch (const std::bad_alloc&) {
      }
      failed = failing.has_failed();
    }
    if (failed) {
      CHECK(batch.begun != nullptr);
      for (const ChunkKey key : batch.keys) {
        REQUIRE(queue.begin(key));
        CHECK(queue.finish(key).size() == (key == at(1) ? 2U : 1U));
      }
      queue.release(batch.patch);
    }
    CHECK(queue.begun() == (failed ? 0U : 1U));
    queue.reconcile(*work, 1);
    CHECK(queue.take().has_value() == !failed);
    if (failed) CHECK(queue.clients() == 0);
  }
}
