// Entries of the log applied to a state, several at once: they are staged here, written by a store, and only
// then made the state. Every node that applies the same entries comes to the same state and the same
// answers, however they are cut into batches.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include <talus/edits/editors.h>
#include <talus/edits/evaluate.h>
#include <talus/edits/levels.h>
#include <talus/edits/materials.h>
#include <talus/edits/staging.h>
#include <talus/edits/state_hash.h>

namespace talus::edits {

/// Where a state stands.
struct Head {
  std::uint64_t position = 0;  // of the last entry of the log; every entry has one
  std::uint64_t revision = 0;  // one more for each edit that changed something
  std::int64_t time_ms = 0;    // since 1970, of the last batch; never falls
  StateHash hash;
  bool operator==(const Head&) const = default;
};

/// A connection that wants to edit as `editor`. Its epoch is one more than the editor's: of two that attach
/// at once one comes too late.
struct AttachEntry {
  EditorId editor;
  std::uint64_t epoch = 0;
  std::string subject;
};

struct EditEntry {
  EditorId editor;
  std::uint64_t epoch = 0;
  std::uint64_t sequence = 0;  // chosen by the client, rising; gaps are allowed
  Edit edit;
  BaseVoxels base;  // of all that it touches, and of what may settle
  /// By which it sets material loose; null: by none. The entry has it, so that no node needs its world.
  SettleRulesPtr settles{};
  std::string subject{};  // for whom a game server edits; empty: for its editor's own subject
  /// What touched_voxels() says of the edit, where it was asked already; empty: it is asked. No log has it.
  std::vector<TouchedChunk> touched{};
};

/// Names of materials that may be placed: those that have no id yet get one.
struct BindEntry {
  std::vector<std::string> names;
};

/// What became of an entry.
struct Applied {
  enum class Kind : std::uint8_t {
    attached,
    superseded,    // of an attach: its epoch is not the next one
    editors_full,  // of an attach: there are as many as there may be, and all of them have edited of late
    done,          // an edit that happened; result says how much it changed
    conflict,      // a guard does not hold; nothing happened
    repeat,        // it happened before; result is that of then
    not_applied,   // its sequence is behind, and its result is not kept: it did not happen, or long ago
    expired,       // another connection has attached as its editor, or the editor is forgotten
    invalid,       // it breaks a bound or lacks a base; no sound node logs such an entry
    bound,         // names of materials have ids
  };
  Kind kind = Kind::invalid;
  EditorId editor;
  std::uint64_t position = 0;
  std::uint64_t revision = 0;         // of the state after it
  EditResult result;                  // of done, conflict and repeat
  std::uint64_t epoch = 0;            // of attached
  std::string subject;                // of attached: the editor's; of done: whose edit it is
  std::optional<EditorId> forgotten;  // of attached: who made place for it
  std::vector<ChunkChanges> changes;  // of done: voxels of level 0
  std::vector<ChunkWrites> writes;    // the same as writes, at all levels
  NamedIds materials;                 // of bound: all that were asked for, also those bound before

  /// Whether it made a revision.
  [[nodiscard]] bool changed() const { return !changes.empty(); }
};

class Batch {
 public:
  /// Of a state that outlives this and stays as it is meanwhile. `now_ms` is the wall clock of the node that
  /// logs: where that went back, the head's time counts. `materials`: those that are bound; null: no entry
  /// binds any.
  Batch(const OverrideSource& overrides, const Editors& editors, const Head& head, std::int64_t now_ms,
        const MaterialIds* materials = nullptr);

  /// So many entries are about to be applied.
  void expect(std::size_t entries) {
    applied_.reserve(entries);
    staging_.expect(entries);
  }
  /// Each takes the next position, whatever becomes of it. What is returned lives as long as this.
  const Applied& apply(const AttachEntry& entry);
  const Applied& apply(const EditEntry& entry);
  const Applied& apply(const BindEntry& entry);

  /// Of the state after all of it.
  [[nodiscard]] const Head& head() const { return head_; }
  /// The editors that it touched; none: forgotten.
  [[nodiscard]] std::map<EditorId, std::optional<EditorChange>> take_editors() && {
    return std::move(touched_);
  }
  /// One for each entry, in order.
  [[nodiscard]] const std::vector<Applied>& applied() const { return applied_; }
  /// Every chunk that it changed, of any level, and how.
  [[nodiscard]] const std::unordered_map<ChunkKey, StagedChunk>& chunks() const { return staging_.chunks(); }

 private:
  /// As it is now, but for its results.
  [[nodiscard]] const Editor* find(EditorId id) const;
  /// Null where it is not kept.
  [[nodiscard]] const EditResult* result_of(EditorId id, std::uint64_t sequence) const;
  /// Forgets who was idle for too long.
  void forget_idle();
  /// Forgets the editor that attached first of those that never edited, and returns it, if there is one.
  std::optional<EditorId> forget_never_used();
  /// What find() returned, to be changed; null: a new one.
  Editor& touch(EditorId id, const Editor* editor);
  Applied& begin(EditorId editor, Applied::Kind kind);

  const Editors& editors_;
  const MaterialIds* materials_;
  std::optional<MaterialIds> bound_;  // after this batch; none: as before it
  Head head_;
  Staging staging_;
  std::map<EditorId, std::optional<EditorChange>> touched_;
  std::size_t count_ = 0;  // of editors
  bool forgot_idle_ = false;
  Editors::ByUse::const_iterator never_used_;  // before it the batch has touched all of the state's
  Editors::ByUse new_;                         // never used, and touched
  std::vector<Applied> applied_;
};

}  // namespace talus::edits
