// The log that servers share over real nats-server processes: editors at three servers at once, while hosts
// of the log die.
#include <algorithm>
#include <condition_variable>
#include <cstdlib>
#include <iostream>
#include <map>
#include <memory>
#include <mutex>
#include <thread>

#include <catch2/catch.hpp>

#include "cluster/jetstream/stream_names.h"
#include "cluster/jetstream/stream_settings.h"
#include "edits/model.h"
#include "opened_stream.h"
#include "scratch_directory.h"
#include "server/cluster_node.h"

namespace talus::server {
namespace {

using namespace std::chrono_literals;
using namespace testing;
using SteadyClock = std::chrono::steady_clock;
using edits::testing::base_of;
using Kind = edits::EntryResult::Kind;

const jetstream::StreamNames kNames = jetstream::StreamNames::of(kClusterIdentity.store_id);

class Servers {
 public:
  explicit Servers(std::size_t servers, nats_test::NatsSettings nats = {}) : nats_{std::move(nats)} {
    nats_test::make_stream(nats_, kNames, nats_.count());
    const auto log = open_log();
    const auto genesis = empty_genesis();
    while (!log->publish(genesis)) {
    }
    for (std::size_t i = 0; i < servers; ++i) {
      nodes_.push_back(std::make_unique<ClusterNode>(
          scratch_ / std::to_string(i), [this] { return open_log(); }, i));
      nodes_.back()->settings = {};
      REQUIRE(nodes_.back()->open() == "");
    }
    until([&] { return std::ranges::all_of(nodes_, [](auto& node) { return node->log().status().ready; }); });
  }

  static void until(const std::function<bool()>& holds) {
    const auto give_up = SteadyClock::now() + 1min;
    while (!holds()) {
      if (SteadyClock::now() > give_up) FAIL("what is waited for does not come");
      std::this_thread::sleep_for(1ms);
    }
  }
  void until_equal() {
    until([&] {
      const auto first = nodes_[0]->log().status().head;
      return std::ranges::all_of(nodes_, [&](auto& node) { return node->log().status().head == first; });
    });
  }

  [[nodiscard]] nats_test::NatsServers& nats() { return nats_; }
  [[nodiscard]] ClusterNode& node(std::size_t i) { return *nodes_[i]; }
  [[nodiscard]] std::size_t size() const { return nodes_.size(); }

 private:
  [[nodiscard]] std::unique_ptr<LogStream> open_log() const {
    return nats_test::open_log(nats_.url_list(), kNames, nats_test::as_talusd());
  }

  ScratchDirectory scratch_;
  nats_test::NatsServers nats_;
  std::vector<std::unique_ptr<ClusterNode>> nodes_;
};

/// Editors who each put one voxel after another, some of them unanswered at a time, and say how long each
/// took.
class Editors {
 public:
  Editors(Servers& cluster, std::size_t count, std::size_t open)
      : cluster_{cluster}, open_{open}, editors_(count) {
    for (std::size_t i = 0; i < count; ++i) {
      editors_[i].id = {i + 1, 1};
      editors_[i].node = i % cluster.size();
      Servers::until([&] {
        return log_of(editors_[i])
            .append(edits::AttachEntry{editors_[i].id, 1, ""},
                    [this, i](const auto& applied) {
                      const std::lock_guard lock{mutex_};
                      editors_[i].attached = applied && (*applied)->kind == Kind::attached;
                    })
            .has_value();
      });
    }
    Servers::until([&] {
      const std::lock_guard lock{mutex_};
      return std::ranges::all_of(editors_, [](const Editor& editor) { return editor.attached; });
    });
  }

  /// Sends up to so many edits a second in all, for so long; then what is open is answered.
  void run(std::chrono::milliseconds time, std::size_t per_second = 0) {
    const auto start = SteadyClock::now();
    std::size_t sent = 0;
    while (SteadyClock::now() - start < time) {
      const auto passed = std::chrono::duration<double>(SteadyClock::now() - start).count();
      const auto may =
          per_second == 0 ? SIZE_MAX : static_cast<std::size_t>(passed * static_cast<double>(per_second));
      bool any = false;
      for (Editor& editor : editors_) {
        if (sent < may && send(editor)) {
          ++sent;
          any = true;
        }
      }
      if (!any) std::this_thread::sleep_for(200us);
    }
    Servers::until([&] {
      const std::lock_guard lock{mutex_};
      return std::ranges::all_of(editors_, [](const Editor& editor) { return editor.waiting == 0; });
    });
  }

  [[nodiscard]] std::size_t done() const { return done_; }
  [[nodiscard]] std::string fault() {
    const std::lock_guard lock{mutex_};
    return fault_;
  }
  [[nodiscard]] std::vector<double> take_times() {
    const std::lock_guard lock{mutex_};
    return std::exchange(times_ms_, {});
  }

 private:
  struct Editor {
    edits::EditorId id;
    std::size_t node = 0;
    bool attached = false;
    std::uint64_t sequence = 0;
    std::size_t waiting = 0;
    std::uint64_t last_revision = 0;
  };

  cluster::ClusterLog& log_of(const Editor& editor) { return cluster_.node(editor.node).log(); }

  bool send(Editor& editor) {
    std::uint64_t sequence = 0;
    {
      const std::lock_guard lock{mutex_};
      if (editor.waiting >= open_) return false;
      ++editor.waiting;
      sequence = editor.sequence + 1;
    }
    edits::EditEntry entry{editor.id, 1, sequence, {}, {}};
    const auto row = static_cast<std::int64_t>(editor.id.low);
    entry.edit.writes.push_back({{static_cast<std::int64_t>(sequence), row % 32, row / 32}, MaterialId{77}});
    entry.base = base_of(entry.edit);
    const auto taken = log_of(editor).append(
        std::move(entry), [this, &editor, sequence, began = SteadyClock::now()](const auto& applied) {
          const std::lock_guard lock{mutex_};
          --editor.waiting;
          if (!applied) {
            refused_ = true;
            return;
          }
          times_ms_.push_back(std::chrono::duration<double, std::milli>(SteadyClock::now() - began).count());
          const edits::EntryResult& outcome = **applied;
          if (outcome.kind != Kind::done || outcome.result.sequence != sequence ||
              outcome.result.changed != 1) {
            fault_ = "an edit was answered as if it were another";
          }
          if (outcome.revision <= editor.last_revision) fault_ = "edits of one editor changed their order";
          editor.last_revision = outcome.revision;
          ++done_;
        });
    const std::lock_guard lock{mutex_};
    if (!taken) {
      --editor.waiting;
      return false;
    }
    editor.sequence = sequence;
    return true;
  }

  Servers& cluster_;
  const std::size_t open_;
  std::mutex mutex_;
  std::vector<Editor> editors_;
  std::vector<double> times_ms_;
  std::atomic<std::size_t> done_{0};
  bool refused_ = false;
  std::string fault_;
};

double at(std::vector<double>& times, double part) {
  if (times.empty()) return 0;
  std::ranges::sort(times);
  return times[std::min(times.size() - 1,
                        static_cast<std::size_t>(part * static_cast<double>(times.size())))];
}

}  // namespace

TEST_CASE("three servers over three hosts of a log agree, and go on when the log's leader is killed") {
  const char* const given = std::getenv("TALUS_KILLS");
  const int kills = given != nullptr ? std::atoi(given) : 1;
  Servers cluster{3};
  Editors editors{cluster, 12, 4};
  editors.run(300ms);
  for (int kill = 0; kill < kills; ++kill) {
    const std::size_t leader = cluster.nats().leader_of(kNames.stream);
    const std::size_t before = editors.done();
    std::thread killer{[&] { cluster.nats().kill(leader); }};
    const auto began = SteadyClock::now();
    editors.run(500ms);  // those in doubt are answered in the end
    killer.join();
    Servers::until([&] {
      editors.run(50ms);
      return editors.done() > before + 20;
    });
    if (given != nullptr) {
      std::cout << "kill " << kill << ": edits flow after "
                << std::chrono::duration<double>(SteadyClock::now() - began).count() << " s\n";
    }
    cluster.nats().start(leader);
    cluster.nats().await_replicas(kNames.stream);
  }
  editors.run(300ms);
  CHECK(editors.fault() == "");
  cluster.until_equal();
  // One revision an edit: none happened twice, and none was lost.
  CHECK(cluster.node(0).log().status().head.revision == editors.done());
  for (std::size_t i = 0; i < 3; ++i) CHECK_FALSE(cluster.node(i).log().status().differs);
}

TEST_CASE("servers that start next to a replica with other messages continue, and agree") {
  Servers cluster{3};
  Editors editors{cluster, 12, 4};
  editors.run(300ms);
  // A replica of nats-server 2.9.10 takes its newest message twice after this.
  nats_test::publish_to_be_refused(cluster.nats(), kNames.log, "no");
  editors.run(100ms);
  cluster.nats().await_replicas(kNames.stream);
  const std::size_t wrong = (cluster.nats().leader_of(kNames.stream) + 1) % 3;
  cluster.nats().kill(wrong);
  cluster.nats().start(wrong);
  cluster.nats().await_ready();
  cluster.nats().await_replicas(kNames.stream);
  const auto last = nats_test::last_of_each(cluster.nats(), kNames.stream);
  if (std::ranges::count(last, last.front()) == 3) WARN("this nats-server takes no message twice");
  editors.run(300ms);
  cluster.until_equal();
  for (std::size_t i = 0; i < 3; ++i) {
    ClusterNode& node = cluster.node(i);
    std::string why;
    node.on_lost = [&](cluster::StoreLoss, const std::string& reason) { why = reason; };
    node.close();
    REQUIRE(node.open() == "");
    Servers::until([&] { return node.log().status().ready || !why.empty(); });
    CHECK(why == "");
  }
  editors.run(300ms);
  CHECK(editors.fault() == "");
  cluster.until_equal();
  CHECK(cluster.node(0).log().status().head.revision == editors.done());
}

TEST_CASE("a server that may not read the log's messages any more is cut off, until it may again") {
  Servers cluster{1, {.servers = 1, .more = nats_test::talusd_permissions()}};
  ClusterNode& node = cluster.node(0);
  std::mutex mutex;
  int answers = 0;
  const auto has_answers = [&](int wanted) {
    const std::lock_guard lock{mutex};
    return answers == wanted;
  };
  const auto append = [&](LogEntry entry) {
    return node.log().append(std::move(entry), [&](const auto& applied) {
      const std::lock_guard lock{mutex};
      CHECK((applied && (*applied)->kind != Kind::expired));
      ++answers;
    });
  };
  const auto write = [](std::uint64_t sequence) {
    edits::EditEntry entry{{1, 1}, 1, sequence, {}, {}};
    entry.edit.writes.push_back({{static_cast<std::int64_t>(sequence), 0, 0}, MaterialId{77}});
    entry.base = base_of(entry.edit);
    return entry;
  };
  REQUIRE(append(edits::AttachEntry{{1, 1}, 1, ""}));
  Servers::until([&] { return has_answers(1); });

  cluster.nats().reconfigure(nats_test::talusd_permissions({.messages = false}));
  // The tail brings an edit, and of one with such a time the stream is asked.
  node.clock.ahead = 10min;
  REQUIRE(append(write(1)));
  Servers::until([&] { return !node.log().takes_entries(); });
  const auto status = node.log().status();
  CHECK_FALSE(status.quorum);
  CHECK(status.connected);
  CHECK(status.ready);
  REQUIRE(status.read_only);
  CHECK_THAT(*status.read_only, Catch::Contains("cannot be reached or read") && Catch::Contains("MSG.GET"));
  const auto refused = append(write(2));
  REQUIRE_FALSE(refused);
  CHECK(refused.error().code == EditErrorCode::cut_off);
  CHECK(has_answers(1));

  cluster.nats().reconfigure(nats_test::talusd_permissions());
  Servers::until([&] { return has_answers(2) && node.log().takes_entries(); });
  CHECK(node.log().status().ready);
  REQUIRE(append(write(2)));
  Servers::until([&] { return has_answers(3); });
  CHECK(node.log().status().head.revision == 2);
}

TEST_CASE("edits that a limit of the stream refuses are answered, and others go on when it is lifted") {
  Servers cluster{2, {.servers = 1}};
  Editors editors{cluster, 4, 2};
  editors.run(100ms);
  cluster.until_equal();
  const std::size_t before = editors.done();
  auto settings = jetstream::wanted_settings(kNames, 1);
  settings["discard"] = "new";
  settings["max_msgs"] = 1;
  const std::string update = "$JS.API.STREAM.UPDATE." + kNames.stream;
  nats_test::ask(cluster.nats(), update, settings.dump());
  editors.run(10ms);  // until each that was taken is answered
  CHECK(editors.done() == before);
  Servers::until([&] { return cluster.node(0).log().status().read_only.has_value(); });
  const auto status = cluster.node(0).log().status();
  CHECK(status.ready);
  CHECK_THAT(*status.read_only, Catch::Contains("maximum messages exceeded"));

  nats_test::ask(cluster.nats(), update, jetstream::wanted_settings(kNames, 1).dump());
  Servers::until([&] {
    editors.run(10ms);
    return editors.done() > before + 20;
  });
  CHECK(editors.fault() == "");
  cluster.until_equal();
  CHECK(cluster.node(0).log().status().head.revision == editors.done());
}

TEST_CASE("how long edits take over a log of three hosts", "[.figures]") {
  Servers cluster{3};
  Editors editors{cluster, 96, 16};
  editors.run(2s, 1'000);
  (void)editors.take_times();
  for (const std::size_t rate : {1'000U, 10'000U}) {
    editors.run(10s, rate);
    auto times = editors.take_times();
    std::cout << rate << " edits/s wanted, " << times.size() / 10 << " done: p50 " << at(times, 0.5)
              << " ms, p99 " << at(times, 0.99) << " ms, most " << at(times, 1) << " ms\n";
  }
  CHECK(editors.fault() == "");
  cluster.until_equal();
  CHECK(cluster.node(0).log().status().head.revision == editors.done());
}

}  // namespace talus::server
