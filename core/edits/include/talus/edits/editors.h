// Editors and the results of their last edits, so that each edit is applied once, however often it is sent.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace talus::edits {

/// 128 random bits made by a server, and secret: a connection that knows them, with a token of the same
/// subject, may continue another connection's edits. 0 is not a valid editor.
struct EditorId {
  std::uint64_t low = 0;
  std::uint64_t high = 0;
  constexpr auto operator<=>(const EditorId&) const = default;
};

/// Results kept per editor, and so the maximum number of its unanswered edits.
inline constexpr std::size_t kKeptResults = 64;
/// Maximum number of editors of a world.
inline constexpr std::size_t kMaxEditors = 65'536;
/// Additional editors for rollback, which uses this subject.
inline constexpr std::size_t kOperatorEditors = 64;
inline constexpr std::string_view kOperatorSubject = "talusd store rollback";
/// An editor idle for this long, by the log's time, is forgotten.
inline constexpr std::int64_t kEditorIdleMs = std::int64_t{24} * 60 * 60 * 1000;
/// Maximum bytes of a subject.
inline constexpr std::size_t kMaxSubjectBytes = 256;

/// Result of an edit.
struct EditResult {
  std::uint64_t sequence = 0;
  std::uint64_t revision = 0;             // of the state after the edit; the old one if nothing changed
  std::uint32_t changed = 0;              // voxels of level 0
  std::optional<std::uint32_t> conflict;  // index of the first guard that did not hold
  bool operator==(const EditResult&) const = default;
};

struct Editor {
  std::uint64_t epoch = 0;          // incremented by each connection that attaches
  std::uint64_t last_sequence = 0;  // edits up to this one are decided
  std::int64_t used_ms = 0;         // by the log's time
  std::string subject;              // the token's; may be empty
  std::vector<EditResult> results;  // the newest kKeptResults, by ascending sequence
  /// True if at least one of its edits is decided.
  [[nodiscard]] bool is_used() const { return last_sequence != 0; }
  bool operator==(const Editor&) const = default;

  void keep(const EditResult& result);
  [[nodiscard]] const EditResult* result_of(std::uint64_t sequence) const;
};

/// Changes of an editor by a batch.
struct EditorChange {
  Editor editor;        // its results are only the batch's
  bool is_new = false;  // did not exist or was forgotten before: it has no older results
};

/// All editors. Not thread-safe.
class Editors {
 public:
  [[nodiscard]] const Editor* find(EditorId id) const;
  [[nodiscard]] std::size_t size() const { return editors_.size(); }
  [[nodiscard]] const std::map<EditorId, Editor>& all() const { return editors_; }

  void put(EditorId id, Editor editor);
  /// Unless the editor is new, its results are appended to the existing ones, up to kKeptResults.
  void put(EditorId id, EditorChange change);
  void erase(EditorId id);

  /// Ordered by time of last use, then by id.
  using ByUse = std::set<std::pair<std::int64_t, EditorId>>;

  /// The editors idle for too long at `time_ms`, least recently used first.
  [[nodiscard]] std::vector<EditorId> idle_at(std::int64_t time_ms) const;
  /// True if idle_at() would not be empty.
  [[nodiscard]] bool any_idle_at(std::int64_t time_ms) const;
  /// Editors that attached but never edited; they are evicted first if there are too many.
  [[nodiscard]] const ByUse& never_used() const { return never_used_; }

 private:
  std::map<EditorId, Editor> editors_;
  ByUse by_use_;
  ByUse never_used_;
};

}  // namespace talus::edits

template <>
struct std::hash<talus::edits::EditorId> {
  std::size_t operator()(talus::edits::EditorId id) const noexcept {
    return static_cast<std::size_t>(id.low);  // random already
  }
};
