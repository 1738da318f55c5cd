// Tries every pool of server/limits/pools.h with one greedy flow of each kind of client that takes of it, and
// then a client of another address.
#include "../../server/limits/pools.h"

#include <array>
#include <asio/buffer.hpp>
#include <asio/local/stream_protocol.hpp>
#include <asio/read.hpp>
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

/// Requests of HTTP clients at kGreedy, whose answers are not read.
class GreedyHttp {
 public:
  void ask(std::uint16_t port, const std::string& request) {
    clients_.emplace_back(port, kGreedy).send(request);
  }

 private:
  std::deque<HttpClient> clients_;
};

std::string chunk_target(const std::string& root, std::int64_t x) {
  return root + "/0/" + std::to_string(x) + "/0/0";
}
/// A tile that takes long to draw.
std::string tile_target(const std::string& root, int x) {
  return root.substr(0, root.rfind('/')) + "/map/6/" + std::to_string(x) + "/0.png";
}

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

void try_connections_of_http() {
  ServerProcess server{{{"TALUS_LIMITS_CONNECTIONS", "8"}}, kWithHttp};
  std::deque<RawClient> greedy;
  for (int i = 0; i < 8; ++i) greedy.emplace_back(server.http_port(), kGreedy, Transport::tcp);
  HttpClient next{server.http_port()};
  CHECK(next.get("/v1/world").status == 200);
  CHECK(greedy[0].closed());
}

void try_handshakes(const std::function<std::uint16_t(ServerProcess&)>& greedy_port) {
  if (tested_transport() != Transport::tcp) return;  // tries both ports by TCP
  const ScratchDirectory scratch;
  const TestCertificate own = make_certificate(1);
  ServerProcess server{{{"TALUS_TLS_CERTIFICATE", scratch.write("certificate.pem", own.certificate)},
                        {"TALUS_TLS_KEY", scratch.write("key.pem", own.key)},
                        {"TALUS_LIMITS_HANDSHAKES_IN_FLIGHT", "8"}},
                       kWithHttp};
  const std::string begins = client_hello();
  std::deque<HttpClient> greedy;  // as sockets
  for (int i = 0; i < 8; ++i) {
    HttpClient& half_done = greedy.emplace_back(greedy_port(server), kGreedy);
    half_done.send(begins);
    std::array<char, 1> answer{};  // then the server waits for the client's part
    asio::read(half_done.socket(), asio::buffer(answer));
  }
  for (const std::uint16_t port : {greedy_port(server), server.port(), server.https_port()}) {
    REQUIRE_FALSE(TlsClient{port}.failure());
  }
  CHECK(greedy[0].closed());
}

void try_memory_of_sessions() {
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

void try_memory_of_answers() {
  const ScratchDirectory scratch;
  (void)scratch.write("index.html", "page");
  (void)scratch.write("large", std::string(std::size_t{8} << 20, 'x'));
  ServerProcess server{{{"TALUS_LIMITS_MEMORY_BYTES", "134217728"}},
                       {"--http", "127.0.0.1:0", "--web", scratch.path().string()}};
  GreedyHttp greedy;
  for (int i = 0; i < 16; ++i) greedy.ask(server.http_port(), HttpClient::request("/large"));
  for (int i = 0; i < 4; ++i) {
    HttpClient next{server.http_port()};
    CHECK(next.get("/v1/world").status == 200);
  }
}

void try_frames() {
  const ServerProcess server{{}, kWithHttp};
  std::deque<RawClient> greedy;
  for (int i = 0; i < 64; ++i) greedy.push_back(greeted(server.port(), 0, kGreedy));
  std::vector<std::byte> frames;
  for (std::uint64_t i = 0; i < 2'000; ++i) {
    const protocol::Frame frame = credit(0);
    frames.insert(frames.end(), frame.begin(), frame.end());
  }
  for (int round = 0; round < 4; ++round) {
    for (RawClient& each : greedy) (void)each.send_some(frames);
    check_served(server.port());
  }
}

void try_http_rounds() {
  ServerProcess server{{}, kWithHttp};
  std::string requests;
  for (int i = 0; i < 1'000; ++i) requests += HttpClient::request("/v1/world");
  GreedyHttp greedy;
  HttpClient next{server.http_port()};
  for (int i = 0; i < 32; ++i) {
    greedy.ask(server.http_port(), requests);
    CHECK(next.get("/v1/world").status == 200);
  }
}

void try_views() {
  const ServerProcess server{{kClassicWorld, {"TALUS_THREADS_IO", "1"}}, kWithHttp};
  std::deque<RawClient> greedy;
  for (int i = 0; i < 8; ++i) greedy.push_back(greeted(server.port(), 1, kGreedy));
  for (std::int64_t step = 0; step < 8; ++step) {
    for (RawClient& each : greedy) {
      REQUIRE(
          each.send(view({.centre = {step * 3'200, 0, 0}, .horizontal_radius = 47, .vertical_radius = 3})));
    }
  }
  RawClient next = greeted(server.port(), 1U << 20U, kNext);
  REQUIRE(next.send(view({.horizontal_radius = 1, .vertical_radius = 1, .number = 1})));
  (void)await_kind<wire::ViewComplete>(next);
}

const Settings kOneGenerator{kClassicWorld, {"TALUS_THREADS_GENERATOR", "1"}};

void try_generators_by_sessions() {
  const ServerProcess server{kOneGenerator, kWithHttp};
  std::deque<RawClient> greedy;
  for (std::int32_t i = 0; i < 4; ++i) {
    greedy.push_back(greeted(server.port(), 1, kGreedy));
    REQUIRE(greedy.back().send(
        view({.centre = {kFar * 32 * i, 0, 0}, .horizontal_radius = 47, .vertical_radius = 3})));
    (void)greedy.back().expect();
  }
  check_served(server.port());
}

void try_generators_by_maps() {
  ServerProcess server{kOneGenerator, kWithHttp};
  HttpClient next{server.http_port()};
  const std::string root = root_of(next);
  GreedyHttp greedy;
  for (int i = 0; i < 16; ++i) greedy.ask(server.http_port(), HttpClient::request(tile_target(root, i)));
  CHECK(next.get(chunk_target(root, kFar)).status == 200);
  check_served(server.port());
}

void try_begun_heights() {
  const ServerProcess server{kOneGenerator, kWithHttp};
  const auto columns = [](std::int64_t x) {
    std::vector<wire::ColumnPos> all;
    for (std::int64_t z = 0; z < 2'000; ++z) all.emplace_back(x, z * 1'000);
    return all;
  };
  std::deque<RawClient> greedy;
  for (std::int64_t i = 0; i < 8; ++i) {
    greedy.push_back(greeted(server.port(), 0, kGreedy));
    REQUIRE(greedy.back().send(get_heights(1, columns(i * 1'000'000))));
  }
  RawClient next = greeted(server.port(), 0, kNext);
  REQUIRE(next.send(get_heights(1, columns(-1'000'000))));
  (void)next.expect_kind<wire::Heights>();
}

void try_begun_maps() {
  ServerProcess server{kOneGenerator, kWithHttp};
  HttpClient next{server.http_port()};
  const std::string root = root_of(next);
  GreedyHttp greedy;
  for (int i = 0; i < 16; ++i) greedy.ask(server.http_port(), HttpClient::request(tile_target(root, i)));
  CHECK(next.get(tile_target(root, -1)).status == 200);
}

void try_refused_sessions() {
  if (tested_transport() != Transport::tcp) return;  // try_refused_http() is the same by HTTP
  const ServerProcess server{{{"TALUS_LIMITS_CONNECTIONS_PER_ADDRESS", "1"}}};
  std::deque<RawClient> greedy;
  for (int i = 0; i < 1 + 64; ++i) greedy.emplace_back(server.port(), kGreedy, Transport::tcp);
  const RawClient first{server.port(), kNext, Transport::tcp};
  RawClient second{server.port(), kNext, Transport::tcp};
  (void)second.expect_kind<wire::Error>();
}

void try_refused_http() {
  ServerProcess server{{{"TALUS_LIMITS_CONNECTIONS_PER_ADDRESS", "1"}}, kWithHttp};
  std::deque<HttpClient> greedy;
  for (int i = 0; i < 1 + 64; ++i) greedy.emplace_back(server.http_port(), kGreedy);
  const HttpClient first{server.http_port()};
  HttpClient second{server.http_port()};
  CHECK(second.read().status == 503);
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

void try_waiting_chunks_of_requests() {
  ServerProcess server{{kClassicWorld, {"TALUS_GENERATION_QUEUE_CHUNKS", "64"}}, kWithHttp};
  HttpClient next{server.http_port()};
  const std::string root = root_of(next);
  GreedyHttp greedy;
  for (std::int64_t i = 1; i <= 64; ++i) {
    greedy.ask(server.http_port(), HttpClient::request(chunk_target(root, kFar * i)));
  }
  CHECK(next.get(chunk_target(root, 0)).status == 200);
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

  explicit Editable(Settings more = {}, const std::vector<std::string>& flags = kWithHttp)
      : server{settings(std::move(more)), flags} {}
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

/// A session of the greedy flow sees more changes than it reads; one of another flow sees its own.
void try_followed_changes() {
  const Editable of;
  const ViewFields high{
      .centre = {900 * 32, 4'000, 0}, .horizontal_radius = 2, .vertical_radius = 1, .number = 1};
  std::deque<RawClient> greedy;
  for (int i = 0; i < 8; ++i) {
    greedy.push_back(of.editor(kGreedy));
    REQUIRE(greedy.back().send(view(high)));
    for (std::uint32_t id = 890; id < 900; ++id) REQUIRE(greedy.back().send(dig(id, 8)));
  }
  RawClient follower = greeted(of.server.port(), 1U << 20U, kNext);
  REQUIRE(follower.send(view(high)));
  (void)await_kind<wire::ViewComplete>(follower);
  RawClient next = of.editor(kNext);
  check_edits(next);
  const auto sees_change = [&] {
    const wire::Body kind = follower.expect().kind();
    return kind == wire::Body::Chunk || kind == wire::Body::EditBroadcast;
  };
  while (!sees_change()) continue;
}

void try_connections_of_operators() {
  ServerProcess server{{}, {"--admin", "127.0.0.1:0"}};
  HttpClient next{server.admin_port()};
  REQUIRE(next.get("/-/healthy").status == 200);
  std::deque<HttpClient> greedy;
  for (int i = 0; i < 33; ++i) {
    greedy.emplace_back(server.admin_port(), kGreedy);
    REQUIRE(greedy.back().get("/-/healthy").status == 200);
  }
  CHECK(next.get("/-/healthy").status == 200);
}

void try_checkpoints() {
  const ScratchDirectory secrets;
  Editable of{{{"TALUS_ACCESS_SECRET_FILE", secrets.write("secret", "0123456789abcdef\n")},
               {"TALUS_ACCESS_SECRET_RIGHTS", "read,edit,admin"},
               {"TALUS_RATES_CHECKPOINT_BYTES", "262144"},
               {"TALUS_RATES_SESSION_VOXELS", "0"},
               {"TALUS_RATES_ADDRESS_VOXELS", "0"}},
              {"--http", "127.0.0.1:0", "--admin", "127.0.0.1:0"}};
  RawClient editor = of.editor(kGreedy);
  for (std::uint32_t id = 1; id <= 100; ++id) {
    REQUIRE(editor.send(protocol::make_frame([&](auto& builder) {
      std::vector<wire::VoxelWrite> writes;
      for (std::int64_t i = 0; i < 2'000; ++i) {
        writes.emplace_back(wire::Voxel{id * 7 * i % 224, 4'000 + i % 32, i * i % 224}, std::uint16_t{2});
      }
      return wire::CreateEdit(builder, id, builder.CreateVectorOfStructs(writes), id);
    })));
    (void)await_kind<wire::EditResult>(editor);
  }
  const std::string request =
      HttpClient::request("/store/checkpoint", "Authorization: Bearer 0123456789abcdef\r\n");
  std::deque<HttpClient> clients;
  for (const std::uint32_t from : {kGreedy, kGreedy, kNext}) {
    clients.emplace_back(of.server.admin_port(), from).send(request);
    CHECK_THAT(clients.back().read_head(), Catch::StartsWith("HTTP/1.1 200 "));
  }
}

void try_commands() {
  const Editable of;
  asio::io_context io;
  std::deque<asio::local::stream_protocol::socket> greedy;
  const asio::local::stream_protocol::endpoint socket{(of.scratch / "data" / "talusd.socket").string()};
  for (int i = 0; i < 4; ++i) {
    auto& client = greedy.emplace_back(io);
    std::error_code absent;  // until the server has opened it
    for (;;) {
      client.connect(socket, absent);
      if (!absent) break;
      client.close();
    }
  }
  const ProgramResult next =
      run_talusd({"store", "backup", of.scratch / "backup", "--data", of.scratch / "data"});
  INFO(next.err);
  CHECK(next.status == 0);
}

using Trials = std::map<std::string_view, std::map<server::PoolUsers, std::function<void()>>>;

const Trials& trials() {
  using enum server::PoolUsers;
  static const Trials all{
      {"connections", {{kSessions, try_connections}, {kHttp, try_connections_of_http}}},
      {"handshakes",
       {{kSessions, [] { try_handshakes(std::mem_fn(&ServerProcess::port)); }},
        {kHttp, [] { try_handshakes(std::mem_fn(&ServerProcess::https_port)); }}}},
      {"refusals being sent", {{kSessions, try_refused_sessions}, {kHttp, try_refused_http}}},
      {"memory: sessions, frames, WebSocket buffers, HTTP answers",
       {{kSessions, try_memory_of_sessions}, {kHttp, try_memory_of_answers}}},
      {"io threads: frames, HTTP rounds, handshakes", {{kSessions, try_frames}, {kHttp, try_http_rounds}}},
      {"io threads: Views", {{kSessions, try_views}}},
      {"generators: chunks, heights, map tiles",
       {{kSessions, try_generators_by_sessions}, {kHttp, try_generators_by_maps}}},
      {"pieces begun", {{kSessions, try_begun_heights}, {kHttp, try_begun_maps}}},
      {"chunks that wait for a generator",
       {{kSessions, try_waiting_chunks}, {kHttp, try_waiting_chunks_of_requests}}},
      {"edits that wait for the log", {{kSessions, try_waiting_edits}}},
      {"editors", {{kSessions, try_editors}}},
      {"chunks never edited before", {{kSessions, try_new_chunks}}},
      {"followed changes", {{kSessions, try_followed_changes}}},
      {"operators' connections", {{kOperators, try_connections_of_operators}}},
      {"checkpoints over their port", {{kOperators, try_checkpoints}}},
      {"`talusd store` commands", {{kCommands, try_commands}}},
  };
  return all;
}

}  // namespace

TEST_CASE("no pool is one flow's while another wants some") {
  CHECK(trials().size() == server::kPools.size());
  for (const server::Pool& pool : server::kPools) {
    const auto of_pool = trials().find(pool.name);
    CAPTURE(pool.name);
    REQUIRE(of_pool != trials().end());
    for (const auto user : {server::kSessions, server::kHttp, server::kOperators, server::kCommands}) {
      const auto trial = of_pool->second.find(user);
      REQUIRE((trial != of_pool->second.end()) == ((pool.users & user) != 0));
      const bool runs = user == server::kSessions || tested_transport() == Transport::tcp;
      if (trial == of_pool->second.end() || !runs) continue;
      DYNAMIC_SECTION(pool.name << ", users " << static_cast<int>(user)) {
        trial->second();
      }
    }
  }
}

TEST_CASE("a flow that holds all connections through a proxy leaves room for others behind it", "[tcp]") {
  ServerProcess server{{{"TALUS_LIMITS_CONNECTIONS", "8"}, {"TALUS_PROXIES", "127.0.0.1"}}, kWithHttp};
  const auto fields = [](const std::string& client) { return "X-Forwarded-For: " + client + "\r\n"; };
  const std::string upgrade =
      "Connection: Upgrade\r\nUpgrade: websocket\r\nSec-WebSocket-Version: 13\r\n"
      "Sec-WebSocket-Key: AAAAAAAAAAAAAAAAAAAAAA==\r\n";
  std::deque<HttpClient> greedy;
  for (int i = 0; i < 8; ++i) {
    greedy.emplace_back(server.http_port());
    CHECK(greedy.back().get("/v1/stream", fields("192.0.2.1") + upgrade).status == 101);
  }
  for (int i = 0; i < 3; ++i) {
    HttpClient next{server.http_port()};
    CHECK(next.get("/v1/world", fields("192.0.2.2")).status == 200);
    CHECK(next.get("/v1/stream", fields("192.0.2.3") + upgrade).status == 101);
  }
}
