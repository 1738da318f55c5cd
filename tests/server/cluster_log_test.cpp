// One server's end of the shared log: what it takes, what it applies, and when it stops.
#include <condition_variable>
#include <fstream>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include <rocksdb/db.h>
#include <catch2/catch.hpp>

#include "cluster/entry_codec.h"
#include "cluster/server_number.h"
#include "cluster_node.h"
#include "edits/model.h"
#include "scratch_directory.h"
#include "shared_stream.h"
#include "store/rocks.h"

namespace talus::server {
namespace {

using namespace testing;
using namespace std::chrono_literals;
using cluster::Lost;
using edits::testing::base_of;
using Kind = edits::Applied::Kind;
using Outcome = tl::expected<edits::Applied, LogFailure>;

/// Entries that were given to a log, and their answers as they come.
class Answers {
 public:
  /// Whether the log takes it; the answer then has this number.
  tl::expected<std::size_t, LogFailure> send(EditLog& log, LogEntry entry) {
    std::size_t number = 0;
    {
      const std::lock_guard lock{mutex_};
      number = answers_.size();
      answers_.emplace_back();
    }
    auto taken = log.append(std::move(entry), [this, number](const auto& outcome) {
      {
        const std::lock_guard lock{mutex_};
        answers_[number] = outcome ? Outcome{**outcome} : tl::unexpected{outcome.error()};
      }
      comes_.notify_all();
    });
    if (!taken) return tl::unexpected{taken.error()};
    return number;
  }
  [[nodiscard]] bool has(std::size_t number) {
    const std::lock_guard lock{mutex_};
    return answers_[number].has_value();
  }
  Outcome await(std::size_t number) {
    std::unique_lock lock{mutex_};
    REQUIRE(comes_.wait_for(lock, 30s, [&] { return answers_[number].has_value(); }));
    return *answers_[number];
  }
  /// Sends it until the log takes it, and waits for the answer.
  Outcome apply(EditLog& log, const LogEntry& entry) {
    const auto give_up = std::chrono::steady_clock::now() + 30s;
    for (;;) {
      if (const auto number = send(log, entry)) return await(*number);
      REQUIRE(std::chrono::steady_clock::now() < give_up);
      std::this_thread::yield();
    }
  }

 private:
  std::mutex mutex_;
  std::condition_variable comes_;
  std::vector<std::optional<Outcome>> answers_;
};

void until(const std::function<bool()>& holds) {
  const auto give_up = std::chrono::steady_clock::now() + 30s;
  while (!holds()) {
    if (std::chrono::steady_clock::now() > give_up) FAIL("what is waited for does not come");
    std::this_thread::yield();
  }
}

edits::EditEntry write_at(std::uint64_t sequence, std::int64_t x, std::uint64_t editor = 7) {
  edits::EditEntry entry{{editor, 9}, 1, sequence, {}, {}};
  entry.edit.writes.push_back({{x, 1, 1}, MaterialId{9}});
  entry.base = base_of(entry.edit);
  return entry;
}
edits::AttachEntry attach(std::uint64_t editor = 7) {
  return {{editor, 9}, 1, "somebody"};
}

Bytes bytes_of_entry(const LogEntry& entry) {
  Bytes bytes;
  cluster::encode(entry, bytes);
  return bytes;
}

cluster::BatchHead foreign_head() {
  return {kClusterIdentity, 1234, 1, 5, 1'000'000, {}};
}

struct Cluster {
  ScratchDirectory scratch;
  SharedStream stream{empty_genesis()};
  std::vector<std::unique_ptr<ClusterNode>> nodes;
  std::mutex mutex;
  std::vector<std::optional<Lost>> lost;
  std::vector<std::string> why;

  explicit Cluster(std::size_t count) : lost(count), why(count) {
    for (std::size_t i = 0; i < count; ++i) {
      nodes.push_back(
          std::make_unique<ClusterNode>(scratch / std::to_string(i), ends_of(stream, i * 100), i * 100));
      nodes[i]->on_lost = [this, i](Lost how, const std::string& reason) {
        const std::lock_guard lock{mutex};
        lost[i] = how;
        why[i] = reason;
      };
    }
  }
  ~Cluster() { nodes.clear(); }
  void open() {
    for (auto& node : nodes) REQUIRE(node->open() == "");
  }
  cluster::ClusterLog& log(std::size_t i) { return nodes[i]->log(); }
  void until_applied() {
    for (auto& node : nodes) until([&] { return node->log().status().sequence == stream.state().last; });
  }
  std::optional<Lost> lost_of(std::size_t i) {
    const std::lock_guard lock{mutex};
    return lost[i];
  }
};

/// Where the store says that S is another.
void falsify(const std::filesystem::path& path) {
  rocksdb::DB* opened = nullptr;
  REQUIRE(rocksdb::DB::Open(rocks_options({}, false), (path / "db").string(), &opened).ok());
  const std::unique_ptr<rocksdb::DB> db{opened};
  std::string value;
  REQUIRE(db->Get({}, meta_key(), &value).ok());
  auto meta = decode_meta(std::as_bytes(std::span{value}));
  REQUIRE(meta.has_value());
  meta->head.hash.low += 1;
  Bytes bytes;
  encode(*meta, bytes);
  REQUIRE(db->Put({}, meta_key(), as_slice(bytes)).ok());
  REQUIRE(db->Close().ok());
}

}  // namespace

TEST_CASE("what one server takes all apply, and it is answered where it was taken") {
  Cluster cluster{3};
  cluster.open();
  Answers answers;
  CHECK(answers.apply(cluster.log(0), attach())->kind == Kind::attached);
  const auto done = answers.apply(cluster.log(0), write_at(1, 5));
  REQUIRE(done.has_value());
  CHECK(done->kind == Kind::done);
  CHECK(done->revision == 1);
  cluster.until_applied();
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(cluster.log(i).status().head == cluster.log(0).status().head);
    CHECK(cluster.log(i).status().head.revision == 1);
    until([&] { return cluster.log(i).status().ready; });
  }
  // From another server it is the same edit again.
  const auto again = answers.apply(cluster.log(1), write_at(1, 5));
  CHECK(again->kind == Kind::repeat);
  CHECK(again->result == done->result);
}

TEST_CASE("names that several servers bring at once have the same ids everywhere") {
  Cluster cluster{2};
  cluster.open();
  Answers answers;
  const auto first = answers.send(cluster.log(0), edits::BindEntry{{"glass", "lamp"}});
  const auto second = answers.send(cluster.log(1), edits::BindEntry{{"sand", "lamp"}});
  const auto bound =
      first ? answers.await(*first) : answers.apply(cluster.log(0), edits::BindEntry{{"glass", "lamp"}});
  const auto other =
      second ? answers.await(*second) : answers.apply(cluster.log(1), edits::BindEntry{{"sand", "lamp"}});
  REQUIRE(bound->kind == Kind::bound);
  REQUIRE(other->kind == Kind::bound);
  CHECK(bound->materials[1] == other->materials[1]);
  cluster.until_applied();
  for (auto& node : cluster.nodes) node->close();
  for (auto& node : cluster.nodes) REQUIRE(node->open_store() == "");
  CHECK(cluster.nodes[0]->database().materials().size() == 3);
  CHECK(cluster.nodes[0]->database().materials() == cluster.nodes[1]->database().materials());
}

TEST_CASE("without a quorum edits in doubt stay open, further ones are refused, and all recovers by itself") {
  Cluster cluster{2};
  cluster.open();
  Answers answers;
  REQUIRE(answers.apply(cluster.log(0), attach()).has_value());
  until([&] { return cluster.log(0).status().ready; });
  cluster.stream.set_quorum(false);
  const std::uint64_t before = cluster.stream.attempts;
  const auto doubtful = answers.send(cluster.log(0), write_at(1, 5));
  REQUIRE(doubtful.has_value());
  until([&] { return cluster.stream.attempts > before; });
  // Waits for the next message; on a slow machine the log may have lost its patience already.
  const auto queued = answers.send(cluster.log(0), write_at(2, 6));
  const auto why = queued ? answers.await(*queued).error() : queued.error();
  CHECK(why.kind == LogFailure::Kind::cut_off);
  until([&] { return !cluster.log(0).takes_entries(); });
  const auto late = answers.send(cluster.log(0), write_at(3, 7));
  REQUIRE_FALSE(late.has_value());
  CHECK(late.error().kind == LogFailure::Kind::cut_off);
  CHECK_FALSE(cluster.log(0).takes_entries());
  CHECK(cluster.log(0).status().ready);  // or a balancer would drop all servers
  CHECK_FALSE(cluster.log(0).status().quorum);
  CHECK_FALSE(answers.has(*doubtful));
  cluster.stream.set_quorum(true);
  CHECK(answers.await(*doubtful)->kind == Kind::done);
  until([&] { return cluster.log(0).takes_entries(); });
  CHECK(answers.apply(cluster.log(0), write_at(3, 7))->kind == Kind::done);
}

TEST_CASE("a server that starts while the log is away is ready with what it has, unless that is nothing") {
  Cluster cluster{2};
  cluster.nodes[0]->settings.look_interval = 1ms;
  REQUIRE(cluster.nodes[0]->open() == "");
  Answers answers;
  REQUIRE(answers.apply(cluster.log(0), attach()).has_value());
  cluster.nodes[0]->close();
  cluster.stream.set_quorum(false);
  cluster.open();
  until([&] { return cluster.log(0).status().ready; });
  const auto status = cluster.log(0).status();
  REQUIRE(status.read_only.has_value());
  CHECK_THAT(*status.read_only, Catch::Contains("cannot be reached, or has no quorum: no answer"));
  CHECK_FALSE(status.quorum);
  const auto refused = answers.send(cluster.log(0), write_at(1, 5));
  REQUIRE_FALSE(refused.has_value());
  CHECK(refused.error().kind == LogFailure::Kind::cut_off);
  until([&] { return cluster.log(1).status().not_ready == "no answer"; });
  cluster.stream.set_quorum(true);
  CHECK(answers.apply(cluster.log(0), write_at(1, 5))->kind == Kind::done);
  until([&] { return cluster.log(1).status().ready && cluster.log(0).status().ready; });
  SECTION("but not where the stream is found to be another") {
    cluster.nodes[0]->close();
    cluster.stream.set_quorum(false);
    REQUIRE(cluster.nodes[0]->open() == "");
    until([&] { return cluster.log(0).status().ready; });
    cluster.stream.make_anew();
    cluster.stream.set_quorum(true);
    until([&] { return !cluster.log(0).status().ready && cluster.lost_of(0) == Lost::other; });
  }
}

TEST_CASE("a message that cannot be read stops a server there, and it says why") {
  Cluster cluster{1};
  std::string why;
  const std::vector<Bytes> good{bytes_of_entry(attach(8))};
  SECTION("damaged") {
    Bytes message = cluster::encode_batch(foreign_head(), nullptr, good);
    message[40] ^= std::byte{1};
    cluster.stream.append(message);
    why = "message 2 of the log cannot be applied: its checksum is wrong";
  }
  SECTION("of a newer talusd") {
    Bytes message = cluster::encode_batch(foreign_head(), nullptr, good);
    message[0] = std::byte{9};
    cluster.stream.append(message);
    why = "message 2 of the log cannot be applied: it has format 9; this talusd reads up to 1; upgrade it";
  }
  SECTION("of another store") {
    cluster::BatchHead head = foreign_head();
    head.identity.store_id = {9, 9};
    cluster.stream.append(cluster::encode_batch(head, nullptr, good));
    why = "message 2 of the log cannot be applied: it is of store 00000000000000090000000000000009";
  }
  SECTION("of another world") {
    cluster::BatchHead head = foreign_head();
    head.identity.fingerprint = {9, 9};
    cluster.stream.append(cluster::encode_batch(head, nullptr, good));
    why = "message 2 of the log cannot be applied: it is of the world with fingerprint";
  }
  SECTION("an entry that is newer") {
    std::vector<Bytes> entries = good;
    entries.push_back(bytes_of_entry(attach(9)));
    entries[1][0] = std::byte{7};
    cluster.stream.append(cluster::encode_batch(foreign_head(), nullptr, entries));
    why = "message 2 of the log cannot be applied: its entry 2 is one that this talusd does not know";
  }
  SECTION("no message at all") {
    cluster.stream.append(Bytes(100, std::byte{1}));
    why = "message 2 of the log cannot be applied: its checksum is wrong";
  }
  // What is behind it is sound, and must not be applied.
  cluster.stream.append(cluster::encode_batch(foreign_head(), nullptr, good));
  cluster.open();
  until([&] { return cluster.log(0).status().not_ready.find("cannot be applied") != std::string::npos; });
  const auto status = cluster.log(0).status();
  CAPTURE(status.not_ready);
  CHECK(status.not_ready.starts_with(why));
  CHECK_FALSE(status.ready);
  CHECK(status.head.position == 0);
  Answers answers;
  const auto refused = answers.send(cluster.log(0), attach());
  REQUIRE_FALSE(refused.has_value());
  CHECK(refused.error().reason.starts_with(why));
  CHECK_FALSE(cluster.lost_of(0).has_value());  // another store would not help
}

TEST_CASE("a server whose place the stream does not keep, or whose stream is another, is lost") {
  Cluster cluster{1};
  const std::vector<Bytes> some{bytes_of_entry(attach(8))};
  cluster.stream.append(cluster::encode_batch(foreign_head(), nullptr, some));
  SECTION("while it was away") {
    cluster.open();
    cluster.until_applied();
    cluster.nodes[0]->close();
    for (int i = 0; i < 5; ++i) cluster.stream.append(cluster::encode_batch(foreign_head(), nullptr, some));
    cluster.stream.keep_from(5);
    cluster.open();
    until([&] { return cluster.lost_of(0).has_value(); });
    CHECK(cluster.lost_of(0) == Lost::too_old);
  }
  SECTION("before it had anything") {
    cluster.stream.keep_from(2);
    cluster.open();
    until([&] { return cluster.lost_of(0).has_value(); });
    CHECK(cluster.lost_of(0) == Lost::no_start);
  }
  SECTION("as it was made anew, while it runs") {
    cluster.open();
    cluster.until_applied();
    cluster.stream.make_anew();
    until([&] { return cluster.lost_of(0).has_value(); });
    CHECK(cluster.lost_of(0) == Lost::other);
    CHECK_FALSE(cluster.log(0).takes_entries());
    CHECK_FALSE(cluster.log(0).status().ready);
  }
  SECTION("as it begins with a state that the store has not") {
    cluster::Genesis genesis;
    genesis.identity = kClusterIdentity;
    genesis.head.position = 5;
    SharedStream other{*cluster::encode(genesis)};
    ClusterNode node{cluster.scratch / "other", ends_of(other, 5), 5};
    std::optional<Lost> lost;
    std::mutex mutex;
    node.on_lost = [&](Lost how, const std::string&) {
      const std::lock_guard lock{mutex};
      lost = how;
    };
    REQUIRE(node.open() == "");
    until([&] {
      const std::lock_guard lock{mutex};
      return lost.has_value();
    });
    CHECK(lost == Lost::no_start);
    node.close();
  }
}

TEST_CASE("a publisher writes nothing more into a stream that is another, and answers what it has") {
  Cluster cluster{1};
  cluster.open();
  Answers answers;
  REQUIRE(answers.apply(cluster.log(0), attach()).has_value());
  cluster.stream.fail_publish_as(StreamFailure::Kind::other);
  const std::uint64_t before = cluster.stream.attempts;
  const auto doubtful = answers.send(cluster.log(0), write_at(1, 5));
  REQUIRE(doubtful.has_value());
  const auto open = answers.await(*doubtful);
  REQUIRE_FALSE(open.has_value());
  CHECK(open.error().kind == LogFailure::Kind::unwritable);
  CHECK_FALSE(cluster.log(0).takes_entries());
  CHECK_FALSE(answers.send(cluster.log(0), write_at(2, 5)).has_value());
  CHECK(cluster.stream.attempts == before + 1);
}

TEST_CASE("what waits when a server stops for good is answered, and not published any more") {
  Cluster cluster{1};
  cluster.open();
  Answers answers;
  REQUIRE(answers.apply(cluster.log(0), attach()).has_value());
  cluster.stream.set_quorum(false);
  const std::uint64_t before = cluster.stream.attempts;
  const auto doubtful = answers.send(cluster.log(0), write_at(1, 5));
  REQUIRE(doubtful.has_value());
  until([&] { return cluster.stream.attempts > before; });
  const auto queued = answers.send(cluster.log(0), write_at(2, 6));
  cluster.stream.append(Bytes(100, std::byte{1}));
  const auto open = answers.await(*doubtful);
  REQUIRE_FALSE(open.has_value());
  CHECK(open.error().kind == LogFailure::Kind::unwritable);
  CHECK_THAT(open.error().reason, Catch::Contains("cannot be applied"));
  if (queued) CHECK(answers.await(*queued).error().kind == LogFailure::Kind::cut_off);
  const std::size_t messages = cluster.stream.all().size();
  cluster.stream.set_quorum(true);
  until([&] { return cluster.log(0).status().quorum || !cluster.log(0).takes_entries(); });
  cluster.nodes[0]->close();
  CHECK(cluster.stream.all().size() == messages);
}

TEST_CASE("a server that was given a false message has a wrong state") {
  Cluster cluster{1};
  cluster.open();
  cluster.until_applied();
  cluster.stream.fail_next_as(StreamFailure::Kind::false_message);
  until([&] { return cluster.lost_of(0).has_value(); });
  CHECK(cluster.lost_of(0) == Lost::wrong_state);
}

TEST_CASE("while the leader says less than was applied no edits are taken, and no player comes") {
  Cluster cluster{1};
  cluster.open();
  Answers answers;
  REQUIRE(answers.apply(cluster.log(0), attach()).has_value());
  until([&] { return cluster.log(0).status().ready; });
  cluster.stream.say_fewer(1);
  until([&] { return !cluster.log(0).status().ready; });
  CHECK_FALSE(cluster.log(0).takes_entries());
  const auto refused = answers.send(cluster.log(0), write_at(1, 5));
  REQUIRE_FALSE(refused.has_value());
  CHECK_THAT(refused.error().reason, Catch::Contains("lost its end"));
  cluster.stream.say_fewer(0);
  until([&] { return cluster.log(0).status().ready; });
  CHECK(answers.apply(cluster.log(0), write_at(1, 5))->kind == Kind::done);
}

TEST_CASE("a server that cannot read a chunk takes no edits, and then needs another's store") {
  Cluster cluster{2};
  cluster.open();
  Answers answers;
  REQUIRE(answers.apply(cluster.log(0), attach()).has_value());
  REQUIRE(answers.apply(cluster.log(0), write_at(1, 5)).has_value());
  REQUIRE(answers.apply(cluster.log(0), write_at(2, 6)).has_value());
  cluster.until_applied();
  cluster.nodes[1]->close();
  cluster.nodes[1]->before_log = [&] {
    EditDatabase::Slice older;
    older.put({{0, 0, 0}, Lod{}}, 1, {});
    REQUIRE(cluster.nodes[1]->database().put(older));
  };
  bool refused = false;
  cluster.nodes[1]->on_takes = [&] {
    if (!cluster.nodes[1]->is_open() || cluster.log(1).takes_entries()) return;
    // Before it stops for good, when it is not ready for the same reason.
    const auto status = cluster.log(1).status();
    const auto says = [](const std::string& why) {
      return why.find("cannot be applied") != std::string::npos;
    };
    if (status.read_only && says(*status.read_only) && !says(status.not_ready)) refused = true;
  };
  REQUIRE(cluster.nodes[1]->open() == "");
  cluster.until_applied();
  REQUIRE(answers.apply(cluster.log(0), write_at(3, 7)).has_value());
  until([&] { return cluster.lost_of(1).has_value(); });
  CHECK(cluster.lost_of(1) == Lost::wrong_state);
  CHECK_FALSE(cluster.log(1).takes_entries());
  CHECK_THAT(cluster.why[1], Catch::Contains("chunk (0, 0, 0)"));
  cluster.nodes[1]->close();
  CHECK(refused);
}

TEST_CASE("a server has one number, however often it starts") {
  const ScratchDirectory scratch;
  const std::uint32_t number = cluster::server_number(scratch.path());
  CHECK(cluster::server_number(scratch.path()) == number);
  std::ofstream{scratch / "server_number"} << "damaged";
  const std::uint32_t other = cluster::server_number(scratch.path());
  CHECK(cluster::server_number(scratch.path()) == other);
}

TEST_CASE("of three servers the one whose state is another takes itself out, and the others go on") {
  Cluster cluster{3};
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
  CHECK(cluster.lost_of(2) == Lost::wrong_state);
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
    "what a power cut takes of a server's end is read from the log again, and what was synced is missed") {
  Cluster cluster{2};
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

TEST_CASE("a full disk stops a server where it is, and it goes on when there is room") {
  Cluster cluster{2};
  cluster.open();
  Answers answers;
  REQUIRE(answers.apply(cluster.log(0), attach()).has_value());
  cluster.until_applied();
  cluster.nodes[1]->disk().fill_after(0);
  for (std::uint64_t i = 1; i <= 20; ++i) {
    REQUIRE(answers.apply(cluster.log(0), write_at(i, static_cast<std::int64_t>(i))).has_value());
  }
  until([&] { return cluster.log(1).status().read_only.has_value(); });
  CHECK(cluster.log(1).status().sequence < cluster.stream.state().last);
  const auto refused = answers.send(cluster.log(1), write_at(99, 5));
  REQUIRE_FALSE(refused.has_value());
  CHECK(refused.error().kind == LogFailure::Kind::unwritable);
  cluster.nodes[1]->disk().empty();
  cluster.until_applied();
  CHECK(cluster.log(1).status().head == cluster.log(0).status().head);
}

TEST_CASE("an edit that no message has room for is refused before it is in the log") {
  Cluster cluster{1};
  cluster.open();
  Answers answers;
  REQUIRE(answers.apply(cluster.log(0), attach()).has_value());
  edits::EditEntry large = write_at(1, 5);
  for (std::int64_t i = 0; i < 60'000; ++i) {
    const std::int64_t side = i % 2 == 0 ? 1 : -1;
    large.edit.writes.push_back({{side * (1'000'000'000 + i), i % 7, side * 100'000}, MaterialId{500}});
  }
  const auto refused = answers.send(cluster.log(0), std::move(large));
  REQUIRE_FALSE(refused.has_value());
  CHECK(refused.error().kind == LogFailure::Kind::too_large);
  CHECK(answers.apply(cluster.log(0), write_at(2, 5))->kind == Kind::done);
}

}  // namespace talus::server
