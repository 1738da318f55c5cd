// A million random entries, of which each is cheap, in logs that are long: what shows only after many edits
// of the same voxels.
#include <algorithm>
#include <cstdlib>
#include <map>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "log_model.h"
#include "seed_of_run.h"

namespace talus::edits {
namespace {

using namespace testing;

constexpr std::uint64_t kEntriesOfALog = 25'000;
// A million entries; where sanitizers watch, each costs tens of times as much.
#if defined(__SANITIZE_THREAD__) || defined(__SANITIZE_ADDRESS__)
constexpr std::uint64_t kLogs = 2;
#else
constexpr std::uint64_t kLogs = 40;
#endif
constexpr std::uint64_t kComparisonInterval = 500;  // revisions between comparisons of all voxels

class LongLog {
 public:
  explicit LongLog(std::uint64_t seed) : random_{seed} {}

  /// What went wrong; empty: nothing did.
  std::string run() {
    for (std::uint64_t compared = 0; model_.position() < kEntriesOfALog;) {
      if (std::string fault = add_batch(); !fault.empty()) return fault;
      if (model_.position() < compared + kComparisonInterval) continue;
      compared = model_.position();
      if (store_.state.overrides(Lod{}) != model_.model().overrides()) {
        return "after entry " + std::to_string(compared) + " the voxels are others";
      }
    }
    return cut_otherwise();
  }

  /// Of each kind, how many entries.
  [[nodiscard]] const std::map<EntryResult::Kind, std::uint64_t>& kinds() const { return kinds_; }

 private:
  std::uint64_t below(std::uint64_t end) { return random_() % end; }

  VoxelPos any_voxel() {
    // Across borders of chunks, and with the samples of some coarse levels.
    const auto at = [&] { return static_cast<std::int64_t>(below(10)) - 5; };
    return {at(), at() + 4, at()};
  }
  MaterialId any_material() { return MaterialId{static_cast<std::uint16_t>(below(5))}; }

  Edit any_small_edit() {
    Edit edit;
    if (below(3) == 0) {
      const VoxelPos voxel = any_voxel();
      edit.guards.push_back({voxel, below(5) > 0 ? model_.model().at(voxel) : any_material()});
    }
    for (std::uint64_t left = below(4); left > 0; --left)
      edit.writes.push_back({any_voxel(), any_material()});
    if (below(8) == 0) {
      const VoxelPos first = any_voxel();
      const VoxelPos last{first.x + static_cast<std::int64_t>(below(3)),
                          first.y + static_cast<std::int64_t>(below(3)), first.z};
      edit.fills.push_back({first, last, below(3) > 0 ? std::optional{any_material()} : std::nullopt,
                            below(2) > 0 ? std::optional{any_material()} : std::nullopt});
    }
    return edit;
  }

  Entry any_entry() {
    const EditorId id{1 + below(4), 5};
    const LogModel::Editor& editor = model_.editor(id);
    if (below(40) == 0 || editor.epoch == 0) {
      const std::uint64_t epoch = below(6) == 0 ? below(6) : editor.epoch + 1;
      return AttachEntry{id, epoch, below(10) == 0 ? "another" : "somebody"};
    }
    EditEntry entry{id, editor.epoch, editor.last + 1 + below(2), any_small_edit(), {}};
    // Sent again: mostly one whose result is kept.
    if (below(5) == 0) entry.sequence = editor.last - std::min(editor.last, below(80));
    if (below(20) == 0) entry.epoch = below(6);
    entry.base = base_of(entry.edit);
    if (below(40) == 0) entry.base.clear();
    return entry;
  }

  std::string add_batch() {
    Batch batch{store_.state, store_.editors, store_.head, static_cast<std::int64_t>(model_.position())};
    for (std::uint64_t left = 1 + below(20); left > 0; --left) {
      log_.push_back(any_entry());
      const EntryResult& applied =
          std::visit([&](const auto& each) -> const EntryResult& { return batch.apply(each); }, log_.back());
      if (std::string fault = model_.follow(log_.back(), applied); !fault.empty()) return fault;
      ++kinds_[applied.kind];
    }
    store_.commit(batch);
    return {};
  }

  /// The same log in other batches gives the same store.
  std::string cut_otherwise() {
    Store other;
    for (std::size_t at = 0; at < log_.size();) {
      const std::size_t end = std::min<std::size_t>(log_.size(), at + 1 + below(100));
      other.apply(
          {log_.begin() + static_cast<std::ptrdiff_t>(at), log_.begin() + static_cast<std::ptrdiff_t>(end)},
          1'000);
      at = end;
    }
    const bool equal = other.head.position == store_.head.position &&
                       other.head.revision == store_.head.revision && other.head.hash == store_.head.hash &&
                       other.state.chunks == store_.state.chunks;
    return equal ? "" : "cut otherwise the log gives another store";
  }

  std::mt19937_64 random_;
  Store store_;
  LogModel model_;
  std::vector<Entry> log_;
  std::map<EntryResult::Kind, std::uint64_t> kinds_;
};

}  // namespace

TEST_CASE("a million random entries in long logs do what the model says, however they are cut") {
  // TALUS_SEED repeats a log.
  const char* const said = std::getenv("TALUS_SEED");
  const std::uint64_t first = seed_of_run();
  const std::uint64_t logs = said != nullptr ? 1 : kLogs;
  for (std::uint64_t log = 0; log < logs; ++log) {
    CAPTURE(first + log);
    LongLog entries{first + log};
    REQUIRE(entries.run() == "");
    using Kind = EntryResult::Kind;
    for (const Kind kind : {Kind::attached, Kind::superseded, Kind::done, Kind::conflict, Kind::repeat,
                            Kind::not_applied, Kind::expired, Kind::invalid}) {
      CAPTURE(static_cast<int>(kind));
      CHECK(entries.kinds().at(kind) > (kind == Kind::done ? kEntriesOfALog / 2 : 50));
    }
  }
}

}  // namespace talus::edits
