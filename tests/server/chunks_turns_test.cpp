// Heights, and what is dear: patches and heights that give way to others midway.
#include "chunks/chunks.h"

#include <algorithm>
#include <atomic>
#include <catch2/catch.hpp>
#include <memory>
#include <new>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "chunks_bench.h"
#include "fake_generator.h"

namespace talus::server::chunks_test {

TEST_CASE("heights come by their ticket, failed ones too") {
  FakeService fake;
  WaitingClient client;
  fake.service.submit_heights(client.mailbox(), 6, HeightsQuery{.columns = {{1, 2}, {3, 4}}});
  client.await(1);
  CHECK(client.heights()[0].first == 6);
  CHECK(client.heights()[0].second.value().heights_fx.size() == 2);
  fake.work->out_of_memory = true;
  fake.service.submit_heights(client.mailbox(), 7, HeightsQuery{.columns = {{1, 2}}});
  client.await(2);
  CHECK(client.heights()[1].first == 7);
  CHECK_FALSE(client.heights()[1].second.has_value());
}

TEST_CASE("a body of heights is written by the thread that makes them, once and of all") {
  FakeService fake;
  WaitingClient client;
  std::thread::id writer;
  int written = 0;
  HeightsQuery query{.columns = {{1, 2}, {300, 400}}};
  query.body = [&](const HeightsResult& found) {
    writer = std::this_thread::get_id();
    ++written;
    return std::to_string(found.heights_fx.size());
  };
  fake.service.submit_heights(client.mailbox(), 1, query);
  client.await(1);
  const HeightsResult& found = client.heights()[0].second.value();
  CHECK(found.body == "2");
  CHECK(found.heights_fx.empty());
  CHECK(written == 1);
  CHECK(writer != std::this_thread::get_id());

  query.body = [](const HeightsResult&) -> std::string { throw std::bad_alloc{}; };
  fake.service.submit_heights(client.mailbox(), 2, query);
  client.await(2);
  CHECK_FALSE(client.heights()[1].second.has_value());
}

TEST_CASE("dear heights are made a piece at a time, and others have their turns between") {
  FakeService fake;
  fake.work->close_gate();
  std::atomic<int> pieces{0};
  std::atomic<int> pieces_at_patch{-1};
  fake.work->in_heights = [&] {
    ++pieces;
    fake.clock.spend_cpu(std::chrono::milliseconds{10});
  };
  fake.work->in_patch = [&] {
    if (fake.work->patches == 1) pieces_at_patch = pieces.load();
  };
  std::vector<terrain::BaseColumn> scattered;
  for (std::int64_t tile = 0; tile < 50; ++tile) scattered.push_back({tile * kChunkSize, 0});
  WaitingClient holder;
  WaitingClient dear;
  WaitingClient player;
  REQUIRE(queued(fake.service, holder, at(1000)));
  fake.work->await_somebody_at_gate();  // until all have asked
  fake.service.submit_heights(dear.mailbox(), 1, HeightsQuery{.columns = scattered});
  REQUIRE(queued(fake.service, player, at(0)));
  fake.work->open_gate();
  player.await(1);
  dear.await(1);
  CHECK(pieces == 50);
  CHECK(pieces_at_patch <= 3);
  CHECK(dear.heights()[0].second.value().heights_fx.size() == scattered.size());
}

TEST_CASE("an expensive patch gives way to others midway, and resumes at the same point") {
  FakeService fake;
  fake.work->close_gate();
  fake.work->patch_steps = 100;
  const PatchKey dear_patch{100, 0, Lod{}};
  std::atomic<int> steps_of_dear{0};
  std::atomic<int> steps_of_others{0};
  std::atomic<int> steps_before_player{-1};
  fake.work->in_step = [&](const PatchKey& patch) {
    ++(patch == dear_patch ? steps_of_dear : steps_of_others);
    if (steps_of_others == 200 && steps_before_player < 0) steps_before_player = steps_of_dear.load();
    const std::chrono::microseconds step{patch == dear_patch ? 10'000 : 10};
    fake.clock.advance(step);
    fake.clock.spend_cpu(step);
  };
  WaitingClient dear;
  WaitingClient player;
  REQUIRE(queued(fake.service, dear, at(400)));
  fake.work->await_somebody_at_gate();
  REQUIRE(queued(fake.service, player, at(0)));
  REQUIRE(queued(fake.service, player, at(4)));
  fake.work->open_gate();
  player.await(2);
  // Who comes while it waits gets its chunks by it, too.
  WaitingClient late;
  REQUIRE(queued(fake.service, late, at(401)));
  late.await(1);
  dear.await(1);
  CHECK(steps_before_player < 50);
  CHECK(steps_of_dear == 100);
  CHECK(steps_of_others == 200);
  CHECK(fake.work->patches == 3);
  CHECK(fake.service.status().jobs == 0);
}

TEST_CASE("a half-made patch is dropped when the last client cancels it") {
  FakeService fake;
  fake.work->close_gate();
  fake.work->patch_steps = 100;
  const PatchKey dear_patch{100, 0, Lod{}};
  WaitingClient dear;
  WaitingClient player;
  std::atomic<int> steps_of_dear{0};
  fake.work->in_step = [&](const PatchKey& patch) {
    const std::chrono::milliseconds step{10};
    fake.clock.advance(step);
    fake.clock.spend_cpu(step);
    if (patch == dear_patch) {
      ++steps_of_dear;
    } else if (steps_of_dear > 0) {
      cancel(fake.service, dear, at(400));
    }
  };
  REQUIRE(queued(fake.service, dear, at(400)));
  fake.work->await_somebody_at_gate();
  REQUIRE(queued(fake.service, player, at(0)));
  fake.work->open_gate();
  player.await(1);
  CHECK(steps_of_dear < 10);
  CHECK(fake.work->patches == 1);
  CHECK(fake.service.status().jobs == 0);
  CHECK(fake.service.status().clients == 0);
  fake.work->in_step = nullptr;
  REQUIRE(queued(fake.service, dear, at(400)));
  dear.await(1);
  CHECK(fake.work->patches == 2);
}

TEST_CASE("heights of one tile that are dear give way midway, too") {
  FakeService fake;
  fake.work->close_gate();
  fake.work->heights_steps = 100;
  std::atomic<int> steps{0};
  std::atomic<int> steps_at_patch{-1};
  fake.work->in_heights = [&] {
    ++steps;
    fake.clock.advance(std::chrono::milliseconds{10});
    fake.clock.spend_cpu(std::chrono::milliseconds{10});
  };
  fake.work->in_patch = [&] {
    if (fake.work->patches == 1) steps_at_patch = steps.load();
  };
  WaitingClient holder;
  WaitingClient dear;
  WaitingClient player;
  REQUIRE(queued(fake.service, holder, at(1000)));
  fake.work->await_somebody_at_gate();
  fake.service.submit_heights(dear.mailbox(), 1, HeightsQuery{.columns = {{5, 5}, {6, 6}}});
  REQUIRE(queued(fake.service, player, at(0)));
  fake.work->open_gate();
  player.await(1);
  dear.await(1);
  CHECK(steps == 100);
  CHECK(steps_at_patch <= 10);
  CHECK(dear.heights()[0].second.value().heights_fx.size() == 2);
}

TEST_CASE("heights that are cancelled while they are made end with their piece") {
  FakeService fake;
  WaitingClient dear;
  std::atomic<int> pieces{0};
  fake.work->in_heights = [&] {
    if (++pieces == 4) fake.service.cancel_heights(dear.id(), 1);
    fake.clock.spend_cpu(std::chrono::milliseconds{10});
  };
  std::vector<terrain::BaseColumn> scattered;
  for (std::int64_t tile = 0; tile < 50; ++tile) scattered.push_back({tile * kChunkSize, 0});
  fake.service.submit_heights(dear.mailbox(), 1, HeightsQuery{.columns = scattered});
  fake.service.submit_heights(dear.mailbox(), 2, HeightsQuery{.columns = {{1, 2}}});
  dear.await(1);
  CHECK(dear.heights()[0].first == 2);
  CHECK(pieces <= 8);
}

TEST_CASE("a patch that no client wants is given up, and made when a client asks again") {
  FakeService fake;
  fake.work->close_gate();
  WaitingClient client;
  std::atomic<bool> leaves{true};
  fake.work->in_patch = [&] {
    if (!leaves.exchange(false)) return;
    cancel(fake.service, client, at(1));
    cancel(fake.service, client, at(2));
    fake.clock.advance(std::chrono::seconds{1});
  };
  REQUIRE(queued(fake.service, client, at(1)));
  REQUIRE(queued(fake.service, client, at(2)));
  WaitingClient other;
  REQUIRE(queued(fake.service, other, at(100)));
  fake.work->open_gate();
  other.await(1);
  CHECK(fake.work->patches == 1);
  CHECK(fake.service.status().jobs == 0);
  REQUIRE(queued(fake.service, client, at(1)));
  client.await(1);
  CHECK(client.answers()[0].second.has_value());
  CHECK(fake.work->patches == 2);
}

TEST_CASE("a patch is made as long as one client still wants it") {
  FakeService fake;
  fake.work->close_gate();
  WaitingClient client;
  WaitingClient other;
  fake.work->in_patch = [&] {
    cancel(fake.service, client, at(1));
    fake.clock.advance(std::chrono::seconds{1});
  };
  REQUIRE(queued(fake.service, client, at(1)));
  REQUIRE(queued(fake.service, other, at(1)));
  fake.work->open_gate();
  other.await(1);
  CHECK(fake.work->patches == 1);
}

TEST_CASE("tiles of the map give way to a player at once, however many clients of a flow ask for them") {
  FakeService fake;
  constexpr int kStepsATile = 100;
  fake.work->heights_steps = kStepsATile;
  fake.work->close_gate();
  const auto tiles_flow = std::make_shared<FlowUse>(FlowId{1'000'000}, FlowName{});
  WaitingClient holder;
  WaitingClient player;
  std::vector<std::unique_ptr<WaitingClient>> clients;
  int steps = 0;
  int asked_at = 0;
  int longest = 0;
  std::int32_t asked = 0;
  // While tiles are drawn the player asks now and then for a chunk that costs a step.
  fake.work->in_heights = [&] {
    fake.clock.advance(std::chrono::milliseconds{2});
    fake.clock.spend_cpu(std::chrono::milliseconds{2});
    if (++steps % 130 != 0) return;
    asked_at = steps;
    if (queued(fake.service, player, at((asked + 1) * 1000))) ++asked;
  };
  fake.work->in_patch = [&] {
    fake.clock.spend_cpu(std::chrono::milliseconds{2});
    if (asked_at > 0) longest = std::max(longest, steps - std::exchange(asked_at, 0));
  };
  REQUIRE(queued(fake.service, holder, at(-1000)));
  fake.work->await_somebody_at_gate();
  for (std::int64_t x = 0; x < 30; ++x) {
    clients.push_back(std::make_unique<WaitingClient>());
    clients.back()->mailbox()->join(tiles_flow);
    fake.service.submit_heights(clients.back()->mailbox(), 1, HeightsQuery{.tile = map::Tile{12, x, 0}});
  }
  fake.work->open_gate();
  for (const auto& client : clients) client->await(1);
  player.await(static_cast<std::size_t>(asked));
  CHECK(steps == 30 * kStepsATile);
  CHECK(asked >= 20);
  CHECK(longest <= 2);
}

}  // namespace talus::server::chunks_test
