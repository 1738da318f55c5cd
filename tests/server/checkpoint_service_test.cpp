// A checkpoint over the operators' port, and what takes it.
#include <asio/ip/tcp.hpp>
#include <catch2/catch.hpp>

#include <talus/store/store_swap.h>

#include "checkpoint_peer.h"
#include "cluster/checkpoint/from_peers.h"

namespace talus::server {
namespace {

using namespace testing;
using asio::ip::tcp;
namespace fs = std::filesystem;

/// Polls what other threads do: no event tells of it.
template <typename Condition>
bool comes_true(const Condition& condition, std::chrono::seconds patience = std::chrono::seconds{20}) {
  const auto end = std::chrono::steady_clock::now() + patience;
  while (!condition()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::yield();
  }
  return true;
}

const OnJoining kNobodyAsks = [](std::uint64_t, std::uint64_t) {};

}  // namespace

TEST_CASE("a server without keys refuses its store to every peer, and names the key to set") {
  Peer peer{7, 1U << 30U, false};
  CHECK_THAT(peer.error_with(""),
             Catch::Contains("answers 403") && Catch::Contains("access.signing_key_file"));
  CHECK_THAT(peer.error_with("any"), Catch::Contains("answers 403"));
}

TEST_CASE("a store is given for a token with the right admin alone") {
  Peer peer;
  CHECK_THAT(peer.error_with(""), Catch::Contains("answers 401"));
  CHECK_THAT(peer.error_with("wrong"), Catch::Contains("answers 401"));
  CHECK_THAT(peer.error_with(peer.signed_token({Right::read, Right::edit, Right::gateway})),
             Catch::Contains("answers 403: the token lacks the right admin"));
  CHECK(peer.error_with(peer.admin().token) == "");
  CHECK(peer.metrics.checkpoints_refused.total() == 3);
}

TEST_CASE("a joining server takes a peer's store over HTTP, and tries the next peer if one fails") {
  Peer peer;
  Peer foreign{8};
  ScratchDirectory scratch{ScratchDirectory::memory()};
  const fs::path data = scratch / "data";
  auto directory = store::DataDirectory::open_any(data);
  REQUIRE(directory.has_value());
  const WantedStore wanted{{1, 2}, peer.store.id()};
  const auto give_up = [](std::chrono::milliseconds, const Round&) { return false; };
  for (int i = 0; i < 8; ++i) {
    const auto meta = take_from_peers({{foreign.url, "http://127.0.0.1:9", peer.url}, peer.admin()}, data,
                                      wanted, kSilentLog, kNobodyAsks, give_up);
    REQUIRE(meta.has_value());
    CHECK(meta->head == peer.store.head());
  }
  REQUIRE(store::swap_in(data).has_value());
  EditStore joined{data};
  joined.database_settings.store_id = peer.store.id();
  CHECK(joined.open() == "");
  CHECK(overrides_of(joined.state()) == overrides_of(peer.store.store.state()));
}

TEST_CASE("a joiner that finds no store asks again, longer apart, and leaves nothing half taken") {
  Peer foreign{8};
  ScratchDirectory scratch{ScratchDirectory::memory()};
  std::vector<std::chrono::milliseconds> pauses;
  const auto pause = [&](std::chrono::milliseconds wait, const Round& round) {
    CHECK(round.peers == 1);
    CHECK(round.silent == 0);
    pauses.push_back(wait);
    CHECK(fs::is_empty(scratch / "talus-staging"));
    return pauses.size() < 7;
  };
  const auto meta = take_from_peers({{foreign.url}, foreign.admin()}, scratch.path(),
                                    {{1, 2}, ContentHash{9, 9}}, kSilentLog, kNobodyAsks, pause);
  REQUIRE_FALSE(meta.has_value());
  REQUIRE(pauses.size() == 7);
  CHECK(pauses.front() == std::chrono::seconds{1});
  CHECK(pauses.back() == std::chrono::seconds{30});
  CHECK_THAT(take_from_peers({{}, {}}, scratch.path(), {{1, 2}, {}}, kSilentLog, kNobodyAsks, pause).error(),
             Catch::Contains("cluster.peers: is empty"));
}

TEST_CASE("a peer that sends next to nothing is left for the next one") {
  asio::io_context io;
  tcp::acceptor acceptor{io, {asio::ip::address_v4::loopback(), 0}};
  std::thread slow{[&] {
    tcp::socket socket = acceptor.accept();
    std::error_code gone;
    asio::write(socket, asio::buffer(std::string{"HTTP/1.1 200 OK\r\nContent-Length: 1000000\r\n\r\n"}),
                gone);
    while (!gone) {
      asio::write(socket, asio::buffer("x", 1), gone);
      std::this_thread::sleep_for(std::chrono::milliseconds{10});
    }
  }};
  PeerAccess access;
  access.patience = std::chrono::seconds{2};
  const auto download = CheckpointDownload::open(
      "http://127.0.0.1:" + std::to_string(acceptor.local_endpoint().port()), access);
  REQUIRE(download.has_value());
  const auto began = std::chrono::steady_clock::now();
  std::string error;
  while (error.empty()) {
    const auto piece = (*download)->read();
    if (!piece) error = piece.error();
    REQUIRE(std::chrono::steady_clock::now() - began < std::chrono::seconds{60});
  }
  CHECK_THAT(error, Catch::Contains("Less than 16384 bytes/sec"));
  acceptor.close();
  const_cast<std::unique_ptr<CheckpointDownload>&>(*download).reset();
  slow.join();
}

TEST_CASE("if all servers have put their stores aside the one that has read most continues") {
  const AsideStore own{40, 77, 5};
  CHECK(to_string(own) == "40 77 00000005");
  CHECK(parse_aside("40 77 00000005") == own);
  for (const char* const wrong : {"", "40", "40 77", "40 77 x", "40 77 5 6", "-1 77 5", "40 77 100000000"}) {
    CHECK_FALSE(parse_aside(wrong).has_value());
  }
  const AsideStore less{39, 77, 9};
  const AsideStore more{41, 77, 1};
  CHECK(goes_on(own, {2, 0, {own, less}}, true));
  CHECK_FALSE(goes_on(own, {2, 0, {own, more}}, true));
  // As far, by number.
  CHECK(goes_on(own, {1, 0, {{40, 77, 4}}}, true));
  CHECK_FALSE(goes_on(own, {1, 0, {{40, 77, 6}}}, true));
  // Of another stream nothing can be said.
  CHECK_FALSE(goes_on(own, {1, 0, {{39, 78, 9}}}, true));
  // One has no store, or sends it to others, or refuses.
  CHECK_FALSE(goes_on(own, {3, 0, {own, less}}, false));
  // One is dead: most of all decide, later.
  CHECK_FALSE(goes_on(own, {3, 1, {own, less}}, true));
  CHECK(goes_on(own, {3, 1, {own, less}}, false));
  CHECK_FALSE(goes_on(own, {3, 2, {own}}, false));
  CHECK_FALSE(goes_on(own, {2, 1, {own}}, false));
  CHECK_FALSE(goes_on(own, {1, 1, {}}, false));
}

TEST_CASE("the third at once is refused for now") {
  Peer peer;
  peer.store.grow();
  peer.service.set_rate(262'144);
  auto first = CheckpointDownload::open(peer.url, peer.admin());
  auto second = CheckpointDownload::open(peer.url, peer.admin());
  REQUIRE(first.has_value());
  REQUIRE(second.has_value());
  CHECK_THAT(peer.error_with(peer.admin().token), Catch::Contains("answers 503: 2 servers take this store"));
  peer.service.set_rate(0);
  const auto all = [](CheckpointDownload& download) {
    std::uint64_t bytes = 0;
    for (auto piece = download.read(); piece && !piece->empty(); piece = download.read())
      bytes += piece->size();
    return bytes;
  };
  CHECK(all(**first) == (*first)->size());
  CHECK(all(**second) == (*second)->size());
  CHECK(comes_true([&] { return peer.metrics.checkpoints_open.now() == 0; }));
  CHECK(peer.error_with(peer.admin().token) == "");
}

TEST_CASE("an address that takes the store twice gives way to another") {
  Peer peer;
  peer.store.grow();
  peer.service.set_rate(262'144);
  const auto greedy = asio::ip::make_address("127.0.0.2");
  const tcp::socket first = peer.ask(greedy);
  CHECK(comes_true([&] { return peer.metrics.checkpoints_open.now() == 1; }));
  const tcp::socket second = peer.ask(greedy);
  CHECK(comes_true([&] { return peer.metrics.checkpoints_open.now() == 2; }));
  auto next = CheckpointDownload::open(peer.url, peer.admin());
  REQUIRE(next.has_value());
  CHECK(comes_true([&] { return peer.metrics.checkpoints_open.now() == 2; }));
  CHECK_THAT(peer.error_with(peer.admin().token), Catch::Contains("answers 503: 2 servers take this store"));
}

TEST_CASE("a peer that hangs up pins no checkpoint") {
  Peer peer;
  peer.service.set_rate(262'144);
  peer.store.grow();
  {
    tcp::socket gone = peer.ask();
    CHECK(comes_true([&] {
      return peer.metrics.checkpoints_open.now() == 1 || peer.metrics.checkpoints_sent.total() == 1;
    }));
    gone.close();
  }
  CHECK(comes_true([&] { return peer.metrics.checkpoints_open.now() == 0; }));
  CHECK(comes_true([&] { return peer.checkpoints() == 0; }));
}

TEST_CASE("a server that ends in the middle leaves no checkpoint and hangs nowhere") {
  for (int i = 0; i < 10; ++i) {
    Peer peer;
    peer.service.set_rate(262'144);
    tcp::socket one = peer.ask();
    tcp::socket other = peer.ask();
    if (i % 2 == 0) CHECK(comes_true([&] { return peer.metrics.checkpoints_open.now() > 0; }));
    peer.end();
    CHECK(peer.checkpoints() == 0);
  }
}

TEST_CASE("a peer that goes away in the middle is an error of one line") {
  auto peer = std::make_unique<Peer>();
  peer->service.set_rate(262'144);
  peer->store.grow();
  auto download = CheckpointDownload::open(peer->url, peer->admin());
  REQUIRE(download.has_value());
  REQUIRE((*download)->read().has_value());
  peer->end();
  std::string error;
  for (;;) {
    const auto piece = (*download)->read();
    if (!piece) error = piece.error();
    if (!piece || piece->empty()) break;
  }
  CHECK_THAT(error, Catch::StartsWith(peer->url) && Catch::Contains("the connection ended after"));
}

}  // namespace talus::server
