// Servers of one cluster in memory, for tests of one server's end of the shared log: entries that are given
// to it, and what becomes of them.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include <catch2/catch.hpp>

#include "cluster/entry_codec.h"
#include "cluster_node.h"
#include "edits/model.h"
#include "scratch_directory.h"
#include "shared_stream.h"

namespace talus::server::testing {

using Outcome = tl::expected<edits::EntryResult, EditError>;

/// Entries that were given to a log, and their answers as they come.
class Answers {
 public:
  /// Whether the log takes it; the answer then has this number.
  tl::expected<std::size_t, EditError> send(EditLog& log, LogEntry entry) {
    std::size_t number = 0;
    {
      const std::lock_guard lock{mutex_};
      number = answers_.size();
      answers_.emplace_back();
    }
    auto taken = log.append(std::move(entry), [this, number](const auto& outcome) {
      // Under the mutex: who has the answer may end this object.
      const std::lock_guard lock{mutex_};
      answers_[number] = outcome ? Outcome{**outcome} : tl::unexpected{outcome.error()};
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
    REQUIRE(comes_.wait_for(lock, std::chrono::seconds{30}, [&] { return answers_[number].has_value(); }));
    return *answers_[number];
  }
  /// Sends it until the log takes it, and waits for the answer.
  Outcome apply(EditLog& log, const LogEntry& entry) {
    const auto give_up = std::chrono::steady_clock::now() + std::chrono::seconds{30};
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

inline void until(const std::function<bool()>& holds) {
  const auto give_up = std::chrono::steady_clock::now() + std::chrono::seconds{30};
  while (!holds()) {
    if (std::chrono::steady_clock::now() > give_up) FAIL("what is waited for does not come");
    std::this_thread::yield();
  }
}

inline edits::EditEntry write_at(std::uint64_t sequence, std::int64_t x, std::uint64_t editor = 7) {
  edits::EditEntry entry{{editor, 9}, 1, sequence, {}, {}};
  entry.edit.writes.push_back({{x, 1, 1}, MaterialId{9}});
  entry.base = edits::testing::base_of(entry.edit);
  return entry;
}
inline edits::AttachEntry attach(std::uint64_t editor = 7) {
  return {{editor, 9}, 1, "somebody"};
}

inline store::Bytes bytes_of_entry(const LogEntry& entry) {
  store::Bytes bytes;
  cluster::encode(entry, bytes);
  return bytes;
}

inline cluster::BatchHead foreign_head() {
  return {kClusterIdentity, 1234, 1, 5, 0, {}};
}

struct ClusterInMemory {
  ScratchDirectory scratch;
  SharedStream stream{empty_genesis()};
  std::vector<std::unique_ptr<ClusterNode>> nodes;
  std::mutex mutex;
  std::vector<std::optional<cluster::StoreLoss>> lost;
  std::vector<std::string> why;

  explicit ClusterInMemory(std::size_t count) : lost(count), why(count) {
    for (std::size_t i = 0; i < count; ++i) {
      nodes.push_back(
          std::make_unique<ClusterNode>(scratch / std::to_string(i), ends_of(stream, i * 100), i * 100));
      nodes[i]->on_lost = [this, i](cluster::StoreLoss how, const std::string& reason) {
        const std::lock_guard lock{mutex};
        lost[i] = how;
        why[i] = reason;
      };
    }
  }
  ~ClusterInMemory() { nodes.clear(); }
  void open() {
    for (auto& node : nodes) REQUIRE(node->open() == "");
  }
  cluster::ClusterLog& log(std::size_t i) { return nodes[i]->log(); }
  void until_applied() {
    for (auto& node : nodes) until([&] { return node->log().status().sequence == stream.state().last; });
  }
  std::optional<cluster::StoreLoss> lost_of(std::size_t i) {
    const std::lock_guard lock{mutex};
    return lost[i];
  }
};

}  // namespace talus::server::testing
