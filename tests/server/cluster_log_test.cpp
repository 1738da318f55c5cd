// One server's end of the shared log: what it takes, what it applies, and when it takes nothing.
#include <fmt/format.h>
#include <catch2/catch.hpp>

#include <talus/store/acknowledged_file.h>

#include "cluster/batch_time.h"
#include "cluster/entry_codec.h"
#include "cluster_in_memory.h"

namespace talus::server {
namespace {

using namespace testing;
using namespace std::chrono_literals;
using cluster::StoreLoss;
using Kind = edits::EntryResult::Kind;

TEST_CASE("an edit sent to one server is applied by all, and answered by that server") {
  ClusterInMemory cluster{3};
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
  ClusterInMemory cluster{2};
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
  ClusterInMemory cluster{2};
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
  CHECK(why.code == EditErrorCode::cut_off);
  until([&] { return !cluster.log(0).takes_entries(); });
  const auto late = answers.send(cluster.log(0), write_at(3, 7));
  REQUIRE_FALSE(late.has_value());
  CHECK(late.error().code == EditErrorCode::cut_off);
  CHECK_FALSE(cluster.log(0).takes_entries());
  CHECK(cluster.log(0).status().ready);  // or a balancer would drop all servers
  CHECK_FALSE(cluster.log(0).status().quorum);
  CHECK_FALSE(answers.has(*doubtful));
  cluster.stream.set_quorum(true);
  CHECK(answers.await(*doubtful)->kind == Kind::done);
  until([&] { return cluster.log(0).takes_entries(); });
  CHECK(answers.apply(cluster.log(0), write_at(3, 7))->kind == Kind::done);
}

TEST_CASE("a server whose store was moved away applies nothing and is not ready until it is back") {
  ClusterInMemory cluster{2};
  cluster.open();
  Answers answers;
  REQUIRE(answers.apply(cluster.log(0), attach()).has_value());
  cluster.until_applied();
  until([&] { return cluster.log(1).status().ready; });
  const std::filesystem::path database = cluster.scratch / "1/db";
  std::filesystem::rename(database, cluster.scratch / "away");
  until([&] { return !cluster.log(1).status().ready; });
  CHECK_THAT(cluster.log(1).status().not_ready, Catch::Contains("db was deleted or replaced"));
  const std::uint64_t before = cluster.log(1).status().head.position;
  REQUIRE(answers.apply(cluster.log(0), write_at(1, 5)).has_value());
  until([&] { return cluster.log(1).status().lag > 0; });
  CHECK(cluster.log(1).status().head.position == before);
  CHECK_FALSE(cluster.log(1).takes_entries());
  std::filesystem::rename(cluster.scratch / "away", database);
  cluster.until_applied();
  until([&] { return cluster.log(1).status().ready; });
}

TEST_CASE("a server whose disk does not end a sync for more than 5 s says so until it does") {
  ClusterInMemory cluster{1};
  cluster.open();
  Answers answers;
  REQUIRE(answers.apply(cluster.log(0), attach()).has_value());
  until([&] { return cluster.log(0).status().ready; });
  ClusterNode& node = *cluster.nodes[0];
  node.disk().hold_syncs(true);
  REQUIRE(answers.apply(cluster.log(0), write_at(1, 5)).has_value());
  node.disk().await_held_sync();
  node.clock.later = 6s;
  CHECK_THAT(cluster.log(0).status().disk_wait,
             Catch::Contains("a write has waited for the disk for over 5 s"));
  CHECK(cluster.log(0).status().ready);  // until it is behind the log
  node.disk().hold_syncs(false);
  until([&] { return cluster.log(0).status().disk_wait.empty(); });
}

TEST_CASE("a server whose store is broken and that is behind says both, the store first") {
  ClusterInMemory cluster{2};
  cluster.open();
  Answers answers;
  REQUIRE(answers.apply(cluster.log(0), attach()).has_value());
  cluster.until_applied();
  cluster.nodes[1]->close();
  REQUIRE(answers.apply(cluster.log(0), write_at(1, 5)).has_value());
  cluster.nodes[1]->before_log = [&] { cluster.nodes[1]->disk().fill_after(0); };
  REQUIRE(cluster.nodes[1]->open() == "");
  cluster::ClusterLog::State status;
  until([&] {
    status = cluster.log(1).status();
    return status.lag > 0 && status.not_ready.find("behind the log's end") != std::string::npos &&
           status.not_ready.find("space") != std::string::npos;
  });
  CAPTURE(status.not_ready);
  CHECK(status.not_ready.starts_with(status.read_only.value_or("?")));
  cluster.nodes[1]->disk().empty();
  cluster.until_applied();
  until([&] { return cluster.log(1).status().ready; });
}

TEST_CASE("a server that starts while the log is away is ready with what it has, unless that is nothing") {
  ClusterInMemory cluster{2};
  cluster.nodes[0]->settings.poll_interval = 1ms;
  REQUIRE(cluster.nodes[0]->open() == "");
  Answers answers;
  REQUIRE(answers.apply(cluster.log(0), attach()).has_value());
  cluster.nodes[0]->close();
  cluster.stream.set_quorum(false);
  cluster.open();
  until([&] { return cluster.log(0).status().ready; });
  const auto status = cluster.log(0).status();
  REQUIRE(status.read_only.has_value());
  CHECK_THAT(*status.read_only, Catch::Contains("cannot be reached or read, or has no quorum: no answer"));
  CHECK_FALSE(status.quorum);
  const auto refused = answers.send(cluster.log(0), write_at(1, 5));
  REQUIRE_FALSE(refused.has_value());
  CHECK(refused.error().code == EditErrorCode::cut_off);
  until([&] { return cluster.log(1).status().not_ready == "no answer"; });
  cluster.stream.set_quorum(true);
  // It finds its place later than it is asked where the end is.
  until([&] {
    REQUIRE(cluster.log(0).status().ready);
    return cluster.log(0).takes_entries();
  });
  CHECK(answers.apply(cluster.log(0), write_at(1, 5))->kind == Kind::done);
  until([&] { return cluster.log(1).status().ready && cluster.log(0).status().ready; });
  SECTION("but not where the stream is found to be another") {
    cluster.nodes[0]->close();
    cluster.stream.set_quorum(false);
    REQUIRE(cluster.nodes[0]->open() == "");
    until([&] { return cluster.log(0).status().ready; });
    cluster.stream.make_anew();
    cluster.stream.set_quorum(true);
    until([&] { return !cluster.log(0).status().ready && cluster.lost_of(0) == StoreLoss::other; });
  }
}

TEST_CASE("a stream that lost its end and went on is found out, though the server was away meanwhile") {
  ClusterInMemory cluster{2};
  cluster.open();
  Answers answers;
  REQUIRE(answers.apply(cluster.log(0), attach()).has_value());
  REQUIRE(answers.apply(cluster.log(0), write_at(1, 5)).has_value());
  REQUIRE(answers.apply(cluster.log(0), write_at(2, 6)).has_value());
  cluster.until_applied();
  const edits::Head before = cluster.log(1).status().head;
  const std::uint64_t applied = cluster.log(1).status().sequence;
  for (auto& node : cluster.nodes) node->close();
  cluster.stream.lose_end(1);
  const auto append_foreign = [&](std::uint64_t number) {
    cluster::BatchHead head = foreign_head();
    head.number = number;
    head.revision = 0;
    cluster.stream.append(
        cluster::encode_batch(head, nullptr, std::vector<store::Bytes>{bytes_of_entry(attach(number))}));
  };
  SECTION("while it was away") {
    append_foreign(1);
    append_foreign(2);
    REQUIRE(cluster.nodes[1]->open() == "");
  }
  SECTION("while it waited for the end") {
    REQUIRE(cluster.nodes[1]->open() == "");
    until([&] { return cluster.log(1).status().not_ready.find("lost its end") != std::string::npos; });
    CHECK_FALSE(cluster.log(1).takes_entries());
    CHECK_FALSE(cluster.lost_of(1).has_value());
    append_foreign(1);
    append_foreign(2);
  }
  until([&] { return cluster.lost_of(1).has_value(); });
  CHECK(cluster.lost_of(1) == StoreLoss::other);
  CHECK_THAT(cluster.why[1], Catch::Contains(fmt::format("message {} of the stream is another", applied)));
  CHECK_FALSE(cluster.log(1).takes_entries());
  CHECK_FALSE(cluster.log(1).status().ready);
  CHECK(cluster.log(1).status().head == before);
  // And at every start again.
  cluster.nodes[1]->close();
  {
    const std::lock_guard lock{cluster.mutex};
    cluster.lost[1].reset();
  }
  REQUIRE(cluster.nodes[1]->open() == "");
  until([&] { return cluster.lost_of(1) == StoreLoss::other; });
}

TEST_CASE("a stream that gets its end again is gone on with, and so is one that keeps nothing old") {
  ClusterInMemory cluster{1};
  cluster.open();
  Answers answers;
  REQUIRE(answers.apply(cluster.log(0), attach()).has_value());
  REQUIRE(answers.apply(cluster.log(0), write_at(1, 5)).has_value());
  const std::uint64_t last = cluster.stream.state().last;
  cluster.nodes[0]->close();
  SECTION("a leader that did not know it") {
    cluster.stream.say_fewer(1);
    REQUIRE(cluster.nodes[0]->open() == "");
    until([&] { return cluster.log(0).status().not_ready.find("lost its end") != std::string::npos; });
    CHECK_FALSE(cluster.log(0).takes_entries());
    cluster.stream.say_fewer(0);
  }
  SECTION("only what comes next is kept") {
    cluster.stream.keep_from(last + 1);
    REQUIRE(cluster.nodes[0]->open() == "");
  }
  until([&] { return cluster.log(0).status().ready && cluster.log(0).takes_entries(); });
  CHECK(answers.apply(cluster.log(0), write_at(2, 5))->kind == Kind::done);
  CHECK_FALSE(cluster.lost_of(0).has_value());
}

TEST_CASE("a batch that says a time far ahead is dated by the stream, alike everywhere") {
  ClusterInMemory cluster{2};
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
        cluster::encode_batch(head, nullptr, std::vector<store::Bytes>{bytes_of_entry(attach(number))}));
    cluster.until_applied();
    return cluster.log(0).status().head.time_ms;
  };
  CHECK(publish(5) == 5);
  CHECK(publish(began_ms) == began_ms);  // it was long quiet, and the time is right
  for (const std::int64_t ahead : {std::int64_t{50'000}, std::int64_t{200'000}, INT64_MAX - began_ms}) {
    const std::int64_t dated_ms = publish(began_ms + ahead);  // before the clock is asked
    CHECK(dated_ms <= now_ms() + cluster::kClocksDifferMs);
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
  ClusterInMemory cluster{1};
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

TEST_CASE("a full disk stops a server, and it resumes at the same place when there is room") {
  ClusterInMemory cluster{2};
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
  CHECK(refused.error().code == EditErrorCode::unwritable);
  cluster.nodes[1]->disk().empty();
  cluster.until_applied();
  CHECK(cluster.log(1).status().head == cluster.log(0).status().head);
}

TEST_CASE(
    "edits are applied and answered while the disk syncs, and are there after a power cut once it has") {
  ClusterInMemory cluster{1};
  cluster.open();
  ClusterNode& node = *cluster.nodes[0];
  Answers answers;
  REQUIRE(answers.apply(node.log(), attach()).has_value());
  struct SyncHold {
    UnsafeDisk& disk;
    explicit SyncHold(UnsafeDisk& of) : disk{of} { disk.hold_syncs(true); }
    ~SyncHold() { disk.hold_syncs(false); }
  };
  {
    const SyncHold held{node.disk()};
    REQUIRE(answers.apply(node.log(), write_at(1, 5)).has_value());
    node.disk().await_held_sync();
    for (std::uint64_t sequence = 2; sequence < 20; ++sequence) {
      REQUIRE(answers.apply(node.log(), write_at(sequence, 5)).has_value());
    }
  }
  const std::uint64_t last = node.log().status().head.position;
  until([&] {
    const auto file = store::AcknowledgedFile::read(node.env(), (node.path() / "acknowledged").string());
    return file && *file && (*file)->position == last;
  });
  node.cut_power();
  REQUIRE(node.open_store() == "");
  CHECK(node.database().meta().head.position == last);
}

TEST_CASE("a server that is behind asks new editors to return soon, and does not report a full table") {
  ClusterInMemory cluster{1};
  cluster.nodes[0]->state_settings.editor_bytes = EditState::kNewEditorBytes;
  cluster.open();
  Answers answers;
  REQUIRE(answers.apply(cluster.log(0), attach(7)).has_value());
  const auto is_at_end = [&] {
    const auto status = cluster.log(0).status();
    return status.ready && status.lag == 0 && status.sequence == cluster.stream.state().last;
  };
  const auto refused_as = [&](EditErrorCode code) {
    const auto taken = answers.send(cluster.log(0), attach(8));
    const auto room = cluster.log(0).room_for_editor();
    return !taken && taken.error().code == code && !room && room.error().code == code;
  };
  until(is_at_end);
  CHECK(refused_as(EditErrorCode::editors_full));
  cluster.stream.fail_next_as(StreamFailure::Kind::unavailable);
  const std::vector<store::Bytes> elsewhere{bytes_of_entry(attach(8))};
  cluster.stream.append(cluster::encode_batch(foreign_head(), nullptr, elsewhere));
  until([&] { return cluster.log(0).status().lag > 0; });
  CHECK(refused_as(EditErrorCode::cut_off));
  cluster.stream.fail_next_as(std::nullopt);
  until(is_at_end);
  auto again = attach(8);
  again.epoch = 2;
  CHECK(answers.apply(cluster.log(0), again)->kind == Kind::attached);
}

TEST_CASE("an edit that no message has room for is refused before it is in the log") {
  ClusterInMemory cluster{1};
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
  CHECK(refused.error().code == EditErrorCode::out_of_range);
  CHECK(answers.apply(cluster.log(0), write_at(2, 5))->kind == Kind::done);
}

TEST_CASE("an edit that no message has room for with what it may reveal is taken, and reveals nothing") {
  ClusterInMemory cluster{1};
  cluster.open();
  Answers answers;
  REQUIRE(answers.apply(cluster.log(0), attach()).has_value());
  edits::EditEntry large = write_at(1, 5);
  large.secrets.see_through = {kAir};
  for (std::int32_t chunk = 0; chunk < 12; ++chunk) {
    for (std::size_t i = 0; i < kChunkVolume; ++i) {
      const auto index = static_cast<std::uint16_t>(i);
      large.secrets.hidden[{chunk, 0, 0}].push_back(
          {index, MaterialId{static_cast<std::uint16_t>(7 + i % 2)}});
      large.secrets.base[{chunk, 0, 0}].push_back({index, MaterialId{static_cast<std::uint16_t>(2 + i % 2)}});
    }
  }
  const auto number = answers.send(cluster.log(0), std::move(large));
  REQUIRE(number.has_value());
  CHECK(answers.await(*number)->kind == Kind::done);
}

TEST_CASE("an edit that the log rejects for now is answered, and the log is tried until it takes edits") {
  ClusterInMemory cluster{1};
  cluster.open();
  Answers answers;
  REQUIRE(answers.apply(cluster.log(0), attach()));
  cluster.stream.fail_publish_as(StreamFailure::Kind::rejected);
  const auto number = answers.send(cluster.log(0), write_at(1, 5));
  REQUIRE(number);
  const auto outcome = answers.await(*number);
  REQUIRE_FALSE(outcome);
  CHECK(outcome.error().code == EditErrorCode::cut_off);
  CHECK(cluster.log(0).status().waiting == 0);
  CHECK_FALSE(cluster.log(0).takes_entries());
  cluster.stream.fail_publish_as(std::nullopt);
  REQUIRE(answers.apply(cluster.log(0), write_at(1, 5)));
  cluster.until_applied();
  CHECK(cluster.nodes[0]->state().head().revision == 1);
}

}  // namespace
}  // namespace talus::server
