// Edits that are evaluated but not yet stored: an overlay on the applied state. A batch of edits is evaluated
// here, written, and only then becomes the state; if the write fails, the overlay is dropped without effect.
#pragma once

#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include <talus/edits/evaluate.h>
#include <talus/edits/state_hash.h>

namespace talus::edits {

/// Converts level-0 changes to absolute writes at all levels (rule 1): first level 0, in the order of
/// `changes`, then the others. Each chunk of each level occurs at most once.
[[nodiscard]] std::vector<ChunkWrites> writes_at_all_levels(std::span<const ChunkChanges> changes);

/// Writes of a batch to a chunk.
struct StagedChunk {
  const ChunkOverrides* before = nullptr;  // in the state under the batch; null if not edited
  std::vector<OverrideWrite> writes;       // by ascending index; only the last write of each voxel

  /// The chunk's overrides after the writes.
  [[nodiscard]] ChunkOverrides after() const;
};

/// Not thread-safe. Holds the writes, not the chunks written to.
class StagingArea final : public OverrideSource {
 public:
  /// `applied` is the state under the batch; it must outlive this object and not change meanwhile. `hash` is
  /// its state hash.
  StagingArea(const OverrideSource& applied, StateHash hash) : applied_{applied}, hash_{hash} {}

  /// Reserves memory for about this many chunks.
  void expect(std::size_t chunks) { chunks_.reserve(chunks); }

  [[nodiscard]] const ChunkOverrides* find(ChunkKey chunk) const override;
  [[nodiscard]] std::span<const OverrideWrite> staged(ChunkKey chunk) const override;

  /// Stages the result of evaluate() on this object, at all levels. Returns the writes, for the store and for
  /// broadcasts.
  std::vector<ChunkWrites> stage(const Outcome& outcome);

  [[nodiscard]] StateHash hash() const { return hash_; }
  /// Every chunk staged.
  [[nodiscard]] const std::unordered_map<ChunkKey, StagedChunk>& chunks() const { return chunks_; }

 private:
  void apply(const ChunkWrites& writes);

  const OverrideSource& applied_;
  StateHash hash_;
  std::unordered_map<ChunkKey, StagedChunk> chunks_;
};

}  // namespace talus::edits
