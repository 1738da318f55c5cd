// What a log's entries do, said as simply as can be: a model that keeps everything for ever, beside a store
// of the real kind.
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <talus/edits/batch.h>

#include "model.h"

namespace talus::edits::testing {

using Entry = std::variant<AttachEntry, EditEntry>;

/// Chunks, editors and head, as a store has them.
struct Store {
  State state;
  Editors editors;
  Head head;

  /// Stores what the batch did.
  std::vector<EntryResult> commit(Batch& batch);
  std::vector<EntryResult> apply(const std::vector<Entry>& entries, std::int64_t now_ms);
};

[[nodiscard]] bool same(const EntryResult& a, const EntryResult& b);

class LogModel {
 public:
  /// What is known of an editor.
  struct Editor {
    std::uint64_t epoch = 0;
    std::uint64_t last = 0;  // sequence
    std::string subject;
    std::map<std::uint64_t, EditResult> results;  // that are kept
  };

  [[nodiscard]] const Model& model() const { return model_; }
  [[nodiscard]] std::uint64_t position() const { return position_; }
  /// Of one that never attached that of nobody.
  [[nodiscard]] const Editor& editor(EditorId id) const;

  /// The next entry, which the model has then. What is wrong with `applied`; empty: nothing.
  [[nodiscard]] std::string follow(const Entry& entry, const EntryResult& applied);

 private:
  [[nodiscard]] EntryResult::Kind apply(const AttachEntry& attach);
  [[nodiscard]] EntryResult::Kind apply(const EditEntry& edit, const EntryResult& applied,
                                        std::string& fault);

  Model model_;
  std::map<EditorId, Editor> editors_;
  std::set<std::pair<EditorId, std::uint64_t>> happened_;
  std::uint64_t position_ = 0;
  std::uint64_t revision_ = 0;
};

}  // namespace talus::edits::testing
