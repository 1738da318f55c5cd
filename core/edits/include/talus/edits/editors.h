// Who edits, and what became of what each sent last: by this an edit happens once, however often it is sent.
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

/// 128 random bits that a server made, and a secret: who knows them may go on with the edits of another
/// connection, if its token has the same subject. 0 is nobody.
struct EditorId {
  std::uint64_t low = 0;
  std::uint64_t high = 0;
  constexpr auto operator<=>(const EditorId&) const = default;
};

/// Results kept of an editor, and so edits that it may have sent without an answer.
inline constexpr std::size_t kKeptResults = 64;
/// Editors of a world.
inline constexpr std::size_t kMaxEditors = 65'536;
/// Beyond those, for who undoes what others did: by this subject.
inline constexpr std::size_t kOperatorEditors = 64;
inline constexpr std::string_view kOperatorSubject = "talusd store rollback";
/// An editor that was idle for so long, by the log's time, is forgotten.
inline constexpr std::int64_t kEditorIdleMs = std::int64_t{24} * 60 * 60 * 1000;
/// Bytes of a subject.
inline constexpr std::size_t kMaxSubjectBytes = 256;

/// What became of an edit.
struct EditResult {
  std::uint64_t sequence = 0;
  std::uint64_t revision = 0;             // of the state after it; where nothing changed, that before it
  std::uint32_t changed = 0;              // voxels of level 0
  std::optional<std::uint32_t> conflict;  // the first guard that did not hold
  bool operator==(const EditResult&) const = default;
};

struct Editor {
  std::uint64_t epoch = 0;          // one more for each connection that attached
  std::uint64_t last_sequence = 0;  // edits up to this one are decided
  std::int64_t used_ms = 0;         // by the log's time
  std::string subject;              // of the token; empty: of no token
  std::vector<EditResult> results;  // the newest kKeptResults, by rising sequence
  /// Whether an edit of it is decided.
  [[nodiscard]] bool is_used() const { return last_sequence != 0; }
  bool operator==(const Editor&) const = default;

  void keep(const EditResult& result);
  [[nodiscard]] const EditResult* result_of(std::uint64_t sequence) const;
};

/// What a batch made of an editor.
struct EditorChange {
  Editor editor;        // its results are those that it got in the batch
  bool is_new = false;  // there was none, or it was forgotten: it has no others
};

/// All editors. For one thread.
class Editors {
 public:
  [[nodiscard]] const Editor* find(EditorId id) const;
  [[nodiscard]] std::size_t size() const { return editors_.size(); }
  [[nodiscard]] const std::map<EditorId, Editor>& all() const { return editors_; }

  void put(EditorId id, Editor editor);
  /// Where the editor is not new its results follow those that it has, as far as they are kept.
  void put(EditorId id, EditorChange change);
  void erase(EditorId id);

  /// By when they were used last, those of one time by their ids.
  using ByUse = std::set<std::pair<std::int64_t, EditorId>>;

  /// Those that at `time_ms` were idle for too long, the least recent first.
  [[nodiscard]] std::vector<EditorId> idle_at(std::int64_t time_ms) const;
  /// Whether there is one of those.
  [[nodiscard]] bool any_idle_at(std::int64_t time_ms) const;
  /// Those that attached and never edited: where there are too many editors, these go first.
  [[nodiscard]] const ByUse& never_used() const { return never_used_; }

 private:
  std::map<EditorId, Editor> editors_;
  ByUse by_use_;
  ByUse never_used_;
};

}  // namespace talus::edits

template <>
struct std::hash<talus::edits::EditorId> {
  std::size_t operator()(talus::edits::EditorId id) const noexcept { return id.low; }  // random already
};
