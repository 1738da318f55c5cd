#include "generation/chunk_service.h"

#include <catch2/catch.hpp>

#include "fake_generator.h"
#include "generation/handover.h"

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
  CHECK(fake.service.find({{3, 4, 3}, Lod{}}) != nullptr);  // air, without a look at the patch
  CHECK(fake.work->chunks == 2 * tiles + 2);
}

TEST_CASE("a patch whose mixed chunks are all kept is let go, and its memory serves the next") {
  FakeService fake;
  fake.work->patch_columns = 1000;
  fake.work->first_mixed = 0;
  fake.work->last_mixed = 1;
  const auto client = std::make_shared<WaitingClient>();
  std::size_t asked = 0;
  for (std::int32_t i = 0; i < 4 * 4 * 2; ++i) {
    REQUIRE(queued(fake.service, client, {{i % 4, i / 16, i / 4 % 4}, Lod{}}));
    ++asked;
  }
  client->await(asked);
  const ChunkKey elsewhere{{100, 0, 100}, Lod{}};
  REQUIRE(queued(fake.service, client, elsewhere));
  client->await(asked + 1);  // of the only thread, which has done with the first patch by then
  const std::size_t one_patch = fake.service.status().patch_cache_bytes;
  CHECK(one_patch >= 4000);
  CHECK(one_patch < 8000);
  for (std::int32_t i = 0; i < 4 * 4 * 2; ++i) {
    CHECK(fake.service.find({{i % 4, i / 16, i / 4 % 4}, Lod{}}) != nullptr);
  }
  CHECK(fake.work->lent == 1);
}

TEST_CASE("answers come to each who waits, once and in the order in which they were made") {
  const auto one = std::make_shared<WaitingClient>();
  const auto other = std::make_shared<WaitingClient>();
  const Logger log = std::make_shared<spdlog::logger>("silent");
  Handover handover{log};
  const ChunkAnswer answer = tl::make_unexpected(GenerationFailed{"of no use here"});
  for (std::int32_t x = 0; x < 5; ++x) {
    handover.add(x % 2 == 0 ? std::vector<ChunkClientPtr>{one, other} : std::vector<ChunkClientPtr>{one},
                 at(x), answer);
  }
  handover.flush();
  const auto keys = [](const WaitingClient& client) {
    std::vector<std::int32_t> xs;
    for (const auto& [key, chunk] : client.answers()) xs.push_back(key.coord.x);
    return xs;
  };
  CHECK(keys(*one) == std::vector<std::int32_t>{0, 1, 2, 3, 4});
  CHECK(keys(*other) == std::vector<std::int32_t>{0, 2, 4});
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
