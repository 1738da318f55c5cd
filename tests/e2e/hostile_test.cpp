// Clients that mean harm, and a good one that must not notice.
// siege.h says how long the siege takes.
#include <signal.h>

#include <catch2/catch.hpp>
#include <chrono>
#include <random>

#include "messages.h"
#include "raw_client.h"
#include "seed_of_run.h"
#include "server_process.h"
#include "siege.h"

using namespace talus;
using namespace talus::e2e;

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kMebibyte = std::size_t{1} << 20;

protocol::Frame bytes_of(std::initializer_list<unsigned> values) {
  protocol::Frame frame;
  for (const unsigned value : values) frame.push_back(static_cast<std::byte>(value));
  return frame;
}

protocol::Frame random_bytes(std::mt19937& random, std::size_t count) {
  protocol::Frame bytes(count);
  for (std::byte& each : bytes) each = static_cast<std::byte>(random());
  return bytes;
}

wire::ErrorCode closing_code(RawClient& client) {
  const ReceivedFrame received = client.expect();
  const wire::ErrorCode code = received.as<wire::Error>().code();
  CHECK(client.closed());
  return code;
}

/// One of the ways in which a connection can be bad; the connection ends with the call, but for what the
/// caller keeps.
void attack(std::mt19937& random, std::uint16_t port) {
  RawClient client{port};
  const auto whole = hello();
  switch (random() % 6) {
    case 0:
      (void)client.send(random_bytes(random, random() % 5000));
      break;
    case 1:
      (void)client.send(std::span{whole}.first(random() % whole.size()));
      break;
    case 2:
      (void)client.send(hello({.oldest = 900, .newest = 1000}));
      break;
    case 3:
      (void)client.send(bytes_of({0xFF, 0xFF, 0xFF, 0x7F}));
      break;
    case 4:
      (void)client.send(whole);
      (void)client.send(random_bytes(random, random() % 5000));
      break;
    default: {
      // A real message with a byte or two changed, after a real Hello.
      protocol::Frame broken = get_chunks({chunk_request(1, at(1, 2, 3)), chunk_request(2, at(4, 5, 6))});
      broken[protocol::kPrefixBytes + random() % (broken.size() - protocol::kPrefixBytes)] =
          static_cast<std::byte>(random());
      (void)client.send(whole);
      (void)client.send(broken);
      break;
    }
  }
  if (random() % 2 == 0) (void)client.receive_within(std::chrono::milliseconds{1});
}

/// Asks for a chunk never asked for before, and gets it.
void check_served(RawClient& client, std::uint32_t id, std::uint64_t& taken_bytes) {
  const auto place = static_cast<std::int32_t>(id);
  REQUIRE(client.send(get_chunks({chunk_request(id, at(place % 1000, 0, place / 1000))})));
  const ReceivedFrame received = client.expect();
  REQUIRE(received.as<wire::Chunk>().id() == id);
  taken_bytes += received.bytes();
  REQUIRE(client.send(credit(taken_bytes)));
}

}  // namespace

TEST_CASE("a huge length closes the connection before anything is allocated for it") {
  const ServerProcess server;
  RawClient client{server.port()};
  REQUIRE(client.send(bytes_of({0xF0, 0xFF, 0xFF, 0xFF})));
  CHECK(closing_code(client) == wire::ErrorCode::too_large);
}

TEST_CASE("before Welcome no frame is larger than a Hello can be") {
  const ServerProcess server{{{"TALUS_LIMITS_FRAME_BYTES", "16777216"}}};
  RawClient client{server.port()};
  REQUIRE(client.send(bytes_of({0xFD, 0x3F, 0, 0})));  // 16,385 bytes with the length
  CHECK(closing_code(client) == wire::ErrorCode::too_large);
}

TEST_CASE("a frame over the limit of Welcome closes the connection") {
  const ServerProcess server{{{"TALUS_LIMITS_FRAME_BYTES", "4096"}}};
  RawClient client = greeted(server.port());
  REQUIRE(client.send(cancel(std::vector<std::uint32_t>(1025, 1))));
  CHECK(closing_code(client) == wire::ErrorCode::too_large);
}

TEST_CASE("a length too small for any message closes the connection") {
  const ServerProcess server;
  RawClient client{server.port()};
  REQUIRE(client.send(bytes_of({0, 0, 0, 0})));
  CHECK(closing_code(client) == wire::ErrorCode::malformed);
}

TEST_CASE("an invalid frame closes the connection") {
  const ServerProcess server;
  RawClient client{server.port()};
  REQUIRE(client.send(bytes_of({8, 0, 0, 0, 0xFF, 0xFF, 0xFF, 0xFF, 1, 2, 3, 4})));
  CHECK(closing_code(client) == wire::ErrorCode::malformed);
}

TEST_CASE("a frame cut off by the end of its connection harms no other client") {
  const ServerProcess server;
  {
    RawClient cut{server.port()};
    const auto whole = hello();
    REQUIRE(cut.send(std::span{whole}.first(whole.size() / 2)));
  }
  (void)greeted(server.port());
}

TEST_CASE("a client that sends requests and reads nothing is read no further, and dropped") {
  // Long enough for a server that reads on to take more than the bound below.
  const ServerProcess server{{{"TALUS_LIMITS_WRITE_TIMEOUT_MS", "2000"}}};
  RawClient client = greeted(server.port());
  protocol::Frame flood;
  for (std::uint64_t nonce = 0; flood.size() < 64 * 1024; ++nonce) {
    const auto one = ping(nonce);
    flood.insert(flood.end(), one.begin(), one.end());
  }
  // The kernel's buffers at both ends and both ways, and what the server answers before they are full.
  constexpr std::size_t kMaxTaken = 32 * kMebibyte;
  std::size_t taken = 0;
  // A whole flood at a time, so that every frame is right.
  while (taken < kMaxTaken) {
    const auto sent = client.send_some(std::span{flood}.subspan(taken % flood.size()));
    if (!sent) break;
    taken += *sent;
  }
  CHECK(taken < kMaxTaken);
  (void)greeted(server.port());
}

TEST_CASE("under siege a good client is served and memory stays in bounds") {
  constexpr std::size_t kSilent = 500;
  allow_many_sockets();
  ServerProcess server{{{"TALUS_LIMITS_CONNECTIONS_PER_ADDRESS", "700"},
                        {"TALUS_LIMITS_HANDSHAKES_PER_ADDRESS_PER_SECOND", "100000"},
                        {"TALUS_LIMITS_HANDSHAKES_PER_ADDRESS_BURST", "100000"},
                        {"TALUS_THREADS_GENERATOR", "2"},
                        {"TALUS_THREADS_IO", "2"},
                        {"TALUS_CACHE_CHUNK_BYTES", std::to_string(16 * kMebibyte)},
                        {"TALUS_CACHE_PATCH_BYTES", std::to_string(32 * kMebibyte)},
                        {"TALUS_LOG_LEVEL", "error"}}};
  const std::uint64_t seed = seed_of_run();
  CAPTURE(seed);
  std::mt19937 random{seed};
  RawClient good = greeted(server.port());
  std::uint32_t asked = 0;
  std::uint64_t taken_bytes = 0;
  check_served(good, ++asked, taken_bytes);
  const std::size_t before = server.resident_bytes();

  std::vector<RawClient> silent;
  for (std::size_t i = 0; i < kSilent; ++i) silent.emplace_back(server.port());
  std::size_t most = 0;
  const auto end = Clock::now() + siege_time();
  while (Clock::now() < end) {
    for (int bad = 0; bad < 10; ++bad) attack(random, server.port());
    check_served(good, ++asked, taken_bytes);
    most = std::max(most, server.resident_bytes());
  }
  CHECK(asked > 10);
  // Both caches, 32 KiB a silent connection, and as much again for what the allocator does not give back.
  const std::size_t bound = before + 2 * (16 * kMebibyte + 32 * kMebibyte + kSilent * 32 * 1024);
  if (!kSanitized) CHECK(most < bound);
  server.signal(SIGTERM);
  silent.clear();
  good.close();
  CHECK(server.wait().status == 0);
}
