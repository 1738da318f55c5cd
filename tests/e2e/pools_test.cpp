// Tries every pool of server/limits/pools.h with one greedy flow and then a client of another address.
#include "../../server/limits/pools.h"

#include <catch2/catch.hpp>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "certificates.h"
#include "http_client.h"
#include "messages.h"
#include "raw_client.h"
#include "scratch_directory.h"
#include "server_process.h"
#include "tls_client.h"

using namespace talus;
using namespace talus::e2e;

namespace {

constexpr std::uint32_t kGreedy = kLoopback + 1;
constexpr std::uint32_t kNext = kLoopback + 2;

constexpr std::int32_t kFar = 1'000;  // chunks

/// Says Hello and gets a chunk.
void check_served(std::uint16_t port) {
  RawClient client = greeted(port, 0, kNext);
  REQUIRE(client.send(get_chunks({chunk_request(1, at(0, 0, 0))})));
  (void)client.expect_kind<wire::Chunk>();
}

/// Drops frames of other kinds.
template <typename Table>
ReceivedFrame await_kind(RawClient& client) {
  for (;;) {
    ReceivedFrame frame = client.expect();
    if (frame.kind() == wire::BodyTraits<Table>::enum_value) return frame;
    if (frame.kind() == wire::Body::Error) FAIL(frame.as<wire::Error>().text()->str());
  }
}

void try_connections() {
  const ServerProcess server{{{"TALUS_LIMITS_CONNECTIONS", "8"}}, kWithHttp};
  std::deque<RawClient> greedy;
  for (int i = 0; i < 8; ++i) greedy.push_back(greeted(server.port(), 0, kGreedy));
  REQUIRE(greedy[0].send(ping(1)));
  (void)greedy[0].expect_kind<wire::Pong>();
  check_served(server.port());
  // The one that sent nothing for longest.
  const ReceivedFrame told = greedy[1].expect();
  CHECK(told.as<wire::Error>().code() == wire::ErrorCode::overloaded);
  CHECK(told.as<wire::Error>().retry_after_ms() > 0);
  CHECK(greedy[1].closed());
  REQUIRE(greedy[2].send(ping(2)));
  (void)greedy[2].expect_kind<wire::Pong>();
}

void try_handshakes() {
  if (tested_transport() != Transport::tcp) return;  // tries both ports by TCP
  const ScratchDirectory scratch;
  const TestCertificate own = make_certificate(1);
  ServerProcess server{{{"TALUS_TLS_CERTIFICATE", scratch.write("certificate.pem", own.certificate)},
                        {"TALUS_TLS_KEY", scratch.write("key.pem", own.key)},
                        {"TALUS_LIMITS_HANDSHAKE_TIMEOUT_MS", "3600000"},
                        {"TALUS_LIMITS_HANDSHAKES_IN_FLIGHT", "8"}},
                       kWithHttp};
  std::deque<RawClient> greedy;
  for (int i = 0; i < 8; ++i) greedy.emplace_back(server.port(), kGreedy, Transport::tcp);
  REQUIRE_FALSE(TlsClient{server.port()}.failure());
  REQUIRE_FALSE(TlsClient{server.https_port()}.failure());
  CHECK(greedy[0].closed());
}

void try_memory() {
  const ServerProcess server{{kClassicWorld,
                              {"TALUS_LIMITS_MEMORY_BYTES", "75497472"},
                              {"TALUS_THREADS_GENERATOR", "1"},
                              {"TALUS_THREADS_IO", "1"}},
                             kWithHttp};
  // Each wants a large View, and gives no credit. In all they would hold more than the budget.
  std::deque<RawClient> greedy;
  for (int i = 0; i < 64; ++i) greedy.push_back(greeted(server.port(), 1, kGreedy));
  std::int64_t x = 0;
  for (RawClient& each : greedy) {
    const VoxelPos centre{x += std::int64_t{kFar} * 32, 0, 0};
    if (!each.send(view({.centre = centre, .horizontal_radius = 47, .vertical_radius = 3}))) continue;
    if (each.send(ping(1))) (void)each.receive();
  }
  for (int i = 0; i < 4; ++i) (void)greeted(server.port(), 0, kNext);
}

void try_waiting_chunks() {
  const ServerProcess server{{kClassicWorld, {"TALUS_GENERATION_QUEUE_CHUNKS", "64"}}, kWithHttp};
  RawClient greedy = greeted(server.port(), 0, kGreedy);
  std::vector<wire::ChunkRequest> requests;
  for (std::int32_t i = 0; i < 1'000; ++i) {
    requests.push_back(chunk_request(static_cast<std::uint32_t>(i) + 1, at(kFar * i, 0, 0)));
  }
  REQUIRE(greedy.send(get_chunks(requests)));
  (void)greedy.expect();
  check_served(server.port());
}

protocol::Frame attach() {
  return protocol::make_frame([](auto& builder) { return wire::CreateAttach(builder); });
}

/// An edit high above the land, in `chunks` chunks of its own.
protocol::Frame dig(std::uint32_t id, std::int64_t chunks = 1) {
  return protocol::make_frame([&](auto& builder) {
    std::vector<wire::VoxelWrite> writes;
    for (std::int64_t z = 0; z < chunks; ++z) {
      writes.emplace_back(wire::Voxel{std::int64_t{id} * 32, 4'000, z * 32}, std::uint16_t{2});
    }
    return wire::CreateEdit(builder, id, builder.CreateVectorOfStructs(writes), id);
  });
}

struct Editable {
  ScratchDirectory scratch;
  ServerProcess server;

  explicit Editable(Settings more = {}) : server{settings(std::move(more)), kWithHttp} {}
  [[nodiscard]] Settings settings(Settings more) const {
    more.merge(Settings{
        kClassicWorld, {"TALUS_DATA", scratch / "data"}, {"TALUS_ACCESS_WITHOUT_TOKEN", "read,edit"}});
    return more;
  }
  [[nodiscard]] RawClient editor(std::uint32_t from) const {
    RawClient client = greeted(server.port(), 0, from);
    REQUIRE(client.send(attach()));
    (void)await_kind<wire::Attached>(client);
    return client;
  }
};

void check_edits(RawClient& client) {
  REQUIRE(client.send(dig(900)));
  (void)await_kind<wire::EditResult>(client);
}

void try_waiting_edits() {
  const Editable of;
  std::deque<RawClient> greedy;
  for (int i = 0; i < 5; ++i) {
    greedy.push_back(of.editor(kGreedy));
    for (std::uint32_t id = 1; id <= 64; ++id) REQUIRE(greedy.back().send(dig(id)));
  }
  RawClient next = of.editor(kNext);
  check_edits(next);
}

void try_editors() {
  const Editable of{{{"TALUS_RATES_ADDRESS_EDITORS", "1"}}};
  std::deque<RawClient> greedy;
  for (bool refused = false; !refused;) {
    greedy.push_back(greeted(of.server.port(), 0, kGreedy));
    REQUIRE(greedy.back().send(attach()));
    refused = greedy.back().expect().kind() == wire::Body::Error;
  }
  CHECK(greedy.size() == 9);  // those of eight hours, and one more
  (void)of.editor(kNext);
}

void try_new_chunks() {
  const Editable of{{{"TALUS_RATES_ADDRESS_NEW_CHUNKS", "1"}}};
  RawClient greedy = of.editor(kGreedy);
  for (std::uint32_t id = 1;; ++id) {
    REQUIRE(id < 1'000);
    REQUIRE(greedy.send(dig(id, 64)));
    if (greedy.expect().kind() == wire::Body::Error) break;
  }
  RawClient next = of.editor(kNext);
  check_edits(next);
}

}  // namespace

TEST_CASE("no pool is one flow's while another wants some") {
  const std::map<std::string_view, std::function<void()>> trials{
      {"connections", try_connections},
      {"handshakes", try_handshakes},
      {"memory of sessions, HTTP answers", try_memory},
      {"chunks that wait for a generator", try_waiting_chunks},
      {"edits that wait for the log", try_waiting_edits},
      {"editors", try_editors},
      {"chunks never edited before", try_new_chunks},
  };
  CHECK(trials.size() == server::kPools.size());
  for (const server::Pool& pool : server::kPools) {
    DYNAMIC_SECTION(pool.name) {
      const auto trial = trials.find(pool.name);
      REQUIRE(trial != trials.end());
      trial->second();
    }
  }
}

TEST_CASE("connections that idle over HTTP give way too", "[tcp]") {
  ServerProcess server{{{"TALUS_LIMITS_CONNECTIONS", "8"}}, kWithHttp};
  std::deque<RawClient> greedy;
  for (int i = 0; i < 8; ++i) greedy.emplace_back(server.http_port(), kGreedy, Transport::tcp);
  HttpClient next{server.http_port()};
  CHECK(next.get("/v1/world").status == 200);
  CHECK(greedy[0].closed());
}
