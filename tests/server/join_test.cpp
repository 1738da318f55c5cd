// What a server of a cluster does with the store that it finds, and where it gets one that it has not.
#include <deque>
#include <fstream>
#include <set>

#include <catch2/catch.hpp>

#include <talus/store/read_only_store.h>

#include "checkpoint_peer.h"
#include "cluster/join/prepare_store.h"
#include "cluster/join/start_plan.h"
#include "cluster/message.h"
#include "cluster/server_number.h"
#include "sealed_again.h"

namespace talus::server::join {
namespace {

using namespace testing;
using Kind = StartPlan::Kind;

constexpr std::int64_t kMade = 77;  // when the stream was

/// Of a scripted stream, from its second one on.
store::Bytes message_of(std::uint64_t sequence) {
  return {std::byte{1}, static_cast<std::byte>(sequence), static_cast<std::byte>(sequence >> 8U)};
}
store::StreamPlace place_at(std::uint64_t sequence, std::int64_t created_ns = kMade) {
  return {sequence, created_ns, 0, cluster::hash_of_message(message_of(sequence))};
}

store::StoreMeta store_at(std::uint64_t sequence, std::int64_t created_ns = kMade) {
  store::StoreMeta meta;
  meta.store_id = {3, 4};
  meta.head.position = 100;
  meta.stream = {sequence, created_ns};
  return meta;
}

StartPlan plan(std::optional<store::StoreMeta> local, StreamState stream, bool from_nothing = true,
               bool has_peers = true) {
  return plan_start({local, stream, from_nothing, has_peers, 0, {}});
}

/// A stream of one process.
class ScriptedStream final : public LogStream {
 public:
  struct Script {
    StreamState state{1, 1, kMade};
    std::optional<store::Bytes> first;
    std::deque<StreamFailure> failures;  // of state(), one after the other
    bool lost_end = false;               // and went on: its messages are others than those of the stores
  };
  explicit ScriptedStream(Script& script) : script_{script} {}

  tl::expected<std::uint64_t, StreamFailure> publish(std::span<const std::byte>) override { return {}; }
  tl::expected<std::optional<StreamMessage>, StreamFailure> next(std::uint64_t after, TimePoint) override {
    if (after > 0) return StreamMessage{after + 1, message_of(after + (script_.lost_end ? 2 : 1))};
    if (!script_.first) return tl::unexpected{StreamFailure{StreamFailure::Kind::gone, "gone"}};
    return StreamMessage{1, *script_.first};
  }
  tl::expected<StreamState, StreamFailure> state() override {
    if (script_.failures.empty()) return script_.state;
    const StreamFailure failure = script_.failures.front();
    script_.failures.pop_front();
    return tl::unexpected{failure};
  }
  tl::expected<std::int64_t, StreamFailure> time_of(std::uint64_t) override { return 0; }
  void wake() override {}
  void stop() override {}

 private:
  Script& script_;
};

store::Bytes genesis(ContentHash id, ContentHash world = {1, 2}, std::uint64_t position = 0) {
  cluster::Genesis genesis;
  genesis.identity = {id, world};
  genesis.head.position = position;
  genesis.head.revision = position;
  return *cluster::encode(genesis);
}

/// A server that starts.
struct Joiner {
  ScratchDirectory scratch{ScratchDirectory::memory()};
  fs::path path = scratch / "data";
  ScriptedStream::Script script;
  std::optional<ContentHash> id;
  Peers peers;
  std::vector<std::optional<AsideStore>> shown;
  int pauses = 0;
  int patience = 3;

  /// The error; empty: the store is ready.
  std::string start() {
    auto directory = store::DataDirectory::open_member(path, {1, 2});
    if (!directory) return directory.error();
    const auto prepared =
        prepare_store({*directory,
                       {1, 2},
                       id,
                       peers,
                       [this](ContentHash wanted) -> tl::expected<std::unique_ptr<LogStream>, std::string> {
                         opened = wanted;
                         return std::make_unique<ScriptedStream>(script);
                       },
                       kSilentLog,
                       [](std::uint64_t, std::uint64_t) {},
                       [this](std::chrono::milliseconds) { return ++pauses < patience; },
                       [this](const std::optional<AsideStore>& aside) { shown.push_back(aside); },
                       std::chrono::milliseconds{0}});
    if (!prepared) {
      CHECK(prepared.error().find('\n') == std::string::npos);
      return prepared.error();
    }
    CHECK(directory->store_id() == opened);
    return "";
  }
  [[nodiscard]] std::optional<store::StoreMeta> meta() const {
    const auto store = store::ReadOnlyStore::open(path);
    return store ? std::optional{(*store)->meta()} : std::nullopt;
  }
  [[nodiscard]] bool kept_the_old_one() const { return fs::exists(path / "rejoined-1"); }

  ContentHash opened;
};

/// The same store as the peer's, as it was earlier.
void copy_store(CheckpointStore& from, const fs::path& to) {
  fs::create_directories(to);
  REQUIRE(from.store.database().checkpoint(to / "db").has_value());
  fs::copy_file(from.path / "store.toml", to / "store.toml");
  fs::copy_file(from.path / "acknowledged", to / "acknowledged");
}

}  // namespace

TEST_CASE("a server starts with what it has, from the stream alone, from a peer, or not") {
  CHECK(plan(store_at(5), {1, 5, kMade}).kind == Kind::as_it_is);
  CHECK(plan(store_at(5), {6, 5, kMade}).kind ==
        Kind::as_it_is);  // the stream has forgotten all that it read
  CHECK(plan(store_at(5), {6, 9, kMade}).kind == Kind::as_it_is);
  CHECK(plan(store_at(5), {7, 9, kMade}).kind == Kind::from_peer);
  CHECK(plan(std::nullopt, {1, 9, kMade}).kind == Kind::from_stream);
  CHECK(plan(std::nullopt, {1, 9, kMade}, false).kind == Kind::from_peer);
  CHECK_FALSE(plan(std::nullopt, {1, 9, kMade}, false).may_do_without);
}

TEST_CASE("a server that lacks many messages takes a checkpoint, if a peer has one") {
  constexpr std::uint64_t kMany = 20'000;
  const StreamState stream{1, kMany, kMade, kMany * 150};
  CHECK(plan(std::nullopt, stream).kind == Kind::from_peer);
  CHECK(plan(std::nullopt, stream).may_do_without);
  CHECK(plan(std::nullopt, stream, true, false).kind == Kind::from_stream);
  CHECK(plan(store_at(5), stream).kind == Kind::from_peer);
  CHECK(plan(store_at(5), stream).may_do_without);
  CHECK(plan(store_at(5), stream, true, false).kind == Kind::as_it_is);
  CHECK(plan(store_at(kMany - 1'000), stream).kind == Kind::as_it_is);
  // Few messages full of pastes are as many edits.
  CHECK(plan(std::nullopt, {1, 1'000, kMade, 1'000 * 150}).kind == Kind::from_stream);
  CHECK(plan(std::nullopt, {1, 1'000, kMade, 1'000 * 100'000}).kind == Kind::from_peer);
}

TEST_CASE("the larger a store is, the more messages are read before it is taken anew") {
  constexpr std::uint64_t kMegabyte = 1 << 20;
  // 150 us a message against one second and 32 MiB/s.
  CHECK_FALSE(checkpoint_is_quicker(6'000, 0, 0));
  CHECK(checkpoint_is_quicker(7'000, 0, 0));
  CHECK_FALSE(checkpoint_is_quicker(50'000, 0, 320 * kMegabyte));
  CHECK(checkpoint_is_quicker(80'000, 0, 320 * kMegabyte));
  CHECK_FALSE(checkpoint_is_quicker(2'000'000, 0, 10'240 * kMegabyte));
  CHECK(checkpoint_is_quicker(2'200'000, 0, 10'240 * kMegabyte));
  const StreamState stream{1, 100'000, kMade, 100'000 * 100};
  const auto behind = [&](std::uint64_t bytes) {
    return plan_start({store_at(50'000), stream, true, true, bytes, {}}).kind;
  };
  CHECK(behind(64 * kMegabyte) == Kind::from_peer);
  CHECK(behind(1'024 * kMegabyte) == Kind::as_it_is);
}

TEST_CASE("a start that a person has to decide on is refused by name") {
  CHECK_THAT(plan(std::nullopt, {1, 0, kMade}).reason, Catch::Contains("talusd cluster init"));
  // A store of one machine where NATS has no stream: what has edits must not begin a new world.
  CheckpointStore alone;
  Joiner joiner;
  copy_store(alone, joiner.path);
  joiner.script.failures = {{StreamFailure::Kind::refused, "NATS has no stream"}};
  CHECK_THAT(joiner.start(), Catch::Contains("talusd store join-cluster") && !Catch::Contains("init"));
  CHECK_THAT(plan(store_at(0), {1, 5, kMade}).reason, Catch::Contains("talusd store join-cluster"));
  for (const auto& refused : {plan(store_at(5), {1, 9, kMade + 1}), plan(store_at(5), {1, 4, kMade})}) {
    CHECK(refused.kind == Kind::refused);
    CHECK_THAT(refused.reason, Catch::Contains("talusd store fork"));
  }
  // Not even a store that is wrong is given up for a stream that is another.
  CHECK(plan_start({store_at(5), {1, 9, kMade + 1}, true, true, 0, "S differs"}).kind == Kind::refused);
  CHECK(plan_start({store_at(5), {1, 9, kMade}, true, true, 0, "S differs"}).kind == Kind::from_peer);
}

TEST_CASE("an empty disk begins from a stream that goes back to nothing, and only of this store and world") {
  Joiner joiner;
  CHECK_THAT(joiner.start(), Catch::Contains("cluster.peers: is empty"));  // of which store?
  joiner.id = ContentHash{8, 8};
  joiner.script.first = genesis({8, 8}, {1, 3});
  CHECK_THAT(joiner.start(), Catch::Contains("give all servers of a cluster the same --world"));
  joiner.script.first = genesis({8, 9});
  CHECK_THAT(joiner.start(), Catch::Contains("the stream is of store"));
  joiner.script.first = of_newer_format(genesis({8, 8}));
  CHECK_THAT(joiner.start(), Catch::Contains("the stream's first message: it has format 9") &&
                                 Catch::EndsWith("this talusd reads up to 1; upgrade it"));
  CHECK_FALSE(fs::exists(joiner.path / "store.toml"));
  joiner.script.first = genesis({8, 8});
  CHECK(joiner.start() == "");
  CHECK(joiner.opened == ContentHash{8, 8});
  CHECK(store::read_store_identity(joiner.path / "store.toml")->store_id == ContentHash{8, 8});
}

TEST_CASE("an empty disk never begins empty if the cluster's store is not") {
  Joiner joiner;
  joiner.id = ContentHash{8, 8};
  joiner.script.first = genesis({8, 8}, {1, 2}, 5);
  CHECK_THAT(joiner.start(), Catch::Contains("cluster.peers"));
  joiner.script.first.reset();
  joiner.script.state = {40, 90, kMade};
  CHECK_THAT(joiner.start(), Catch::Contains("cluster.peers"));
  joiner.peers.urls = {"http://127.0.0.1:9"};
  CHECK(joiner.start() == "joining was given up");
  CHECK(joiner.pauses == 3);
  CHECK_FALSE(fs::exists(joiner.path / "store.toml"));
}

TEST_CASE("an empty disk takes a peer's store, also if no store is named") {
  Peer peer;
  peer.store.enter(place_at(60));
  Joiner joiner;
  joiner.script.state = {40, 90, kMade};
  joiner.peers = {{peer.url}, peer.admin()};
  SECTION("by its id") {
    joiner.id = peer.store.id();
  }
  SECTION("whichever it is") {}
  SECTION("in place of one without entries") {
    REQUIRE(store::DataDirectory::open(joiner.path, {1, 2}).has_value());
  }
  CHECK(joiner.start() == "");
  CHECK(joiner.meta()->head == peer.store.head());
  CHECK(joiner.meta()->stream == place_at(60));
  CHECK_FALSE(joiner.kept_the_old_one());
  CHECK(joiner.start() == "");  // and again, as it is
}

TEST_CASE("a peer's store is not taken if it is in no cluster, of another stream, or too old itself") {
  Peer peer;
  Joiner joiner;
  joiner.id = peer.store.id();
  joiner.script.state = {40, 90, kMade};
  joiner.peers = {{peer.url}, peer.admin()};
  SECTION("in no store") {}
  SECTION("another") {
    peer.store.enter(place_at(60, kMade + 1));
  }
  SECTION("too old") {
    peer.store.enter(place_at(38));
  }
  CHECK(joiner.start() == "joining was given up");
  CHECK_FALSE(fs::exists(joiner.path / "store.toml"));
}

TEST_CASE("a store that was away for too long is replaced, and one that is wrong is kept aside") {
  Peer peer;
  peer.store.enter(place_at(20));
  Joiner joiner;
  joiner.id = peer.store.id();
  joiner.peers = {{peer.url}, peer.admin()};
  copy_store(peer.store, joiner.path);
  std::mt19937_64 random{11};
  (void)peer.store.editor.edit(peer.store.store, random_edit(random));
  peer.store.enter(place_at(60));
  SECTION("away") {
    joiner.script.state = {40, 90, kMade};
    CHECK(joiner.start() == "");
    CHECK(joiner.kept_the_old_one());  // nobody can tell any more whether the other has all that it had
  }
  SECTION("wrong") {
    joiner.script.state = {1, 90, kMade};
    REQUIRE(want_rejoin(joiner.path, "S differs").has_value());
    CHECK(joiner.start() == "");
    CHECK(joiner.kept_the_old_one());
    CHECK_FALSE(fs::exists(joiner.path / "rejoin"));
  }
  CHECK(joiner.meta()->head == peer.store.head());
  CHECK(joiner.meta()->stream.sequence == 60);
}

TEST_CASE("a damaged store is kept aside, and a peer's replaces it") {
  Peer peer;
  peer.store.enter(place_at(60));
  Joiner joiner;
  joiner.script.state = {1, 90, kMade};
  copy_store(peer.store, joiner.path);
  SECTION("it has less than was acknowledged") {
    store::Bytes ahead;
    encode(store::AcknowledgedState{1'000'000, 1}, ahead);
    std::ofstream{joiner.path / "acknowledged", std::ios::binary}.write(
        reinterpret_cast<const char*>(ahead.data()), static_cast<std::streamsize>(ahead.size()));
  }
  SECTION("the manifest is not one") {
    const std::string current = read_whole(joiner.path / "db" / "CURRENT");
    std::fstream{joiner.path / "db" / current.substr(0, current.size() - 1)} << "damage";
  }
  CHECK(joiner.start().starts_with("edits "));  // no peer could give another
  CHECK(fs::exists(joiner.path / "db"));
  joiner.peers = {{peer.url}, peer.admin()};
  CHECK(joiner.start() == "");
  CHECK(joiner.kept_the_old_one());
  CHECK(joiner.meta()->head == peer.store.head());
}

TEST_CASE("a store whose file acknowledged cannot be read is not replaced") {
  Peer peer;
  peer.store.enter(place_at(60));
  Joiner joiner;
  joiner.script.state = {1, 90, kMade};
  joiner.peers = {{peer.url}, peer.admin()};
  copy_store(peer.store, joiner.path);
  fs::remove(joiner.path / "acknowledged");
  fs::create_directory(joiner.path / "acknowledged");
  CHECK(joiner.start().starts_with("edits "));
  CHECK(fs::is_directory(joiner.path / "acknowledged"));
  CHECK_FALSE(joiner.kept_the_old_one());
}

TEST_CASE("a store whose last message is not in the stream is not replaced, however far it is behind") {
  Peer peer;
  peer.store.enter(place_at(60));
  Joiner joiner;
  joiner.id = peer.store.id();
  joiner.peers = {{peer.url}, peer.admin()};
  copy_store(peer.store, joiner.path);
  peer.store.enter(place_at(100'000));
  joiner.script.state = {1, 200'000, kMade};
  joiner.script.lost_end = true;
  const auto before = joiner.meta();
  CHECK(joiner.start() == "");
  CHECK(joiner.meta() == before);
  CHECK_FALSE(joiner.kept_the_old_one());
}

TEST_CASE("two stores replaced by joining are kept, and all that an operator replaced") {
  Peer peer;
  peer.store.enter(place_at(60));
  Joiner joiner;
  joiner.id = peer.store.id();
  joiner.script.state = {1, 90, kMade};
  joiner.peers = {{peer.url}, peer.admin()};
  copy_store(peer.store, joiner.path);
  for (const char* const own : {"replaced-1", "replaced-2", "replaced-3", "rejoined-x"}) {
    fs::create_directory(joiner.path / own);
  }
  for (int i = 0; i < 5; ++i) {
    REQUIRE(want_rejoin(joiner.path, "S differs").has_value());
    CHECK(joiner.start() == "");
  }
  std::set<std::string> kept;
  for (const auto& entry : fs::directory_iterator{joiner.path}) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with("re")) kept.insert(name);
  }
  CHECK(kept == std::set<std::string>{"rejoined-4", "rejoined-5", "rejoined-x", "replaced-1", "replaced-2",
                                      "replaced-3"});
}

TEST_CASE("a store that must not be used is not used even if no peer has another") {
  Peer peer;
  peer.store.enter(place_at(20));
  Joiner joiner;
  joiner.id = peer.store.id();
  copy_store(peer.store, joiner.path);
  joiner.script.state = {1, 90, kMade};
  joiner.peers = {{"http://127.0.0.1:9"}, {}};
  REQUIRE(want_rejoin(joiner.path, "S differs").has_value());
  CHECK(joiner.start() == "joining was given up");
  CHECK(joiner.start() == "joining was given up");
  CHECK(joiner.meta()->head == peer.store.head());
}

/// A server that has put its store aside, as it answers who asks.
struct AsidePeer {
  explicit AsidePeer(const AsideStore& aside) {
    const auto listening = server.listen({"127.0.0.1", 0});
    REQUIRE(listening.has_value());
    url = "http://" + *listening;
    server.start({[] { return ""; }, [] { return true; }, [] { return Readiness{}; },
                  [] { return FlowsReport{}; },
                  [aside](const http::Request&, const std::string&,
                          const std::function<void()>&) -> asio::awaitable<http::Response> {
                    http::Response response{503};
                    response.fields.push_back({kAsideHeader, to_string(aside)});
                    co_return response;
                  }});
  }
  ~AsidePeer() { server.stop(); }
  SystemClock clock;
  AdminServer server{clock, kSilentLog};
  std::string url;
};

TEST_CASE("if all servers have put their stores aside the one that has read most uses its own again") {
  Peer before;
  before.store.enter(place_at(20));
  Joiner joiner;
  joiner.id = before.store.id();
  copy_store(before.store, joiner.path);
  joiner.script.state = {1, 90, kMade};
  REQUIRE(want_rejoin(joiner.path, "S differs").has_value());
  const std::uint32_t number = cluster::server_number(joiner.path);
  const auto peer_at = [&](std::uint64_t sequence) {
    return std::make_unique<AsidePeer>(AsideStore{sequence, kMade, number + 1});
  };
  SECTION("all others less") {
    const auto a = peer_at(18);
    const auto b = peer_at(19);
    joiner.peers = {{a->url, b->url}, {}};
    CHECK(joiner.start() == "");
    CHECK_FALSE(fs::exists(joiner.path / "rejoin"));
    CHECK_FALSE(joiner.kept_the_old_one());
    CHECK(joiner.pauses == 0);
    REQUIRE(joiner.shown.size() == 2);
    CHECK(joiner.shown[0] == AsideStore{20, kMade, number});
    CHECK_FALSE(joiner.shown[1].has_value());
  }
  SECTION("another as far, with a higher number") {
    const auto a = peer_at(20);
    joiner.peers = {{a->url}, {}};
    CHECK(joiner.start() == "joining was given up");
    CHECK(fs::exists(joiner.path / "rejoin"));
  }
  SECTION("one is dead, and the rest is most of all") {
    const auto a = peer_at(18);
    const auto b = peer_at(19);
    joiner.peers = {{a->url, b->url, "http://127.0.0.1:9"}, {}};
    CHECK(joiner.start() == "");
  }
  SECTION("one is dead, and the rest is half of all") {
    const auto a = peer_at(18);
    joiner.peers = {{a->url, "http://127.0.0.1:9"}, {}};
    CHECK(joiner.start() == "joining was given up");
  }
  CHECK(joiner.meta()->head == before.store.head());
}

TEST_CASE("a store that is far behind reads the stream if no peer answers") {
  Peer peer;
  peer.store.enter(place_at(20));
  Joiner joiner;
  joiner.id = peer.store.id();
  copy_store(peer.store, joiner.path);
  joiner.script.state = {1, 200'000, kMade};
  joiner.peers = {{"http://127.0.0.1:9"}, {}};
  CHECK(joiner.start() == "");
  CHECK(joiner.pauses == 0);
  CHECK(joiner.meta()->stream.sequence == 20);
}

TEST_CASE("without the stream a store that is there is served, and one that is not is waited for") {
  Peer peer;
  peer.store.enter(place_at(60));
  Joiner joiner;
  joiner.id = peer.store.id();
  joiner.peers = {{peer.url}, peer.admin()};
  const StreamFailure away{StreamFailure::Kind::unavailable, "no NATS server answers"};
  joiner.script.state = {40, 90, kMade};
  joiner.script.failures = {away, away};
  CHECK(joiner.start() == "");
  CHECK(joiner.pauses == 2);
  joiner.script.failures = {away};
  CHECK(joiner.start() == "");
  CHECK(joiner.pauses == 2);
  CHECK(joiner.script.failures.empty());
  joiner.script.failures = {{StreamFailure::Kind::refused, "the credentials are wrong"}};
  CHECK_THAT(joiner.start(), Catch::Contains("the credentials are wrong"));
}

TEST_CASE("a store that a peer gave before the stream was asked waits to be compared with it") {
  Peer peer;
  peer.store.enter(place_at(60));
  Joiner joiner;
  joiner.peers = {{peer.url}, peer.admin()};
  const StreamFailure away{StreamFailure::Kind::unavailable, "no NATS server answers"};
  joiner.script.failures = {away, away};
  SECTION("it is of this stream") {
    joiner.script.state = {40, 90, kMade};
    CHECK(joiner.start() == "");
    CHECK(joiner.meta()->stream == place_at(60));
  }
  SECTION("it is of another one") {
    joiner.script.state = {40, 90, kMade + 1};
    CHECK_FALSE(joiner.start().empty());
  }
  CHECK(joiner.pauses == 2);
  CHECK(joiner.script.failures.empty());
}

TEST_CASE("a store of another id or world, or of no cluster, is refused and stays") {
  CheckpointStore mine;
  mine.store.close();
  const ContentHash id = mine.id();
  { const store::DataDirectory unlocked = *std::move(mine.directory); }
  Joiner joiner;
  joiner.path = mine.path;
  joiner.script.state = {1, 90, kMade};
  CHECK_THAT(joiner.start(), Catch::Contains("talusd store join-cluster"));
  joiner.id = ContentHash{9, 9};
  CHECK_THAT(joiner.start(), Catch::Contains("cluster.store names 00000000000000090000000000000009"));
  CHECK(joiner.meta()->store_id == id);
  std::ofstream{mine.path / "store.toml"} << store::store_text({id, {1, 3}});
  CHECK_THAT(joiner.start(), Catch::Contains("belongs to the world with fingerprint"));
}

}  // namespace talus::server::join
