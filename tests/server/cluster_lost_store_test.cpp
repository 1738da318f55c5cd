// Stores that cannot go on with the shared log, or are wrong: what their servers do.
#include <atomic>
#include <fstream>

#include <fmt/format.h>
#include <rocksdb/db.h>
#include <catch2/catch.hpp>

#include <talus/store/bytes.h>
#include <talus/store/rocks.h>

#include "cluster/entry_codec.h"
#include "cluster/server_number.h"
#include "cluster_in_memory.h"

namespace talus::server {
namespace {

using namespace testing;
using namespace std::chrono_literals;
using cluster::StoreLoss;
using Kind = edits::EntryResult::Kind;

/// Where the store says that S is another.
void falsify(const std::filesystem::path& path) {
  rocksdb::DB* opened = nullptr;
  REQUIRE(rocksdb::DB::Open(store::rocks_options({}, false), (path / "db").string(), &opened).ok());
  const std::unique_ptr<rocksdb::DB> db{opened};
  std::string value;
  REQUIRE(db->Get({}, store::meta_key(), &value).ok());
  auto meta = store::decode_meta(std::as_bytes(std::span{value}));
  REQUIRE(meta.has_value());
  meta->head.hash.low += 1;
  store::Bytes bytes;
  encode(*meta, bytes);
  REQUIRE(db->Put({}, store::meta_key(), store::as_slice(bytes)).ok());
  REQUIRE(db->Close().ok());
}

TEST_CASE("a server whose place the stream does not keep, or whose stream is another, is lost") {
  ClusterInMemory cluster{1};
  const std::vector<store::Bytes> some{bytes_of_entry(attach(8))};
  cluster.stream.append(cluster::encode_batch(foreign_head(), nullptr, some));
  SECTION("while it was away") {
    cluster.open();
    cluster.until_applied();
    cluster.nodes[0]->close();
    for (int i = 0; i < 5; ++i) cluster.stream.append(cluster::encode_batch(foreign_head(), nullptr, some));
    cluster.stream.keep_from(5);
    cluster.open();
    until([&] { return cluster.lost_of(0).has_value(); });
    CHECK(cluster.lost_of(0) == StoreLoss::too_old);
  }
  SECTION("before it had anything") {
    cluster.stream.keep_from(2);
    cluster.open();
    until([&] { return cluster.lost_of(0).has_value(); });
    CHECK(cluster.lost_of(0) == StoreLoss::no_start);
  }
  SECTION("as it was made anew, while it runs") {
    cluster.open();
    cluster.until_applied();
    cluster.stream.make_anew();
    until([&] { return cluster.lost_of(0).has_value(); });
    CHECK(cluster.lost_of(0) == StoreLoss::other);
    CHECK_FALSE(cluster.log(0).takes_entries());
    CHECK_FALSE(cluster.log(0).status().ready);
  }
  SECTION("as it begins with a state that the store has not") {
    cluster::Genesis genesis;
    genesis.identity = kClusterIdentity;
    genesis.head.position = 5;
    SharedStream other{*cluster::encode(genesis)};
    ClusterNode node{cluster.scratch / "other", ends_of(other, 5), 5};
    std::optional<StoreLoss> lost;
    std::mutex mutex;
    node.on_lost = [&](StoreLoss how, const std::string&) {
      const std::lock_guard lock{mutex};
      lost = how;
    };
    REQUIRE(node.open() == "");
    until([&] {
      const std::lock_guard lock{mutex};
      return lost.has_value();
    });
    CHECK(lost == StoreLoss::no_start);
    node.close();
  }
}

TEST_CASE("a publisher writes nothing more into a stream that is another, and answers what it has") {
  ClusterInMemory cluster{1};
  cluster.open();
  Answers answers;
  REQUIRE(answers.apply(cluster.log(0), attach()).has_value());
  cluster.stream.fail_publish_as(StreamFailure::Kind::other);
  const std::uint64_t before = cluster.stream.attempts;
  const auto doubtful = answers.send(cluster.log(0), write_at(1, 5));
  REQUIRE(doubtful.has_value());
  const auto open = answers.await(*doubtful);
  REQUIRE_FALSE(open.has_value());
  CHECK(open.error().code == EditErrorCode::unwritable);
  CHECK_FALSE(cluster.log(0).takes_entries());
  CHECK_FALSE(answers.send(cluster.log(0), write_at(2, 5)).has_value());
  CHECK(cluster.stream.attempts == before + 1);
}

TEST_CASE("edits that wait when a server stops for good are answered, and not published any more") {
  ClusterInMemory cluster{1};
  cluster.open();
  Answers answers;
  REQUIRE(answers.apply(cluster.log(0), attach()).has_value());
  cluster.stream.set_quorum(false);
  const std::uint64_t before = cluster.stream.attempts;
  const auto doubtful = answers.send(cluster.log(0), write_at(1, 5));
  REQUIRE(doubtful.has_value());
  until([&] { return cluster.stream.attempts > before; });
  const auto queued = answers.send(cluster.log(0), write_at(2, 6));
  cluster.stream.fail_next_as(StreamFailure::Kind::other);
  const auto open = answers.await(*doubtful);
  REQUIRE_FALSE(open.has_value());
  CHECK(open.error().code == EditErrorCode::unwritable);
  CHECK_THAT(open.error().message, Catch::Contains("it is another"));
  if (queued) CHECK(answers.await(*queued).error().code == EditErrorCode::cut_off);
  const std::size_t messages = cluster.stream.all().size();
  cluster.stream.set_quorum(true);
  until([&] { return cluster.log(0).status().quorum || !cluster.log(0).takes_entries(); });
  cluster.nodes[0]->close();
  CHECK(cluster.stream.all().size() == messages);
}

TEST_CASE("a server that was given a false message has a wrong state") {
  ClusterInMemory cluster{1};
  cluster.open();
  cluster.until_applied();
  cluster.stream.fail_next_as(StreamFailure::Kind::false_message);
  until([&] { return cluster.lost_of(0).has_value(); });
  CHECK(cluster.lost_of(0) == StoreLoss::wrong_state);
}

TEST_CASE("while the leader says less than was applied no edits are taken, and no player comes") {
  ClusterInMemory cluster{1};
  cluster.open();
  Answers answers;
  REQUIRE(answers.apply(cluster.log(0), attach()).has_value());
  until([&] { return cluster.log(0).status().ready; });
  cluster.stream.say_fewer(1);
  until([&] { return !cluster.log(0).status().ready; });
  CHECK_FALSE(cluster.log(0).takes_entries());
  const auto refused = answers.send(cluster.log(0), write_at(1, 5));
  REQUIRE_FALSE(refused.has_value());
  CHECK_THAT(refused.error().message, Catch::Contains("lost its end"));
  cluster.stream.say_fewer(0);
  until([&] { return cluster.log(0).status().ready; });
  CHECK(answers.apply(cluster.log(0), write_at(1, 5))->kind == Kind::done);
}

TEST_CASE("a server that cannot read a chunk takes no edits, and then needs another's store") {
  ClusterInMemory cluster{2};
  cluster.open();
  Answers answers;
  REQUIRE(answers.apply(cluster.log(0), attach()).has_value());
  REQUIRE(answers.apply(cluster.log(0), write_at(1, 5)).has_value());
  REQUIRE(answers.apply(cluster.log(0), write_at(2, 6)).has_value());
  cluster.until_applied();
  cluster.nodes[1]->close();
  cluster.nodes[1]->before_log = [&] {
    store::EditDatabase::Slice older;
    older.put({{0, 0, 0}, Lod{}}, 1, {});
    REQUIRE(cluster.nodes[1]->database().put(older));
  };
  bool refused = false;
  std::atomic<bool> told_that_it_takes = true;
  cluster.nodes[1]->on_takes = [&] {
    told_that_it_takes = cluster.log(1).takes_entries();
    if (told_that_it_takes) return;
    // Before it stops for good, when it is not ready for the same reason.
    const auto status = cluster.log(1).status();
    const auto says = [](const std::string& why) {
      return why.find("cannot be applied") != std::string::npos;
    };
    if (status.read_only && says(*status.read_only) && !says(status.not_ready)) refused = true;
  };
  REQUIRE(cluster.nodes[1]->open() == "");
  cluster.until_applied();
  until(
      [&] { return told_that_it_takes && cluster.log(1).takes_entries() && cluster.log(1).status().ready; });
  REQUIRE(answers.apply(cluster.log(0), write_at(3, 7)).has_value());
  until([&] { return cluster.lost_of(1).has_value(); });
  CHECK(cluster.lost_of(1) == StoreLoss::wrong_state);
  CHECK_FALSE(cluster.log(1).takes_entries());
  CHECK_THAT(cluster.why[1], Catch::Contains("chunk (0, 0, 0)"));
  cluster.nodes[1]->close();
  CHECK(refused);
}

TEST_CASE(
    "a store that is closed after a disk error is not lost, however long messages wait for its chunks") {
  ClusterInMemory cluster{2};
  ClusterNode& node = *cluster.nodes[1];
  node.state_settings.cache_bytes = 0;
  cluster.open();
  Answers answers;
  REQUIRE(answers.apply(cluster.log(0), attach()).has_value());
  REQUIRE(answers.apply(cluster.log(0), write_at(1, 5)).has_value());
  cluster.until_applied();
  until([&] { return node.state().dirty_bytes() == 0; });
  // The sync after the next batch fails, and so does each attempt to open the database again.
  node.disk().fail_sync_after(0);
  REQUIRE(answers.apply(cluster.log(0), attach(8)).has_value());
  until([&] { return node.disk().failed_syncs() > 1; });
  REQUIRE(answers.apply(cluster.log(0), write_at(2, 6)).has_value());
  const std::int64_t before = node.disk().failed_syncs();
  until([&] { return node.disk().failed_syncs() > before + 100 || cluster.lost_of(1).has_value(); });
  CHECK_FALSE(cluster.lost_of(1).has_value());
  node.disk().mend();
  cluster.until_applied();
  CHECK(cluster.log(1).status().head == cluster.log(0).status().head);
}

TEST_CASE("a server whose store cannot be written stops without waiting for answers") {
  ClusterInMemory cluster{1};
  ClusterNode& node = *cluster.nodes[0];
  node.settings.last_wait = 3min;
  cluster.open();
  Answers answers;
  REQUIRE(answers.apply(cluster.log(0), attach()).has_value());
  cluster.until_applied();
  // Another server's message, which cannot be written, comes before the entry's.
  cluster.stream.set_quorum(false);
  REQUIRE(answers.send(cluster.log(0), write_at(1, 5)).has_value());
  node.disk().fill_after(0);
  const std::vector<store::Bytes> other{bytes_of_entry(attach(8))};
  const std::uint64_t before = cluster.stream.append(cluster::encode_batch(foreign_head(), nullptr, other));
  cluster.stream.set_quorum(true);
  until([&] { return cluster.stream.state().last > before; });
  REQUIRE(cluster.log(0).status().waiting > 0);
  const auto began = std::chrono::steady_clock::now();
  node.close();
  CHECK(std::chrono::steady_clock::now() - began < 1min);
}

TEST_CASE("a server has one number, however often it starts") {
  const ScratchDirectory scratch;
  const std::uint32_t number = cluster::server_number(scratch.path());
  CHECK(cluster::server_number(scratch.path()) == number);
  std::ofstream{scratch / "server_number"} << "damaged";
  const std::uint32_t other = cluster::server_number(scratch.path());
  CHECK(cluster::server_number(scratch.path()) == other);
}

TEST_CASE("one of three servers with another state takes itself out, and the others continue") {
  ClusterInMemory cluster{3};
  cluster.open();
  Answers answers;
  REQUIRE(answers.apply(cluster.log(0), attach()).has_value());
  REQUIRE(answers.apply(cluster.log(0), write_at(1, 5)).has_value());
  cluster.until_applied();
  cluster.nodes[2]->close();
  falsify(cluster.nodes[2]->path());
  REQUIRE(cluster.nodes[2]->open() == "");
  // The next batch says with which S its server stood at revision 1.
  REQUIRE(answers.apply(cluster.log(0), write_at(2, 6)).has_value());
  std::uint64_t sequence = 3;
  until([&] {
    std::this_thread::sleep_for(10ms);
    (void)answers.apply(cluster.log(0), write_at(sequence, static_cast<std::int64_t>(sequence)));
    ++sequence;
    return cluster.lost_of(2).has_value();
  });
  CHECK(cluster.lost_of(2) == StoreLoss::wrong_state);
  CHECK(cluster.log(2).status().differs);
  CHECK_FALSE(cluster.log(2).status().ready);
  CHECK_FALSE(cluster.log(2).takes_entries());
  for (std::size_t i = 0; i < 2; ++i) {
    CHECK_FALSE(cluster.lost_of(i).has_value());
    CHECK(answers.apply(cluster.log(i), write_at(sequence + i, 100 + static_cast<std::int64_t>(i)))->kind ==
          Kind::done);
  }
}

TEST_CASE(
    "the end that a power cut takes from a server is read from the log again, and lost synced entries are "
    "noticed") {
  ClusterInMemory cluster{2};
  cluster.open();
  Answers answers;
  REQUIRE(answers.apply(cluster.log(0), attach()).has_value());
  for (std::uint64_t i = 1; i <= 50; ++i) {
    REQUIRE(answers.apply(cluster.log(0), write_at(i, static_cast<std::int64_t>(i))).has_value());
  }
  cluster.until_applied();
  cluster.nodes[1]->cut_power();
  REQUIRE(cluster.nodes[1]->open() == "");
  cluster.until_applied();
  CHECK(cluster.log(1).status().head == cluster.log(0).status().head);
}

}  // namespace
}  // namespace talus::server
