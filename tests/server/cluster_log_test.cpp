// One server's end of the shared log: what it takes, what it applies, and when it stops.
#include <condition_variable>
#include <fstream>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include <fmt/format.h>
#include <rocksdb/db.h>
#include <catch2/catch.hpp>

#include "cluster/batch_time.h"
#include "cluster/entry_codec.h"
#include "cluster/server_number.h"
#include "cluster_node.h"
#include "edits/model.h"
#include "scratch_directory.h"
#include "sealed_again.h"
#include "shared_stream.h"
#include "store/bytes.h"
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

/// Messages that this talusd does not know, and those to come may.
std::vector<Bytes> unknown_messages() {
  const std::vector<Bytes> good{bytes_of_entry(attach(8))};
  std::vector<Bytes> messages(2, cluster::encode_batch(foreign_head(), nullptr, good));
  messages[0][0] = std::byte{9};
  messages[1][1] = std::byte{9};
  for (Bytes& each : messages) each = sealed_again(each);
  std::vector<Bytes> entries{good[0], bytes_of_entry(attach(9))};
  entries[1][0] = std::byte{7};
  messages.push_back(cluster::encode_batch(foreign_head(), nullptr, entries));
  return messages;
}

TEST_CASE("a message of a format that the stream has not enabled is passed over by all servers alike") {
  Cluster cluster{2};
  SECTION("nor any other") {}
  SECTION("but that which is known") {
    cluster.stream.enable({cluster::kLogFormat, 1});
  }
  SECTION("but from a later message on") {
    cluster.stream.enable({cluster::kLogFormat + 1, 6});
  }
  cluster.open();
  cluster.until_applied();
  for (const Bytes& each : unknown_messages()) cluster.stream.append(each);
  const std::vector<Bytes> good{bytes_of_entry(attach(8))};
  cluster.stream.append(cluster::encode_batch(foreign_head(), nullptr, good));
  cluster.until_applied();
  for (std::size_t i = 0; i < 2; ++i) {
    CHECK(cluster.log(i).status().skipped == 3);
    CHECK(cluster.log(i).status().head.position == 1);
    CHECK_FALSE(cluster.log(i).status().stuck);
  }
  // From where it is enabled on nobody passes over such.
  cluster.stream.enable({cluster::kLogFormat + 1, 6});
  cluster.stream.append(unknown_messages().front());
  until([&] { return cluster.log(0).status().stuck && cluster.log(1).status().stuck; });
  // Who reads all of it later does as they did.
  cluster.nodes.push_back(
      std::make_unique<ClusterNode>(cluster.scratch / "late", ends_of(cluster.stream, 900), 900));
  REQUIRE(cluster.nodes.back()->open() == "");
  until([&] { return cluster.log(2).status().stuck; });
  CHECK(cluster.log(2).status().skipped == 3);
  CHECK(cluster.log(2).status().head.hash == cluster.log(0).status().head.hash);
}

TEST_CASE("of several formats that are enabled the first that this talusd does not read stops it") {
  Cluster cluster{1};
  cluster.stream.describe(fmt::format("log format {} from message 5, {} from message 9",
                                      cluster::kLogFormat + 1, cluster::kLogFormat + 2));
  cluster.open();
  for (const Bytes& each : unknown_messages()) cluster.stream.append(each);  // 2 to 4
  cluster.until_applied();
  CHECK(cluster.log(0).status().skipped == 3);
  CHECK_FALSE(cluster.log(0).status().stuck);
  cluster.stream.append(unknown_messages().front());
  until([&] { return cluster.log(0).status().stuck || cluster.log(0).status().skipped > 3; });
  CHECK(cluster.log(0).status().stuck);
  CHECK(cluster.log(0).status().sequence == 4);
}

TEST_CASE("a description of formats that is not understood stops a server, and it says so") {
  Cluster cluster{1};
  cluster.stream.describe("log format 2 from message 5.");
  cluster.open();
  const std::vector<Bytes> good{bytes_of_entry(attach(8))};
  cluster.stream.append(cluster::encode_batch(foreign_head(), nullptr, good));
  cluster.until_applied();  // what it knows it applies
  CHECK(cluster.log(0).status().head.position == 1);
  cluster.stream.append(unknown_messages().front());
  until([&] { return cluster.log(0).status().stuck || cluster.log(0).status().skipped > 0; });
  CHECK(cluster.log(0).status().stuck);
  CHECK(cluster.log(0).status().skipped == 0);
  CHECK_THAT(cluster.log(0).status().read_only.value_or(""),
             Catch::Contains("message 3") && Catch::Contains("it has format 9") &&
                 Catch::Contains("description") && Catch::Contains("talusd cluster check"));
  // It was a slip: once that is mended the server passes over it, as all others.
  cluster.stream.describe("log format 2 from message 5");
  cluster.nodes[0]->close();
  cluster.open();
  cluster.until_applied();
  CHECK(cluster.log(0).status().skipped == 1);
}

TEST_CASE("a message that is not known is not passed over where the stream is another by then") {
  Cluster cluster{1};
  cluster.nodes[0]->settings.look_interval = 1h;  // so that it is this message by which it is found
  cluster.open();
  cluster.until_applied();
  cluster.stream.make_anew();
  cluster.stream.append(unknown_messages().front());
  until([&] { return cluster.lost_of(0).has_value() || cluster.log(0).status().skipped > 0; });
  CHECK(cluster.lost_of(0) == Lost::other);
  CHECK(cluster.log(0).status().skipped == 0);
}

TEST_CASE("a genesis of a newer talusd stops a server, and it says what would be right") {
  Cluster cluster{1};
  cluster.stream.replace_first(of_newer_format(empty_genesis()));
  cluster.open();
  until([&] {
    return cluster.log(0).status().read_only ==
           "message 1 of the log cannot be applied: it has format 9; this talusd reads up to 1; upgrade it";
  });
}

TEST_CASE("a message that is not known waits for a leader that knows it") {
  Cluster cluster{1};
  cluster.nodes[0]->settings.look_interval = 1h;  // so that it asks for this message alone
  cluster.open();
  cluster.until_applied();
  cluster.stream.say_fewer(1);
  cluster.stream.append(unknown_messages().front());
  const std::uint64_t asked = cluster.stream.asked;
  until([&] { return cluster.stream.asked > asked + 3; });
  CHECK(cluster.log(0).status().skipped == 0);
  cluster.stream.enable({cluster::kLogFormat + 1, 2});
  cluster.stream.say_fewer(0);
  until([&] { return cluster.log(0).status().stuck; });
  CHECK(cluster.log(0).status().skipped == 0);
}

TEST_CASE("a message of a newer talusd stops a server there, and it says why") {
  Cluster cluster{1};
  cluster.stream.enable({cluster::kLogFormat + 1, 2});
  std::string why;
  const std::vector<Bytes> good{bytes_of_entry(attach(8))};
  SECTION("a format") {
    Bytes message = cluster::encode_batch(foreign_head(), nullptr, good);
    message[0] = std::byte{9};
    cluster.stream.append(sealed_again(message));
    why = "message 2 of the log cannot be applied: it has format 9; this talusd reads up to 1; upgrade it";
  }
  SECTION("a kind") {
    Bytes message = cluster::encode_batch(foreign_head(), nullptr, good);
    message[1] = std::byte{9};
    cluster.stream.append(sealed_again(message));
    why = "message 2 of the log cannot be applied: it is of kind 9, which this talusd does not know";
  }
  SECTION("an entry") {
    std::vector<Bytes> entries = good;
    entries.push_back(bytes_of_entry(attach(9)));
    entries[1][0] = std::byte{7};
    cluster.stream.append(cluster::encode_batch(foreign_head(), nullptr, entries));
    why = "message 2 of the log cannot be applied: its entry 2 is one that this talusd does not know";
  }
  SECTION("an entry behind one that is damaged") {
    std::vector<Bytes> entries{bytes_of_entry(attach(8)), bytes_of_entry(attach(9))};
    entries[0].pop_back();
    entries[1][1] = std::byte{7};
    cluster.stream.append(cluster::encode_batch(foreign_head(), nullptr, entries));
    why = "message 2 of the log cannot be applied: its entry 2 is one that this talusd does not know";
  }
  // What is behind it is sound, and must not be applied.
  cluster.stream.append(cluster::encode_batch(foreign_head(), nullptr, good));
  cluster.open();
  until([&] { return cluster.log(0).status().not_ready.find("cannot be applied") != std::string::npos; });
  const auto status = cluster.log(0).status();
  CAPTURE(status.not_ready);
  CHECK(status.not_ready.starts_with(why));
  CHECK(status.stuck);
  CHECK(status.head.position == 0);
  CHECK(status.skipped == 0);
  Answers answers;
  const auto refused = answers.send(cluster.log(0), attach());
  REQUIRE_FALSE(refused.has_value());
  CHECK(refused.error().reason.starts_with(why));
  CHECK_FALSE(cluster.lost_of(0).has_value());  // another store would not help
}

TEST_CASE("a message that no talusd wrote is passed over by all servers alike") {
  Cluster cluster{2};
  const std::vector<Bytes> entries{bytes_of_entry(attach(8)), bytes_of_entry(attach(9))};
  const Bytes good = cluster::encode_batch(foreign_head(), nullptr, entries);
  Bytes bad = good;
  SECTION("damaged") {
    bad[40] ^= std::byte{1};
  }
  SECTION("nothing") {
    bad.clear();
  }
  SECTION("a word of somebody's") {
    bad.assign(5, std::byte{'h'});
  }
  SECTION("of no format") {
    bad.assign(100, std::byte{0});
  }
  SECTION("of a newer one, without the checksum that all have") {
    bad[0] = std::byte{9};
  }
  SECTION("too large") {
    bad.assign(cluster::kMaxMessageBytes + 1, std::byte{1});
  }
  SECTION("of another store") {
    cluster::BatchHead head = foreign_head();
    head.identity.store_id = {9, 9};
    bad = cluster::encode_batch(head, nullptr, entries);
  }
  SECTION("of another world") {
    cluster::BatchHead head = foreign_head();
    head.identity.fingerprint = {9, 9};
    bad = cluster::encode_batch(head, nullptr, entries);
  }
  SECTION("a second genesis") {
    bad = empty_genesis();
  }
  SECTION("fields that end early") {
    bad.resize(bad.size() - 20);
    bad = sealed_again(bad);
  }
  SECTION("an entry that is damaged behind one that is not") {
    std::vector<Bytes> damaged = entries;
    damaged[1].pop_back();
    bad = cluster::encode_batch(foreign_head(), nullptr, damaged);
  }
  cluster.stream.append(bad);
  cluster.stream.append(good);
  cluster.open();
  cluster.until_applied();
  Answers answers;
  REQUIRE(answers.apply(cluster.log(0), attach()));
  cluster.until_applied();
  for (std::size_t i = 0; i < 2; ++i) {
    const auto status = cluster.log(i).status();
    CAPTURE(i, status.not_ready, status.read_only.value_or(""));
    CHECK(status.skipped == 1);
    CHECK(status.head.position == 3);  // of the three that attached
    CHECK_FALSE(status.read_only.has_value());
  }
  // It is behind them when they start again.
  for (auto& node : cluster.nodes) node->close();
  cluster.open();
  cluster.until_applied();
  CHECK(cluster.log(0).status().skipped == 0);
}

TEST_CASE("players may look on while no server can read the next message, and not where others can") {
  Cluster cluster{2};
  cluster.stream.enable({cluster::kLogFormat + 1, 2});
  for (auto& node : cluster.nodes) node->settings.sure_of_stuck = 300ms;
  cluster.open();
  until([&] { return cluster.log(0).status().ready && cluster.log(1).status().ready; });
  Bytes message = cluster::encode_batch(foreign_head(), nullptr, {});
  message[0] = std::byte{9};
  cluster.stream.append(sealed_again(message));
  until([&] { return cluster.log(0).status().stuck && cluster.log(1).status().stuck; });
  const auto began = std::chrono::steady_clock::now();
  // Well over the time in which it would be too far behind the end, if it were looked at so.
  while (std::chrono::steady_clock::now() - began < 600ms) {
    const auto status = cluster.log(0).status();
    if (!status.ready) FAIL(status.not_ready);
    CHECK(status.read_only.value_or("").find("it has format 9") != std::string::npos);
    std::this_thread::sleep_for(20ms);
  }
  // Started again it serves as well, once it knows that it is no worse than others.
  cluster.nodes[1]->close();
  REQUIRE(cluster.nodes[1]->open() == "");
  until([&] { return cluster.log(1).status().stuck; });
  until([&] { return cluster.log(1).status().ready; });
  // A newer talusd goes on.
  cluster.stream.append(cluster::encode_batch(foreign_head(), nullptr, {}));
  until([&] { return !cluster.log(0).status().ready && !cluster.log(1).status().ready; });
}

TEST_CASE("a batch that says a time far ahead is dated by the stream, alike everywhere") {
  Cluster cluster{2};
  cluster.open();
  const auto now_ms = [] {
    return std::chrono::duration_cast<std::chrono::milliseconds>(
               std::chrono::system_clock::now().time_since_epoch())
        .count();
  };
  const std::int64_t began_ms = now_ms();
  std::uint64_t number = 0;
  const auto publish = [&](std::int64_t time_ms) {
    cluster::BatchHead head = foreign_head();
    head.number = ++number;
    head.time_ms = time_ms;
    cluster.stream.append(
        cluster::encode_batch(head, nullptr, std::vector<Bytes>{bytes_of_entry(attach(number))}));
    cluster.until_applied();
    return cluster.log(0).status().head.time_ms;
  };
  CHECK(publish(5) == 5);
  CHECK(publish(began_ms) == began_ms);  // it was long quiet, and the time is right
  for (const std::int64_t ahead : {std::int64_t{50'000}, std::int64_t{200'000}, INT64_MAX - began_ms}) {
    CHECK(publish(began_ms + ahead) <= now_ms() + cluster::kClocksDifferMs);
  }
  // Nor by steps that are small each.
  std::int64_t time_ms = 0;
  for (int i = 0; i < 20; ++i) time_ms = publish(cluster.log(0).status().head.time_ms + 50'000);
  CHECK(time_ms <= now_ms() + 2 * cluster::kClocksDifferMs);
  CHECK(cluster.log(0).status().bounded > 0);
  // A server that reads all of it later comes to the same.
  cluster.nodes.push_back(
      std::make_unique<ClusterNode>(cluster.scratch / "late", ends_of(cluster.stream, 900), 900));
  REQUIRE(cluster.nodes.back()->open() == "");
  cluster.until_applied();
  CHECK(cluster.log(1).status().head == cluster.log(0).status().head);
  CHECK(cluster.log(2).status().head == cluster.log(0).status().head);
  CHECK(cluster.nodes[2]->database().meta().stream == cluster.nodes[0]->database().meta().stream);
}

TEST_CASE("a server whose clock is far ahead dates what it writes by the stream, once it knows") {
  Cluster cluster{1};
  cluster.nodes[0]->clock.ahead = 24h * 365;
  cluster.open();
  Answers answers;
  REQUIRE(answers.apply(cluster.log(0), attach(8)));
  CHECK(cluster.log(0).status().bounded == 1);
  const std::int64_t right_ms = *cluster.stream.time_of(2);
  REQUIRE(answers.apply(cluster.log(0), attach(9)));
  const auto batch = cluster::decode_batch(cluster.stream.all().back(), kClusterIdentity);
  REQUIRE(batch.has_value());
  CHECK(batch->head.time_ms >= right_ms);
  CHECK(batch->head.time_ms <= right_ms + 30'000);
  CHECK(cluster.log(0).status().bounded == 1);
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
  cluster.stream.fail_next_as(StreamFailure::Kind::other);
  const auto open = answers.await(*doubtful);
  REQUIRE_FALSE(open.has_value());
  CHECK(open.error().kind == LogFailure::Kind::unwritable);
  CHECK_THAT(open.error().reason, Catch::Contains("it is another"));
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
