// What a client may take up: time, connections, requests.
#include <algorithm>
#include <catch2/catch.hpp>
#include <chrono>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "messages.h"
#include "raw_client.h"
#include "server_process.h"
#include "worked_for.h"

using namespace talus;
using namespace talus::e2e;
using std::chrono::milliseconds;

namespace {

/// Sends `bytes` one at a time, with a pause only while nothing comes from the server; returns what came
/// before they were all sent.
std::optional<ReceivedFrame> drip(RawClient& client, const protocol::Frame& bytes) {
  for (const std::byte each : bytes) {
    if (!client.send({&each, 1})) break;
    if (auto received = client.receive_within(milliseconds{20})) return received;
  }
  return client.receive_within(milliseconds{0});
}

void check_timeout(RawClient& client, const std::optional<ReceivedFrame>& received) {
  REQUIRE(received.has_value());
  CHECK(received->as<wire::Error>().code() == wire::ErrorCode::timeout);
  CHECK(client.closed());
}

}  // namespace

TEST_CASE("a silent client is dropped") {
  const ServerProcess server{{{"TALUS_LIMITS_HANDSHAKE_TIMEOUT_MS", "100"}}};
  RawClient client{server.port()};
  check_timeout(client, client.receive());
}

TEST_CASE("a Hello of one byte at a time is dropped") {
  const ServerProcess server{{{"TALUS_LIMITS_HANDSHAKE_TIMEOUT_MS", "200"}}};
  RawClient client{server.port()};
  check_timeout(client, drip(client, hello({.client = std::string(1000, 'x')})));
}

TEST_CASE("a client that is silent after Hello is dropped") {
  const ServerProcess server{{{"TALUS_LIMITS_IDLE_TIMEOUT_MS", "100"}}};
  RawClient client = greeted(server.port());
  check_timeout(client, client.receive());
}

TEST_CASE("a frame of one byte at a time does not count as life") {
  const ServerProcess server{{{"TALUS_LIMITS_IDLE_TIMEOUT_MS", "200"}}};
  RawClient client = greeted(server.port());
  check_timeout(client, drip(client, cancel(std::vector<std::uint32_t>(300, 1))));
}

// By WebSocket it is told so by HTTP, and asking for one is a request itself.
TEST_CASE("one connection too many from an address is refused with a reason", "[tcp]") {
  const ServerProcess server{{{"TALUS_LIMITS_CONNECTIONS_PER_ADDRESS", "2"}}};
  RawClient first = greeted(server.port());
  RawClient second = greeted(server.port());
  RawClient third{server.port()};
  const ReceivedFrame refused = third.expect();
  CHECK(refused.as<wire::Error>().code() == wire::ErrorCode::overloaded);
  CHECK(refused.as<wire::Error>().retry_after_ms() > 0);
  CHECK(third.closed());

  REQUIRE(first.send(ping(1)));
  (void)first.expect_kind<wire::Pong>();
}

TEST_CASE("a place is free again when its connection has ended", "[tcp]") {
  const ServerProcess server{{{"TALUS_LIMITS_CONNECTIONS", "1"}}};
  {
    RawClient first = greeted(server.port());
    // The server closes this one, and the place is free before the client sees the end.
    REQUIRE(first.send(hello()));
    (void)first.expect_kind<wire::Error>();
    CHECK(first.closed());
  }
  // The end of the first is known to the server when it has read it; until then it refuses.
  for (;;) {
    RawClient next{server.port()};
    (void)next.send(hello());
    const ReceivedFrame received = next.expect();
    if (received.kind() == wire::Body::Welcome) break;
    REQUIRE(received.as<wire::Error>().code() == wire::ErrorCode::overloaded);
  }
}

TEST_CASE("requests over the limit are refused by their ids, the others answered") {
  const ServerProcess server{{{"TALUS_LIMITS_REQUESTS_IN_FLIGHT", "3"}}};
  RawClient client = greeted(server.port());
  std::vector<wire::ChunkRequest> requests;
  for (std::uint32_t id = 1; id <= 5; ++id) requests.push_back(chunk_request(id, at(0, 0, 0)));
  REQUIRE(client.send(get_chunks(requests)));
  int chunks = 0;
  for (std::uint32_t answer = 1; answer <= 5; ++answer) {
    const ReceivedFrame received = client.expect();
    if (received.kind() == wire::Body::Chunk) {
      ++chunks;
    } else {
      CHECK(received.as<wire::Error>().code() == wire::ErrorCode::too_many_requests);
      CHECK(received.as<wire::Error>().request_id() > 3);
    }
  }
  CHECK(chunks == 3);
}

TEST_CASE("work for a client that is gone while its reading is paused is given up") {
  if (kSanitized) return;  // a column takes too long; session_gone_test has the same cases
  ServerProcess server{kDearColumns, {"--admin", "127.0.0.1:0"}};
  const std::uint16_t admin = server.admin_port();
  std::vector<RawClient> clients;
  for (std::uint32_t client = 0; client < kDearClients; ++client) {
    clients.push_back(greeted(server.port()));
    for (std::uint32_t id = 1; id <= kDearRequests; ++id) {
      REQUIRE(clients.back().send(get_heights(id, far_columns(client * kDearRequests + id))));
    }
  }
  const double before = await_pauses(admin);
  for (RawClient& each : clients) each.reset();
  check_given_up(admin, before);
}

TEST_CASE("heights over the limit are refused") {
  const ServerProcess server{{{"TALUS_LIMITS_HEIGHTS_PER_REQUEST", "2"}}};
  RawClient client = greeted(server.port());
  REQUIRE(client.send(get_heights(6, {{0, 0}, {1, 0}, {2, 0}})));
  const ReceivedFrame received = client.expect();
  CHECK(received.as<wire::Error>().request_id() == 6);
  CHECK(received.as<wire::Error>().code() == wire::ErrorCode::too_large);
}

TEST_CASE("a View comes whole where the generators' queue holds one of its chunks at a time") {
  const ServerProcess server{{{"TALUS_GENERATION_QUEUE_CHUNKS", "1"}, {"TALUS_THREADS_GENERATOR", "1"}}};
  RawClient client = greeted(server.port());
  REQUIRE(client.send(view({.horizontal_radius = 1})));
  std::set<std::pair<std::int32_t, std::int32_t>> columns;
  for (int chunk = 0; chunk < 9; ++chunk) {
    const ReceivedFrame received = client.expect();
    const wire::ChunkKey& key = *received.as<wire::Chunk>().key();
    columns.emplace(key.x(), key.z());
  }
  CHECK(columns.size() == 9);
}

TEST_CASE("a client over its rate is refused with a time, and served after it") {
  const ServerProcess server{{{"TALUS_RATES_SESSION_REQUESTS", "20"}, {"TALUS_RATES_BURST_MS", "100"}}};
  RawClient client = greeted(server.port());
  REQUIRE(client.send(get_chunks(
      {chunk_request(1, at(0, 0, 0)), chunk_request(2, at(0, 0, 0)), chunk_request(3, at(0, 0, 0))})));
  int refused = 0;
  milliseconds wait{0};
  for (int answer = 0; answer < 3; ++answer) {
    const ReceivedFrame received = client.expect();
    if (received.kind() != wire::Body::Error) continue;
    ++refused;
    CHECK(received.as<wire::Error>().code() == wire::ErrorCode::overloaded);
    wait = milliseconds{received.as<wire::Error>().retry_after_ms()};
  }
  CHECK(refused >= 1);
  CHECK(wait > milliseconds{0});
  CHECK(wait <= milliseconds{50});
  // So long and no longer: where this machine is slow more time passes, which only helps.
  CHECK_FALSE(client.receive_within(wait).has_value());
  REQUIRE(client.send(get_chunks({chunk_request(4, at(0, 0, 0))})));
  (void)client.expect_kind<wire::Chunk>();
}

TEST_CASE("a View over its rate of chunks comes whole, later") {
  constexpr int kPerSecond = 50;
  constexpr int kBurst = 10;
  constexpr int kChunks = 25;
  const ServerProcess server{{{"TALUS_RATES_SESSION_CHUNKS", std::to_string(kPerSecond)},
                              {"TALUS_RATES_BURST_MS", std::to_string(1000 * kBurst / kPerSecond)}}};
  RawClient client = greeted(server.port());
  const auto began = std::chrono::steady_clock::now();
  REQUIRE(client.send(view({.horizontal_radius = 2})));
  for (int chunk = 0; chunk < kChunks; ++chunk) (void)client.expect_kind<wire::Chunk>();
  // A burst at once and the rest at the rate, however fast the machine; one token may have been all but
  // earned before.
  CHECK(std::chrono::steady_clock::now() - began >= milliseconds{1000 * (kChunks - kBurst - 1) / kPerSecond});
}

TEST_CASE(
    "a chunk that is ready while its rate holds it comes when the rate allows it, without another word") {
  const ServerProcess server{{{"TALUS_RATES_SESSION_CHUNKS", "2"}, {"TALUS_RATES_BURST_MS", "500"}}};
  RawClient client = greeted(server.port());
  REQUIRE(client.send(get_chunks({chunk_request(1, at(0, 0, 0))})));
  (void)client.expect_kind<wire::Chunk>();
  // All is written, and nothing waits for the half second that the next chunk has to wait.
  REQUIRE(client.send(get_chunks({chunk_request(2, at(0, 0, 0))})));
  const auto second = client.receive_within(std::chrono::seconds{20});
  REQUIRE(second.has_value());
  CHECK(second->as<wire::Chunk>().id() == 2);
}

TEST_CASE("connections of one address share its rates", "[tcp]") {
  const ServerProcess server{{{"TALUS_RATES_ADDRESS_REQUESTS", "1"}, {"TALUS_RATES_BURST_MS", "20000"}}};
  RawClient first = greeted(server.port());
  // Twenty are taken at once, and one a second comes back: a minute's worth is more than both have.
  for (int i = 0; i < 20; ++i) {
    REQUIRE(first.send(ping(1)));
    (void)first.expect_kind<wire::Pong>();
  }
  first.close();
  RawClient second = greeted(server.port());
  int answered = 0;
  for (bool refused = false; !refused; ++answered) {
    REQUIRE(answered < 20);
    REQUIRE(second.send(ping(3)));
    refused = second.expect().kind() == wire::Body::Error;
  }
}

TEST_CASE("a server without memory to spare refuses connections, and takes them again when others have left",
          "[tcp]") {
  const ServerProcess server{{{"TALUS_LIMITS_MEMORY_BYTES", "75497472"},  // the least there may be
                              {"TALUS_LIMITS_HANDSHAKES_PER_ADDRESS_PER_SECOND", "1000000"},
                              {"TALUS_LIMITS_HANDSHAKES_PER_ADDRESS_BURST", "1000000"}}};
  std::vector<RawClient> clients;
  for (bool refused = false; !refused;) {
    REQUIRE(clients.size() < 250);
    clients.emplace_back(server.port());
    (void)clients.back().send(hello());
    const ReceivedFrame first = clients.back().expect();
    refused = first.kind() == wire::Body::Error;
    if (refused) {
      CHECK(first.as<wire::Error>().code() == wire::ErrorCode::overloaded);
      CHECK_THAT(first.as<wire::Error>().text()->str(), Catch::Contains("memory"));
      CHECK(first.as<wire::Error>().retry_after_ms() > 0);
    } else {
      REQUIRE(clients.back().send(view({{}, 30, 8})));
    }
  }
  CHECK(clients.back().closed());
  clients.clear();
  // The server lets go of those who left one after the other: some may be refused until then.
  std::string received = "nothing";
  const auto give_up = std::chrono::steady_clock::now() + std::chrono::seconds{60};
  while (received != "Welcome") {
    INFO("received at last: " << received);
    REQUIRE(std::chrono::steady_clock::now() < give_up);
    RawClient client{server.port()};
    (void)client.send(hello());
    const std::optional<ReceivedFrame> first = client.receive();
    received = first ? wire::EnumNameBody(first->kind()) : "the end of the connection";
    if (received == "Error") received = first->as<wire::Error>().text()->str();
  }
}

TEST_CASE("memory stays within its budget, though caches would take more") {
  constexpr std::size_t kBudget = std::size_t{128} << 20;
  // A thread's working memory counts: as many threads on every machine.
  const ServerProcess server{{{"TALUS_LIMITS_MEMORY_BYTES", std::to_string(kBudget)},
                              {"TALUS_THREADS_GENERATOR", "2"},
                              {"TALUS_THREADS_IO", "2"}}};
  RawClient client = greeted(server.port());
  constexpr std::int32_t kPatchChunks = 4;
  constexpr std::uint32_t kAtOnce = 100;
  constexpr std::int32_t kRounds = kSanitized ? 1 : 8;
  std::size_t most = 0;
  for (std::int32_t round = 0; round < kRounds; ++round) {
    std::vector<wire::ChunkRequest> requests;
    for (std::uint32_t id = 1; id <= kAtOnce; ++id) {
      requests.push_back(chunk_request(
          id, at((round * static_cast<std::int32_t>(kAtOnce) + static_cast<std::int32_t>(id)) * kPatchChunks,
                 1, 0)));
    }
    REQUIRE(client.send(get_chunks(requests)));
    for (std::uint32_t answer = 0; answer < kAtOnce; ++answer) (void)client.expect_kind<wire::Chunk>();
    most = std::max(most, server.resident_bytes());
  }
  CAPTURE(most >> 20);
  if (!kSanitized) CHECK(most < kBudget);
}
