// A store of one machine that becomes a cluster's, and comes back.
#include <filesystem>
#include <fstream>

#include <catch2/catch.hpp>

#include <talus/store/store_identity.h>
#include <talus/store/whole_store.h>

#include "checkpoint_store.h"
#include "cluster/join/enter_cluster.h"
#include "cluster_node.h"
#include "sealed_again.h"
#include "shared_stream.h"

namespace talus::server::join {
namespace {

using namespace testing;
namespace fs = std::filesystem;

const edits::SettleRules kSettles{{MaterialId{4}, 7}};

/// A store of one machine that was stopped.
struct Single {
  explicit Single(int edits = 50) {
    REQUIRE(store.open() == "");
    REQUIRE(store.database().bind({{"planks", MaterialId{256}}}).has_value());
    editor.attach(store);
    std::mt19937_64 random{4};
    for (int i = 0; i < edits; ++i) REQUIRE(editor.edit(store, random_edit(random)).has_value());
    head = store.log().status().head;
    voxels = overrides_of(store.state());
    store.close();
    const store::EditDatabaseSettings& settings = store.database_settings;
    std::ofstream{path / "store.toml"} << store::store_text({settings.store_id, settings.fingerprint});
  }

  std::string enter() {
    StreamEnd end{stream, 1, faults};
    const auto entered = enter_cluster(path, kSettles, end);
    if (!entered) {
      CHECK(entered.error().find('\n') == std::string::npos);
      return entered.error();
    }
    CHECK(entered->head == head);
    return "";
  }
  [[nodiscard]] store::StoreMeta meta() const {
    const auto read = read_place(path);
    REQUIRE(read.has_value());
    return *read;
  }

  ScratchDirectory scratch{ScratchDirectory::memory()};
  fs::path path = scratch / "data";
  EditStore store{path};
  TestEditor editor;
  edits::Head head;
  std::map<VoxelPos, MaterialId> voxels;
  SharedStream stream;
  StreamFaults faults;
};

edits::Edit one_write(std::int64_t x, std::int64_t y, std::int64_t z) {
  edits::Edit edit;
  edit.writes.push_back({{x, y, z}, MaterialId{256}});
  return edit;
}

/// Returns when the node's log has answered.
std::optional<edits::EntryResult> apply(ClusterNode& node, LogEntry entry) {
  std::mutex mutex;
  std::condition_variable answered;
  std::optional<std::optional<edits::EntryResult>> result;
  while (!node.log().append(entry, [&](const auto& applied) {
    const std::lock_guard lock{mutex};
    result = applied ? std::optional{**applied} : std::nullopt;
    answered.notify_one();
  })) {
    std::this_thread::yield();
  }
  std::unique_lock lock{mutex};
  answered.wait(lock, [&] { return result.has_value(); });
  return *result;
}

}  // namespace

TEST_CASE("a store begins its stream at its own revision, and once") {
  Single single;
  CHECK(single.enter() == "");
  CHECK(single.meta().stream ==
        store::StreamPlace{1, 1, 0, cluster::hash_of_message(single.stream.all().at(0))});
  CHECK(single.meta().head == single.head);
  const auto genesis = cluster::decode_genesis(single.stream.all().at(0));
  REQUIRE(genesis.has_value());
  CHECK(genesis->identity == kClusterIdentity);
  CHECK(genesis->head == single.head);
  CHECK(genesis->settles == kSettles);
  CHECK(genesis->materials == edits::MaterialIds{{"planks", MaterialId{256}}});
  CHECK_THAT(single.enter(), Catch::Contains("is in a cluster already, at message 1"));
  CHECK(single.stream.state().last == 1);
}

TEST_CASE("a store that was interrupted when it entered, enters") {
  Single single;
  SECTION("before it knew that it was in") {
    CHECK(single.enter() == "");
    REQUIRE(store::enter_stream(single.path, {}).has_value());
  }
  SECTION("without an answer") {
    single.faults.unacked = 256;
  }
  SECTION("where its message arrives after the wait") {
    single.faults.delayed = 256;
  }
  SECTION("with few answers") {
    single.faults.lost = 200;
  }
  CHECK(single.enter() == "");
  CHECK(single.stream.state().last == 1);
  CHECK(single.meta().stream ==
        store::StreamPlace{1, 1, 0, cluster::hash_of_message(single.stream.all().at(0))});
}

TEST_CASE("a stream that something else has begun is not entered, and the store stays as it is") {
  Single single;
  SECTION("another state of the store") {
    single.stream.append(empty_genesis());
  }
  SECTION("no genesis") {
    single.stream.append(std::vector<std::byte>(100));
  }
  SECTION("one that went on") {
    single.stream.append(empty_genesis());
    single.stream.append(empty_genesis());
    single.stream.keep_from(2);
  }
  const auto before = single.stream.state().last;
  CHECK_THAT(single.enter(), Catch::Contains("is begun already") && Catch::Contains("talusd store fork"));
  CHECK(single.stream.state().last == before);
  CHECK(single.meta().stream == store::StreamPlace{});
}

TEST_CASE("a stream that a newer talusd has begun is not to be deleted, but talusd upgraded") {
  Single single;
  single.stream.append(of_newer_format(empty_genesis()));
  CHECK(single.enter() ==
        "the stream's first message: it has format 9; this talusd reads up to 1; upgrade it");
  CHECK(single.meta().stream == store::StreamPlace{});
}

TEST_CASE("into a cluster and back a store keeps revisions, editors and edits") {
  Single single;
  REQUIRE(single.enter() == "");
  {
    ClusterNode node{single.path, [&] { return std::make_unique<StreamEnd>(single.stream, 9); }, 9};
    REQUIRE(node.open() == "");
    // The editor's sequences go on.
    const auto repeat = apply(node, single.editor.entry(one_write(1, 2, 3)));
    REQUIRE(repeat.has_value());
    CHECK(repeat->kind == edits::EntryResult::Kind::repeat);
    ++single.editor.sequence;
    const auto done = apply(node, single.editor.entry(one_write(1, 2, 3)));
    REQUIRE(done.has_value());
    CHECK(done->kind == edits::EntryResult::Kind::done);
    CHECK(done->revision == single.head.revision + 1);
    single.voxels[{1, 2, 3}] = MaterialId{256};
    CHECK(overrides_of(node.state()) == single.voxels);
  }
  const edits::Head in_cluster = single.meta().head;
  CHECK(single.meta().stream.sequence > 1);
  SECTION("under its id") {
    REQUIRE(store::enter_stream(single.path, {}).has_value());
  }
  SECTION("under another") {
    REQUIRE(store::give_identity(single.path, {5, 6}).has_value());
  }
  CHECK(single.meta().stream == store::StreamPlace{});
  CHECK(single.meta().head == in_cluster);
  REQUIRE(single.store.open() == "");
  CHECK(overrides_of(single.store.state()) == single.voxels);
  CHECK(single.store.state().editor(single.editor.id)->epoch == single.editor.epoch);
  ++single.editor.sequence;
  const auto on = single.store.apply(single.editor.entry(one_write(1, 2, 4)));
  CHECK(on->revision == in_cluster.revision + 1);
}

}  // namespace talus::server::join
