#include "generation/chunk_service.h"

#include <catch2/catch.hpp>

#include "fake_generator.h"

using namespace talus;
using namespace talus::server;

namespace {

ChunkKey at(std::int32_t x) {
  return {{x, 0, 0}, Lod{}};
}

bool queued(ChunkService& service, const ChunkClientPtr& client, ChunkKey key) {
  return service.submit(client, key) == ChunkService::Submission::queued;
}

}  // namespace

TEST_CASE("many waiters, one generation") {
  FakeService fake{3};
  fake.work->close_gate();
  std::vector<std::shared_ptr<WaitingClient>> clients;
  for (int i = 0; i < 50; ++i) {
    clients.push_back(std::make_shared<WaitingClient>());
    REQUIRE(queued(fake.service, clients.back(), at(1)));
  }
  fake.work->open_gate();
  for (const auto& client : clients) client->await(1);
  CHECK(fake.work->chunks == 1);
  CHECK(fake.work->patches == 1);
}

TEST_CASE("a generated chunk is at hand from then on") {
  FakeService fake;
  const auto client = std::make_shared<WaitingClient>();
  CHECK(fake.service.find(at(1)) == nullptr);
  REQUIRE(queued(fake.service, client, at(1)));
  client->await(1);
  CHECK(fake.service.find(at(1)) == *client->answers()[0].second);
}

TEST_CASE("chunks of one patch share it") {
  FakeService fake{4};
  const auto client = std::make_shared<WaitingClient>();
  for (std::int32_t x = 0; x < 4; ++x) REQUIRE(queued(fake.service, client, at(x)));
  client->await(4);
  CHECK(fake.work->patches == 1);
  CHECK(fake.work->chunks == 4);
}

TEST_CASE("a patch that must make room leaves its mixed chunks") {
  FakeService fake;
  fake.work->patch_columns = 150'000;  // the cache holds one
  fake.work->first_mixed = 2;
  fake.work->last_mixed = 3;
  const auto client = std::make_shared<WaitingClient>();
  REQUIRE(queued(fake.service, client, {{0, 2, 0}, Lod{}}));
  client->await(1);
  CHECK(fake.service.find({{3, 3, 3}, Lod{}}) == nullptr);
  REQUIRE(queued(fake.service, client, {{100, 2, 100}, Lod{}}));
  client->await(2);
  REQUIRE(queued(fake.service, client, {{101, 2, 101}, Lod{}}));
  client->await(3);  // of the only thread, which has done with the first patch by then
  const int tiles = 4 * 4;
  CHECK(fake.work->chunks == 2 * tiles + 2);  // each of the first patch's once, and two of the second's
  CHECK(fake.service.find({{3, 3, 3}, Lod{}}) != nullptr);
  CHECK(fake.service.find({{3, 4, 3}, Lod{}}) == nullptr);
}

TEST_CASE("a cancelled chunk is not generated") {
  FakeService fake;
  fake.work->close_gate();
  const auto client = std::make_shared<WaitingClient>();
  REQUIRE(queued(fake.service, client, at(0)));    // holds the only thread at the gate, now or soon
  REQUIRE(queued(fake.service, client, at(100)));  // waits behind it
  fake.service.cancel(*client, at(100));
  fake.work->open_gate();
  client->await(1);
  REQUIRE(queued(fake.service, client, at(200)));
  client->await(2);
  CHECK(fake.work->chunks == 2);
}

TEST_CASE("a chunk cancelled while its patch is made is not generated") {
  FakeService fake;
  fake.work->close_gate();
  const auto client = std::make_shared<WaitingClient>();
  REQUIRE(queued(fake.service, client, at(100)));
  fake.work->await_somebody_at_gate();  // the only thread: what comes now is taken together
  REQUIRE(queued(fake.service, client, at(0)));
  REQUIRE(queued(fake.service, client, at(1)));
  fake.service.cancel(*client, at(100));
  fake.work->open_gate();
  client->await(2);
  CHECK(fake.work->chunks == 2);
}

TEST_CASE("out of memory is an answer, and the next request may succeed") {
  FakeService fake;
  fake.work->out_of_memory = true;
  const auto client = std::make_shared<WaitingClient>();
  REQUIRE(queued(fake.service, client, at(0)));
  client->await(1);
  CHECK_FALSE(client->answers()[0].second.has_value());
  fake.work->out_of_memory = false;
  REQUIRE(queued(fake.service, client, at(0)));
  client->await(2);
  CHECK(client->answers()[1].second.has_value());
}

TEST_CASE("heights that fail are answered too") {
  FakeService fake;
  fake.work->out_of_memory = true;
  const auto client = std::make_shared<WaitingClient>();
  fake.service.submit_heights({client, 7, {{1, 2}}});
  client->await(1);
  CHECK(client->heights()[0].first == 7);
  CHECK_FALSE(client->heights()[0].second.has_value());
}

TEST_CASE("a client that cannot take its answers harms nobody") {
  struct Exhausted final : ChunkClient {
    void chunks_ready(std::vector<ReadyChunk>) override { throw std::bad_alloc{}; }
    void heights_ready(std::uint64_t, HeightsAnswer) override { throw std::bad_alloc{}; }
  };
  FakeService fake;
  const auto exhausted = std::make_shared<Exhausted>();
  REQUIRE(queued(fake.service, exhausted, at(1)));
  fake.service.submit_heights({exhausted, 1, {{1, 2}}});
  const auto client = std::make_shared<WaitingClient>();
  REQUIRE(queued(fake.service, client, at(2)));
  fake.service.submit_heights({client, 1, {{1, 2}}});
  client->await(2);
}

TEST_CASE("a full queue refuses") {
  FakeService fake{1, 1};
  fake.work->close_gate();
  const auto client = std::make_shared<WaitingClient>();
  REQUIRE(queued(fake.service, client, at(0)));
  CHECK_FALSE(queued(fake.service, client, at(1)));
}
