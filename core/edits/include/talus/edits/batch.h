// Applies several log entries to a state: they are staged here, written by a store, and only then become the
// state. Nodes that apply the same entries reach the same state and the same answers, however the entries are
// divided into batches.
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

/// Version of a state.
struct Head {
  std::uint64_t position = 0;  // last log entry; every entry has a position
  std::uint64_t revision = 0;  // incremented by each edit that changes something
  std::int64_t time_ms = 0;    // date of the last batch since 1970; decreases only if a clock was ahead
  StateHash hash;
  bool operator==(const Head&) const = default;
};

/// A connection that attaches as `editor`. The epoch must be the editor's plus one: if two connections attach
/// at once, the second is rejected.
struct AttachEntry {
  EditorId editor;
  std::uint64_t epoch = 0;
  std::string subject;
};

struct EditEntry {
  EditorId editor;
  std::uint64_t epoch = 0;
  std::uint64_t sequence = 0;  // chosen by the client, ascending; gaps are allowed
  Edit edit;
  BaseVoxels base;  // all voxels that the edit touches or may settle
  /// Rules of settling; null: nothing settles. Part of the entry, so that nodes need not know its world.
  SettleRulesPtr settles{};
  std::string subject{};  // player for whom a game server edits; empty: the editor's own subject
  /// touched_voxels(), set by the node that admits the edit. Not stored in logs: an entry read from a log has
  /// none, and applying computes it.
  std::vector<TouchedChunk> touched{};
  SecretVoxels secrets{};  // what the edit may reveal; stored in logs
};

/// Names of placeable materials: names without an id get one.
struct BindEntry {
  std::vector<std::string> names;
};

/// Result of an entry.
struct EntryResult {
  enum class Kind : std::uint8_t {
    attached,
    superseded,    // attach: its epoch is not the next one
    editors_full,  // attach: the table of editors is full, and all of them have edited recently
    done,          // the edit was applied; `result` has the number of changes
    conflict,      // a guard does not hold; nothing was applied
    repeat,        // the edit was applied before; `result` is the earlier result
    not_applied,   // its sequence is not new, and no result is kept
    expired,       // another connection attached as its editor, or the editor was forgotten
    invalid,       // it exceeds a bound or lacks base voxels; correct nodes never log such an entry
    bound,         // names of materials have ids
  };
  Kind kind = Kind::invalid;
  EditorId editor;
  std::uint64_t position = 0;
  std::uint64_t revision = 0;         // of the state after the entry
  EditResult result;                  // for done, conflict and repeat
  bool is_unknown = false;            // for not_applied: it may have been applied, its result is forgotten
  std::uint64_t epoch = 0;            // for attached
  std::string subject;                // attached: the editor's; done: the edit's
  std::optional<EditorId> forgotten;  // for attached: the editor evicted for it
  std::vector<ChunkChanges> changes;  // for done: voxels of level 0
  std::vector<ChunkWrites> writes;    // the same as writes, at all levels
  NamedIds materials;                 // for bound: all requested names, also those bound before

  /// True if the entry made a revision.
  [[nodiscard]] bool changed() const { return !changes.empty(); }
};

class Batch {
 public:
  /// Starts from a state that must outlive this object and not change meanwhile. `now_ms` is the wall clock
  /// of the logging node; if it went backwards, the head's time is used. `materials`: bound materials; null
  /// if no entry binds any.
  Batch(const OverrideSource& overrides, const Editors& editors, const Head& head, std::int64_t now_ms,
        const MaterialIds* materials = nullptr);

  /// Reserves memory for this many entries.
  void expect(std::size_t entries) {
    applied_.reserve(entries);
    staging_.expect(entries);
  }
  /// Applies an entry at the next position, whatever its result. The result lives as long as this object.
  const EntryResult& apply(const AttachEntry& entry);
  const EntryResult& apply(const EditEntry& entry);
  const EntryResult& apply(const BindEntry& entry);

  /// Version of the state after all entries applied.
  [[nodiscard]] const Head& head() const { return head_; }
  /// The editors touched; nullopt: forgotten.
  [[nodiscard]] std::map<EditorId, std::optional<EditorChange>> take_editors() && {
    return std::move(touched_);
  }
  /// Results of the entries, in order.
  [[nodiscard]] const std::vector<EntryResult>& applied() const { return applied_; }
  /// Changes of every changed chunk, at any level.
  [[nodiscard]] const std::unordered_map<ChunkKey, StagedChunk>& chunks() const { return staging_.chunks(); }

 private:
  /// The editor as of now, without its results.
  [[nodiscard]] const Editor* find(EditorId id) const;
  /// Null if the result is not kept.
  [[nodiscard]] const EditResult* result_of(EditorId id, std::uint64_t sequence) const;
  /// True if kKeptResults later results displaced the result of this sequence, had there been one.
  [[nodiscard]] bool has_forgotten(EditorId id, std::uint64_t sequence) const;
  /// Forgets editors that were idle for too long.
  void forget_idle();
  /// Forgets the editor that attached first among the editors that never edited; nullopt if there is none.
  std::optional<EditorId> forget_never_used();
  /// Returns an editor found by find(), or a new one if null, for modification.
  Editor& touch(EditorId id, const Editor* editor);
  EntryResult& begin(EditorId editor, EntryResult::Kind kind);

  const Editors& editors_;
  const MaterialIds* materials_;
  std::optional<MaterialIds> bound_;  // after this batch; nullopt: unchanged
  Head head_;
  StagingArea staging_;
  std::map<EditorId, std::optional<EditorChange>> touched_;
  std::size_t count_ = 0;  // number of editors
  bool forgot_idle_ = false;
  Editors::ByUse::const_iterator never_used_;  // the batch has touched all of the state's before it
  Editors::ByUse new_;                         // never used, touched by the batch
  std::vector<EntryResult> applied_;
};

}  // namespace talus::edits
