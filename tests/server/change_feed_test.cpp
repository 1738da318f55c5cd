// Who is told of which changes, and how often.
#include "chunks/change_feed.h"

#include <catch2/catch.hpp>
#include <condition_variable>
#include <memory>
#include <set>

#include <rapidcheck.h>

#include <talus/voxel/view_shape.h>

#include "runtime/log/logger.h"

using namespace talus;
using namespace talus::server;

namespace {

struct Client {
  int wakes = 0;
  MailboxPtr mailbox;
  explicit Client(std::uint64_t id) : mailbox{std::make_shared<Mailbox>(ClientId{id}, [this] { ++wakes; })} {}
  Client(const Client&) = delete;
  Client& operator=(const Client&) = delete;

  std::vector<ChunkChangesPtr> take() {
    std::vector<ChunkChangesPtr> all;
    for (const Mail& mail : mailbox->take()) all.push_back(std::get<ChunksChanged>(mail).changes);
    return all;
  }
};

std::vector<LevelBox> boxes_around(std::int64_t x, int radius) {
  return level_boxes({{x, 0, 0}, radius, 1, {{Lod::of(1), radius + 4}}});
}

ChunkChange change(ChunkKey key, std::uint64_t previous, std::uint64_t revision) {
  return {key, previous, revision};
}

ChunkKey at(std::int32_t x, std::int32_t y = 0, int lod = 0) {
  return {{x, y, 0}, Lod::of(lod)};
}

struct Bench {
  ChangeFeed feed{make_logger("off", "text")};
  void changed(const ChunkChange& one) { feed.on_changed({&one, 1}); }
};

}  // namespace

TEST_CASE("a change is sent to the clients whose boxes have the chunk") {
  Bench bench;
  Client near{1};
  Client far{2};
  bench.feed.watch(near.mailbox, boxes_around(0, 2));
  bench.feed.watch(far.mailbox, boxes_around(100, 2));
  bench.changed(change(at(2), 0, 1));
  bench.feed.send();
  const auto told = near.take();
  REQUIRE(told.size() == 1);
  REQUIRE(told[0]->size() == 1);
  CHECK(told[0]->at(0).key == at(2));
  CHECK(near.wakes == 1);
  CHECK(far.take().empty());
  CHECK(far.wakes == 0);
  bench.changed(change(at(3), 0, 2));        // level 0 ends at 2
  bench.changed(change(at(0, 5), 0, 2));     // above
  bench.changed(change(at(0, 0, 1), 0, 2));  // inside the ring
  bench.feed.send();
  CHECK(near.take().empty());
  bench.changed(change(at(2, 0, 1), 0, 3));
  bench.feed.send();
  CHECK(near.take().size() == 1);
}

TEST_CASE("each client receives only its own chunks") {
  Bench bench;
  Client west{1};
  Client east{2};
  Client both{3};
  bench.feed.watch(west.mailbox, boxes_around(0, 2));
  bench.feed.watch(east.mailbox, boxes_around(100, 2));
  bench.feed.watch(both.mailbox, boxes_around(50, 60));
  for (const std::int32_t x : {0, 1, 100}) bench.changed(change(at(x), 0, 1));
  bench.feed.send();
  const auto keys = [](Client& client) {
    const auto told = client.take();
    REQUIRE(told.size() == 1);
    std::set<ChunkKey> all;
    for (const ChunkChange& each : *told[0]) all.insert(each.key);
    CHECK(all.size() == told[0]->size());
    return all;
  };
  CHECK(keys(west) == std::set{at(0), at(1)});
  CHECK(keys(east) == std::set{at(100)});
  CHECK(keys(both) == std::set{at(0), at(1), at(100)});
}

TEST_CASE("a client with a pending answer receives its changes with it, or is woken for them") {
  Bench bench;
  Client answered{1};
  Client waits{2};
  Client watches{3};
  for (Client* const client : {&answered, &waits, &watches}) {
    bench.feed.watch(client->mailbox, boxes_around(0, 2));
  }
  answered.mailbox->expect_answer(true);
  waits.mailbox->expect_answer(true);
  bench.changed(change(at(1), 0, 1));
  bench.feed.send();
  CHECK(watches.wakes == 1);
  CHECK(answered.wakes + waits.wakes == 0);
  CHECK(answered.take().size() == 1);
  CHECK(bench.feed.has_held());
  bench.feed.wake_held();
  CHECK_FALSE(bench.feed.has_held());
  CHECK(answered.wakes == 0);
  CHECK(waits.wakes == 1);
  CHECK(waits.take().size() == 1);
}

TEST_CASE("several edits of a chunk are sent as one change") {
  Bench bench;
  Client client{1};
  bench.feed.watch(client.mailbox, boxes_around(0, 2));
  for (std::uint64_t revision = 1; revision <= 9; ++revision)
    bench.changed(change(at(1), revision - 1, revision));
  bench.feed.send();
  const auto told = client.take();
  REQUIRE(told.size() == 1);
  REQUIRE(told[0]->size() == 1);
  CHECK(told[0]->at(0).previous == 0);
  CHECK(told[0]->at(0).revision == 9);
  bench.feed.send();
  CHECK(client.take().empty());
}

TEST_CASE("new boxes replace the old ones, and empty boxes forget the client") {
  Bench bench;
  Client client{1};
  bench.feed.watch(client.mailbox, boxes_around(0, 2));
  bench.feed.watch(client.mailbox, boxes_around(50, 2));
  bench.changed(change(at(0), 0, 1));
  bench.feed.send();
  CHECK(client.take().empty());
  bench.changed(change(at(50), 0, 2));
  bench.feed.send();
  CHECK(client.take().size() == 1);
  CHECK(client.mailbox.use_count() == 2);
  bench.feed.watch(client.mailbox, {});
  CHECK(client.mailbox.use_count() == 1);
  CHECK(bench.feed.watchers() == 0);
  bench.changed(change(at(50), 2, 3));
  bench.feed.send();
  CHECK(client.take().empty());
}

TEST_CASE("more chunks than are gathered are any chunk") {
  Bench bench;
  Client client{1};
  bench.feed.watch(client.mailbox, boxes_around(0, 2));
  for (std::size_t i = 0; i <= ChangeFeed::kMaxGathered; ++i) {
    bench.changed(change(at(1000 + static_cast<std::int32_t>(i)), 0, i + 1));
  }
  bench.feed.send();
  CHECK(client.take() == std::vector<ChunkChangesPtr>{nullptr});
  bench.feed.send();
  CHECK(client.take().empty());
}

TEST_CASE("the clients found equal the result of a search in every box") {
  CHECK(rc::check([] {
    Bench bench;
    std::vector<std::unique_ptr<Client>> clients;
    std::vector<std::vector<LevelBox>> boxes(6);
    for (std::uint64_t id = 0; id < boxes.size(); ++id) clients.push_back(std::make_unique<Client>(id + 1));
    const auto steps = *rc::gen::container<std::vector<std::pair<int, int>>>(
        rc::gen::pair(rc::gen::inRange(0, 8), rc::gen::inRange(-40, 40)));
    for (const auto& [what, where] : steps) {
      if (what < 6) {
        const auto client = static_cast<std::size_t>(what);
        boxes[client] = where % 5 == 0 ? std::vector<LevelBox>{} : boxes_around(where, std::abs(where) % 7);
        bench.feed.watch(clients[client]->mailbox, boxes[client]);
        continue;
      }
      const ChunkKey key = at(where, where % 3, what - 6);
      bench.changed(change(key, 0, 1));
      bench.feed.send();
      for (std::size_t client = 0; client < boxes.size(); ++client) {
        const bool has = std::any_of(boxes[client].begin(), boxes[client].end(), [&](const LevelBox& box) {
          return box.lod == key.lod && box.contains(key.coord);
        });
        RC_ASSERT(clients[client]->take().size() == (has ? 1U : 0U));
      }
    }
  }));
}

TEST_CASE("the thread delivers changes without a request") {
  std::mutex mutex;
  std::condition_variable woken;
  int wakes = 0;
  const auto mailbox = std::make_shared<Mailbox>(ClientId{1}, [&] {
    const std::lock_guard lock{mutex};
    ++wakes;
    woken.notify_all();
  });
  Bench bench;
  bench.feed.watch(mailbox, boxes_around(0, 2));
  bench.feed.start();
  for (int round = 1; round <= 3; ++round) {
    const auto revision = static_cast<std::uint64_t>(round);
    bench.changed(change(at(1), revision - 1, revision));
    std::unique_lock lock{mutex};
    woken.wait(lock, [&] { return wakes == round; });
    CHECK(mailbox->take().size() == 1);
  }
}
