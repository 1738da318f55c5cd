// Power cuts under 64 waiting editors: what was acknowledged is there, once, and whole.
#include <chrono>
#include <cstdlib>
#include <iostream>
#include <map>
#include <random>
#include <set>

#include <catch2/catch.hpp>

#include "edit_store.h"
#include "edits/model.h"
#include "scratch_directory.h"
#include "seed_of_run.h"
#include "unsafe_disk.h"

namespace talus::server {
namespace {

using namespace testing;
using edits::testing::base_at;
using edits::testing::base_of;
using edits::testing::Model;

/// A player that has one edit under way, and sends it again until it is decided.
struct Player {
  edits::EditorId id;
  std::uint64_t epoch = 0;
  std::uint64_t sequence = 0;
  edits::EditEntry sent;                     // the one under way
  std::map<std::uint64_t, edits::Edit> all;  // by sequence
  std::uint64_t decided = 0;                 // the last sequence that the log has
};

class PowerCuts {
 public:
  /// `rules`: by which edits set material loose; null: none.
  PowerCuts(std::uint64_t seed, bool sync, edits::SettleRulesPtr rules = nullptr)
      : random_{seed},
        rules_{std::move(rules)},
        disk_{std::make_shared<UnsafeDisk>(seed + 1)},
        env_{environment_of(disk_)},
        store_{scratch_ / "edits"},
        players_(64) {
    store_.database_settings.env = env_.get();
    store_.database_settings.sync = sync;
    store_.database_settings.memory.write_buffer_bytes = 64 << 10;
    store_.log_settings.flush_interval = std::chrono::milliseconds{2};
    store_.log_settings.retry_interval = std::chrono::hours{1};
    for (std::size_t i = 0; i < players_.size(); ++i) players_[i].id = {i + 1, seed + i};
  }

  /// The first fault, or nothing.
  std::string run(int cuts) {
    for (int cut = 0; cut < cuts; ++cut) {
      disk_->cut_after(static_cast<std::int64_t>(1 + below(below(4) == 0 ? 100 : 800)));
      if (const std::string error = store_.open(); error.empty()) {
        edit_until_cut();
      } else if (!disk_->is_off()) {
        return error;
      }
      store_.close();
      disk_->restart();
      if (const std::string error = store_.open_without_log(); !error.empty()) return error;
      std::string fault = compare();
      store_.close();
      if (!fault.empty()) return "after cut " + std::to_string(cut) + ": " + fault;
    }
    return {};
  }

  [[nodiscard]] std::uint64_t acknowledged() const { return acknowledged_; }
  /// Voxels that changed beyond those that edits wrote.
  [[nodiscard]] std::uint64_t slid() const { return slid_; }

 private:
  std::uint64_t below(std::uint64_t bound) { return random_() % bound; }

  edits::Edit any_edit() {
    edits::Edit edit;
    const auto place = [&]() -> VoxelPos {
      const auto near = [&] { return static_cast<std::int64_t>(below(12)) - 6; };
      const std::int64_t far = below(2) == 0 ? 0 : 320;
      return {far + near(), near(), near()};
    };
    const auto material = [&] { return MaterialId{static_cast<std::uint16_t>(below(5))}; };
    for (std::uint64_t left = 1 + below(3); left > 0; --left) edit.writes.push_back({place(), material()});
    if (below(8) == 0) edit.guards.push_back({place(), material()});
    if (below(16) == 0) {
      const VoxelPos first = place();
      edit.fills.push_back({first, {first.x + 2, first.y + 3, first.z + 1}, material(), {}});
    }
    return edit;
  }

  /// Of what slides, too.
  [[nodiscard]] edits::BaseVoxels base_for(const edits::Edit& edit) const {
    if (rules_ == nullptr) return base_of(edit);
    edits::BaseVoxels base;
    const auto all = edits::with_settling(edits::touched_voxels(edit).value(), edits::settle_box(edit));
    for (const edits::TouchedChunk& touched : all) {
      const VoxelPos at = chunk_origin(touched.chunk);
      auto& voxels = base[touched.chunk];
      for (const std::uint16_t index : touched.voxels) {
        voxels.push_back({index, base_at({at.x + index % 32, at.y + index / 1024, at.z + index / 32 % 32})});
      }
    }
    return base;
  }

  void send(Player& player) {
    ++waiting_;
    const auto taken = store_.log().append(player.sent, [this, &player](const auto& applied) {
      const std::lock_guard lock{mutex_};
      --waiting_;
      if (applied) {
        acknowledged_by_position_.emplace((*applied)->position, **applied);
        ++acknowledged_;
        next(player);
        send(player);
      }
      quiet_.notify_one();
    });
    if (!taken) --waiting_;
  }

  void next(Player& player) {
    ++player.sequence;
    const edits::Edit edit = any_edit();
    player.all.emplace(player.sequence, edit);
    player.sent = {player.id, player.epoch, player.sequence, edit, base_for(edit), rules_};
  }

  void edit_until_cut() {
    std::unique_lock lock{mutex_};
    for (Player& player : players_) {
      const auto known = store_.state().editor(player.id);
      const std::uint64_t epoch = known ? known->epoch + 1 : 1;
      ++waiting_;
      const auto attached = [this, &player, epoch](const auto& applied) {
        const std::lock_guard in_turn{mutex_};
        --waiting_;
        if (applied && (*applied)->kind == edits::EntryResult::Kind::attached) {
          player.epoch = epoch;
          player.sent.epoch = epoch;
          if (player.sequence == 0) next(player);
          send(player);
        }
        quiet_.notify_one();
      };
      if (!store_.log().append(edits::AttachEntry{player.id, epoch, "somebody"}, attached)) --waiting_;
    }
    quiet_.wait(lock, [this] { return waiting_ == 0; });
  }

  /// Goes on with the model by the log's records, and holds the state against it.
  std::string compare() {
    std::string fault;
    const auto read = store_.database().for_each_record(compared_ + 1, [&](store::LogRecord&& record) {
      fault = follow(record);
      return fault.empty();
    });
    if (!read) return read.error();
    if (!fault.empty()) return fault;
    if (!acknowledged_by_position_.empty()) {
      return "entry " + std::to_string(acknowledged_by_position_.begin()->first) +
             " was acknowledged and is lost";
    }
    const edits::Head& head = store_.state().head();
    if (head.position != compared_ || head.revision != revision_) return "the head differs from the log";
    std::map<VoxelPos, MaterialId> voxels;
    edits::StateHash hash;
    for (const ChunkCoord& chunk : touched_) {
      const auto loaded = store_.state().load({chunk, Lod{}});
      if (!loaded) return loaded.error();
      if (loaded->overrides == nullptr) continue;
      for (const Override& each : loaded->overrides->voxels()) {
        const VoxelPos at = chunk_origin(chunk);
        voxels.emplace(
            VoxelPos{at.x + each.index % 32, at.y + each.index / 1024, at.z + each.index / 32 % 32},
            each.material);
        hash.add(chunk, each);
      }
    }
    if (voxels != (rules_ == nullptr ? model_.overrides() : settled_.overrides(Lod{})))
      return "the voxels differ from the log";
    if (hash != head.hash) return "S differs from the voxels";
    for (const Player& player : players_) {
      const auto editor = store_.state().editor(player.id);
      if (player.decided > 0 && (!editor || editor->last_sequence != player.decided)) {
        return "an editor is not as the log has it";
      }
    }
    return {};
  }

  std::string follow(const store::LogRecord& record) {
    using Kind = edits::EntryResult::Kind;
    if (record.position != compared_ + 1) return "an entry is missing in the log";
    compared_ = record.position;
    if (const auto at = acknowledged_by_position_.find(record.position);
        at != acknowledged_by_position_.end()) {
      const edits::EntryResult& was = at->second;
      if (was.kind != record.kind || was.editor != record.editor || was.result != record.result ||
          was.changes != record.changes) {
        return "entry " + std::to_string(record.position) + " is not what was acknowledged";
      }
      acknowledged_by_position_.erase(at);
    }
    revision_ = record.revision;
    if (record.kind != Kind::done && record.kind != Kind::conflict) return {};
    Player& player = players_[record.editor.low - 1];
    if (record.result.sequence <= player.decided) return "an edit happened twice";
    player.decided = record.result.sequence;
    const edits::Edit& edit = player.all.at(record.result.sequence);
    const auto touched = edits::touched_voxels(edit);
    for (const edits::TouchedChunk& each : *touched) touched_.insert(each.chunk);
    if (rules_ != nullptr) return follow_settling(record, edit);
    const Model::Result result = model_.apply(edit);
    const bool same = result.changed == record.result.changed &&
                      result.conflict.has_value() == record.result.conflict.has_value();
    return same ? std::string{} : "entry " + std::to_string(record.position) + " did something else";
  }

  /// Evaluated alone, whatever batches the log was cut into and wherever it was replayed from.
  std::string follow_settling(const store::LogRecord& record, const edits::Edit& edit) {
    const auto outcome = edits::evaluate(edit, base_for(edit), settled_, rules_.get());
    if (!outcome || outcome->chunks != record.changes ||
        outcome->conflict.has_value() != record.result.conflict.has_value()) {
      return "entry " + std::to_string(record.position) + " slid otherwise";
    }
    for (const edits::ChunkChanges& changes : outcome->chunks) touched_.insert(changes.chunk);
    std::size_t named = edits::named_voxels(edit);
    slid_ += outcome->changed > named ? outcome->changed - named : 0;
    edits::StagingArea staging{settled_, settled_.hash};
    (void)staging.stage(*outcome);
    settled_.commit(staging);
    return {};
  }

  ScratchDirectory scratch_{ScratchDirectory::memory()};
  std::mt19937_64 random_;
  const edits::SettleRulesPtr rules_;
  std::shared_ptr<UnsafeDisk> disk_;
  std::unique_ptr<rocksdb::Env> env_;
  EditStore store_;
  std::vector<Player> players_;

  std::mutex mutex_;
  std::condition_variable quiet_;
  int waiting_ = 0;
  std::map<std::uint64_t, edits::EntryResult> acknowledged_by_position_;
  std::uint64_t acknowledged_ = 0;

  Model model_;
  edits::testing::State settled_;  // in its place where material slides
  std::uint64_t slid_ = 0;
  std::uint64_t compared_ = 0;
  std::uint64_t revision_ = 0;
  std::set<ChunkCoord> touched_;
};

/// ./dev test --full gives 2,000.
int cuts_from_environment(int normal) {
  const char* const text = std::getenv("TALUS_POWER_CUTS");
  return text == nullptr ? normal : std::atoi(text);
}

}  // namespace

TEST_CASE("after power cuts every acknowledged edit is present, never twice, never torn") {
  const std::uint64_t seed = seed_of_run();
  CAPTURE(seed);
  const int cuts = cuts_from_environment(20);
  std::uint64_t acknowledged = 0;
  const auto began = std::chrono::steady_clock::now();
  // A store lives through 20 cuts.
  for (int done = 0; done < cuts; done += 20) {
    PowerCuts store{seed + static_cast<std::uint64_t>(done), true};
    REQUIRE(store.run(std::min(20, cuts - done)) == "");
    acknowledged += store.acknowledged();
  }
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began;
  std::cout << cuts << " power cuts, " << acknowledged << " acknowledged entries, " << took.count() / cuts
            << " s each, seed " << seed << '\n';
  CHECK(acknowledged > 0);
}

TEST_CASE("after power cuts slid material lies where it came to rest") {
  const std::uint64_t seed = seed_of_run();
  CAPTURE(seed);
  PowerCuts store{seed, true,
                  std::make_shared<const edits::SettleRules>(
                      edits::SettleRules{{MaterialId{3}, 160}, {MaterialId{4}, 215}})};
  REQUIRE(store.run(std::min(5, cuts_from_environment(20))) == "");
  CHECK(store.slid() > 0);
}

TEST_CASE("without syncs power cuts lose acknowledged edits, and the test above sees it") {
  const std::uint64_t seed = seed_of_run();
  CAPTURE(seed);
  PowerCuts store{seed, false};
  CHECK(store.run(20) != "");
}

}  // namespace talus::server
