// Several servers over one stream, whose messages come late and twice, with power cuts that take what was not
// synced: every server comes to the same state, and every edit is answered, and happened, once.
#include <condition_variable>
#include <cstdlib>
#include <iostream>
#include <map>
#include <mutex>
#include <random>

#include <catch2/catch.hpp>

#include "cluster/entry_codec.h"
#include "cluster_node.h"
#include "edits/model.h"
#include "scratch_directory.h"
#include "seed_of_run.h"
#include "shared_stream.h"

namespace talus::server {
namespace {

using namespace testing;
using edits::testing::base_of;
using edits::testing::Model;
using Kind = edits::EntryResult::Kind;
using std::chrono::milliseconds;

/// A message that this talusd does not know, and that nobody has enabled.
store::Bytes of_a_format_to_come() {
  const std::vector<store::Bytes> entries{{std::byte{9}, std::byte{9}}};
  return cluster::encode_batch({kClusterIdentity, 1234, 1, 5, 1'000'000, {}}, nullptr, entries);
}

/// A player whose edits are answered by whichever server it is connected to.
struct Player {
  edits::EditorId id;
  std::size_t node = 0;
  std::uint64_t connection = 0;  // raised where it goes elsewhere: answers to the one before come late
  std::uint64_t epoch = 0;       // 0: not attached
  bool attaching = false;
  std::uint64_t sequence = 0;
  std::map<std::uint64_t, edits::Edit> open;  // not answered, by sequence
  std::map<std::uint64_t, bool> in_flight;    // of those
  std::map<std::uint64_t, edits::EditResult> told;
  std::map<std::uint64_t, bool> not_applied;  // what the player was told did not happen
};

class ClusterModel {
 public:
  ClusterModel(std::uint64_t seed, std::size_t nodes, std::size_t players)
      : random_{seed}, stream_{empty_genesis()}, players_(players) {
    const StreamFaults faults{.lost = 20, .unacked = 20, .holes = 30, .late_us = 500};
    for (std::size_t i = 0; i < nodes; ++i) {
      nodes_.push_back(std::make_unique<ClusterNode>(
          scratch_ / ("node" + std::to_string(i)), ends_of(stream_, seed + i * 100, faults), seed + i * 100));
      nodes_.back()->on_changed = [this](const edits::Head& head) {
        const std::lock_guard lock{mutex_};
        states_.emplace(head.revision, head.hash);
        if (states_.at(head.revision) != head.hash) differ_ = true;
      };
      nodes_.back()->on_lost = [this](cluster::StoreLoss, const std::string& why) {
        const std::lock_guard lock{mutex_};
        lost_ = why;
      };
    }
    for (std::size_t i = 0; i < players; ++i) {
      players_[i].id = {i + 1, seed};
      players_[i].node = i % nodes;
    }
  }

  /// The first fault, or nothing.
  std::string run(int faults) {
    for (auto& node : nodes_) {
      if (const std::string error = node->open(); !error.empty()) return error;
    }
    for (int i = 0; i < faults; ++i) {
      if (std::string fault = play(20 + random_() % 60, true); !fault.empty()) return fault;
      if (std::string fault = disturb(); !fault.empty()) return fault;
    }
    stream_.set_quorum(true);
    if (std::string fault = play(0, false); !fault.empty()) return fault;
    if (std::string fault = wait_until_all_applied(); !fault.empty()) return fault;
    return compare();
  }

  [[nodiscard]] std::size_t answered() {
    const std::lock_guard lock{mutex_};
    return answered_;
  }
  [[nodiscard]] std::size_t messages() const { return stream_.state().last; }

 private:
  std::string disturb() {
    switch (random_() % 8) {
      case 0:
        stream_.set_quorum(false);
        if (std::string fault = play(0, true, milliseconds{200}); !fault.empty()) return fault;
        stream_.set_quorum(true);
        return {};
      case 1:
      case 2:
        for (int i = 0; i < 5; ++i) stream_.repeat_any(random_);
        stream_.append(of_a_format_to_come());
        return {};
      default: {
        const std::size_t victim = random_() % nodes_.size();
        ClusterNode& node = *nodes_[victim];
        {
          const std::lock_guard lock{mutex_};
          for (Player& player : players_) {
            if (player.node == victim)
              go_to(player, (victim + 1 + random_() % (nodes_.size() - 1)) % nodes_.size());
          }
        }
        if (random_() % 3 == 0) {
          node.close();
        } else {
          node.cut_power();
        }
        if (std::string fault = play(1 + random_() % 40, true); !fault.empty()) return fault;
        return node.open();
      }
    }
  }

  void go_to(Player& player, std::size_t node) {
    player.node = node;
    ++player.connection;
    player.epoch = 0;
    player.attaching = false;
    for (auto& [sequence, flies] : player.in_flight) flies = false;
  }

  edits::Edit any_edit() {
    edits::Edit edit;
    const auto place = [&]() -> VoxelPos {
      const auto near = [&] { return static_cast<std::int64_t>(random_() % 12) - 6; };
      return {near() + (random_() % 2 == 0 ? 0 : 320), near(), near()};
    };
    const auto material = [&] { return MaterialId{static_cast<std::uint16_t>(random_() % 5)}; };
    for (std::uint64_t left = 1 + random_() % 3; left > 0; --left)
      edit.writes.push_back({place(), material()});
    if (random_() % 8 == 0) edit.guards.push_back({place(), material()});
    return edit;
  }

  /// Until so many more edits are answered, or, without `sends`, until all are.
  std::string play(std::size_t more, bool sends, milliseconds most = std::chrono::minutes{2}) {
    std::unique_lock lock{mutex_};
    const std::size_t wanted = answered_ + more;
    const auto give_up = std::chrono::steady_clock::now() + most;
    const auto is_done = [&] {
      if (sends && more > 0) return answered_ >= wanted;
      return !sends &&
             std::ranges::all_of(players_, [](const Player& player) { return player.open.empty(); });
    };
    while (!is_done()) {
      if (!fault_.empty()) return fault_;
      if (!lost_.empty()) return "a server is lost: " + lost_;
      if (std::chrono::steady_clock::now() > give_up) {
        return most < std::chrono::minutes{1} ? std::string{} : "edits are not answered";
      }
      for (Player& player : players_) {
        if (nodes_[player.node]->is_open()) pump(player, sends);
      }
      changed_.wait_for(lock, milliseconds{2});
    }
    return {};
  }

  /// With the lock.
  void pump(Player& player, bool sends) {
    ClusterNode& node = *nodes_[player.node];
    const std::uint64_t connection = player.connection;
    if (player.epoch == 0) {
      if (player.attaching) return;
      const auto known = node.state().editor(player.id);
      const std::uint64_t epoch = known ? known->epoch + 1 : 1;
      player.attaching = node.log()
                             .append(edits::AttachEntry{player.id, epoch, "somebody"},
                                     [this, &player, connection, epoch](const auto& applied) {
                                       const std::lock_guard in_turn{mutex_};
                                       if (player.connection != connection) return;
                                       player.attaching = false;
                                       if (applied && (*applied)->kind == Kind::attached)
                                         player.epoch = epoch;
                                       changed_.notify_one();
                                     })
                             .has_value();
      return;
    }
    while (sends && player.open.size() < 4) {
      player.open.emplace(++player.sequence, any_edit());
      player.in_flight[player.sequence] = false;
    }
    for (const auto& [sequence, edit] : player.open) {
      if (player.in_flight[sequence]) continue;
      edits::EditEntry entry{player.id, player.epoch, sequence, edit, base_of(edit)};
      const auto taken = node.log().append(std::move(entry),
                                           [this, &player, connection, at = sequence](const auto& applied) {
                                             const std::lock_guard in_turn{mutex_};
                                             answer(player, connection, at, applied);
                                             changed_.notify_one();
                                           });
      if (!taken) break;  // in order
      player.in_flight[sequence] = true;
    }
  }

  void answer(Player& player, std::uint64_t connection, std::uint64_t sequence,
              const tl::expected<const edits::EntryResult*, EditError>& applied) {
    const bool current = player.connection == connection;
    if (!applied) {
      if (current) player.in_flight[sequence] = false;
      return;
    }
    const Kind kind = (*applied)->kind;
    if (kind == Kind::expired) {
      // Of the connection before, or of one that another has overtaken.
      if (current) go_to(player, player.node);
      return;
    }
    if (kind == Kind::not_applied) {
      player.not_applied[sequence] = true;
    } else if (kind == Kind::done || kind == Kind::conflict || kind == Kind::repeat) {
      const auto [at, first] = player.told.emplace(sequence, (*applied)->result);
      if (at->second != (*applied)->result) fault_ = "an edit has two results";
    } else {
      fault_ = "an edit was answered by kind " + std::to_string(static_cast<int>(kind));
    }
    if (player.open.erase(sequence) > 0) ++answered_;
    player.in_flight.erase(sequence);
  }

  std::string wait_until_all_applied() {
    const auto give_up = std::chrono::steady_clock::now() + std::chrono::minutes{1};
    for (auto& node : nodes_) {
      while (node->log().status().sequence < stream_.state().last || !node->log().status().ready) {
        if (std::chrono::steady_clock::now() > give_up) return "a server does not reach the log's end";
        std::unique_lock lock{mutex_};
        changed_.wait_for(lock, milliseconds{2});
      }
    }
    return {};
  }

  /// The stream's messages once more, as simply as can be, held against all servers and all answers.
  std::string compare() {
    const std::lock_guard lock{mutex_};
    if (differ_) return "two servers had other states at one revision";
    Model model;
    struct Editor {
      std::uint64_t epoch = 0;
      std::uint64_t last = 0;
      std::map<std::uint64_t, edits::EditResult> results;
    };
    std::map<edits::EditorId, Editor> editors;
    std::uint64_t revision = 0;
    std::uint64_t position = 0;
    const auto messages = stream_.all();
    for (std::size_t i = 1; i < messages.size(); ++i) {
      if (messages[i] == of_a_format_to_come()) continue;
      const auto batch = cluster::decode_batch(messages[i], kClusterIdentity);
      if (!batch) return batch.error().reason;
      for (const auto bytes : batch->entries) {
        const auto entry = cluster::decode_entry(bytes, batch->settles);
        if (!entry) return "an entry cannot be read";
        ++position;
        if (const auto* const attach = std::get_if<edits::AttachEntry>(&*entry)) {
          Editor& editor = editors[attach->editor];
          if (attach->epoch == editor.epoch + 1) ++editor.epoch;
          continue;
        }
        const auto& edit = std::get<edits::EditEntry>(*entry);
        Editor& editor = editors[edit.editor];
        if (edit.epoch != editor.epoch || edit.sequence <= editor.last) continue;
        const Model::Result result = model.apply(edit.edit);
        if (result.changed > 0) ++revision;
        editor.last = edit.sequence;
        edits::EditResult kept{edit.sequence, revision, static_cast<std::uint32_t>(result.changed), {}};
        if (result.conflict) kept.conflict = static_cast<std::uint32_t>(*result.conflict);
        editor.results.emplace(edit.sequence, kept);
      }
    }
    for (const Player& player : players_) {
      const Editor& editor = editors[player.id];
      for (const auto& [sequence, result] : player.told) {
        const auto at = editor.results.find(sequence);
        if (at == editor.results.end()) return "an edit was answered that never happened";
        if (at->second != result) return "an edit was answered otherwise than it happened";
      }
      for (const auto& [sequence, yes] : player.not_applied) {
        if (editor.results.contains(sequence)) return "an edit happened that was said not to have";
      }
    }
    for (auto& node : nodes_) {
      const cluster::ClusterLog::State status = node->log().status();
      if (status.head.position != position) return "a server is at another position";
      if (status.head.revision != revision) return "a server is at another revision";
      std::map<VoxelPos, MaterialId> voxels;
      edits::StateHash hash;
      for (const std::int32_t x : {-1, 0, 9, 10}) {
        for (const std::int32_t y : {-1, 0}) {
          for (const std::int32_t z : {-1, 0}) {
            const auto chunk = node->state().load({{x, y, z}, Lod{}});
            if (!chunk) return chunk.error();
            if (chunk->overrides == nullptr) continue;
            const VoxelPos at = chunk_origin({x, y, z});
            for (const Override& each : chunk->overrides->voxels()) {
              voxels.emplace(
                  VoxelPos{at.x + each.index % 32, at.y + each.index / 1024, at.z + each.index / 32 % 32},
                  each.material);
              hash.add({x, y, z}, each);
            }
          }
        }
      }
      if (voxels != model.overrides()) return "a server's voxels differ from the log";
      if (hash != status.head.hash) return "a server's S differs from its voxels";
      for (const Player& player : players_) {
        const auto held = node->state().editor(player.id);
        const Editor& editor = editors[player.id];
        if (editor.epoch == 0) continue;
        if (!held || held->epoch != editor.epoch || held->last_sequence != editor.last) {
          return "a server has an editor otherwise than the log";
        }
      }
    }
    return {};
  }

  std::mt19937_64 random_;
  ScratchDirectory scratch_;
  SharedStream stream_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<Player> players_;
  std::map<std::uint64_t, edits::StateHash> states_;  // by revision, of all servers
  bool differ_ = false;
  std::string fault_;
  std::string lost_;
  std::size_t answered_ = 0;
  std::vector<std::unique_ptr<ClusterNode>> nodes_;  // their threads use all above
};

}  // namespace

TEST_CASE("servers that share a log come to one state, and each edit happens once, whatever fails") {
  const char* const given = std::getenv("TALUS_KILLS");
  const int faults = given != nullptr ? std::atoi(given) : 12;
  const std::uint64_t seed = seed_of_run();
  CAPTURE(seed);
  ClusterModel model{seed, 3, 12};
  CHECK(model.run(faults) == "");
  CHECK(model.answered() >= static_cast<std::size_t>(faults) * 10);
  if (given != nullptr) {
    std::cout << faults << " faults, " << model.answered() << " edits answered, " << model.messages()
              << " messages, seed " << seed << '\n';
  }
}

}  // namespace talus::server
