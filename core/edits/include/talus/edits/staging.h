// Edits that are evaluated but not yet stored: an overlay on the applied state. A batch is evaluated here,
// edit upon edit, written, and only then made the state; if the write fails, the overlay is dropped and
// nothing happened.
#pragma once

#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include <talus/edits/evaluate.h>
#include <talus/edits/state_hash.h>

namespace talus::edits {

/// What changed at level 0 as absolute writes, at that and, by rule 1, at all other levels: first those of
/// level 0, in the order of `changes`, then the others. Each chunk of each level at most once.
[[nodiscard]] std::vector<ChunkWrites> writes_at_all_levels(std::span<const ChunkChanges> changes);

/// What a batch writes to a chunk.
struct StagedChunk {
  const ChunkOverrides* before = nullptr;  // of the state under the batch; null: none
  std::vector<OverrideWrite> writes;       // by rising index, of each voxel the last

  /// The chunk after them.
  [[nodiscard]] ChunkOverrides after() const;
};

/// Of one thread. Holds what is written, not the chunks that it is written to.
class Staging final : public OverrideSource {
 public:
  /// `applied` is the state under the batch, which must outlive this and stay as it is meanwhile; `hash` is
  /// its S.
  Staging(const OverrideSource& applied, StateHash hash) : applied_{applied}, hash_{hash} {}

  /// About so many chunks are to be staged.
  void expect(std::size_t chunks) { chunks_.reserve(chunks); }

  [[nodiscard]] const ChunkOverrides* find(ChunkKey chunk) const override;
  [[nodiscard]] std::span<const OverrideWrite> staged(ChunkKey chunk) const override;

  /// Makes the changes of an outcome of evaluate() on this very staging, at all levels. Returns the writes,
  /// which a store keeps and views are told of.
  std::vector<ChunkWrites> stage(const Outcome& outcome);

  [[nodiscard]] StateHash hash() const { return hash_; }
  /// Every chunk that was staged.
  [[nodiscard]] const std::unordered_map<ChunkKey, StagedChunk>& chunks() const { return chunks_; }

 private:
  void apply(const ChunkWrites& writes);

  const OverrideSource& applied_;
  StateHash hash_;
  std::unordered_map<ChunkKey, StagedChunk> chunks_;
};

}  // namespace talus::edits
