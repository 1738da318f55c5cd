// The ChunkSource of chunks with their edits, before that of chunks as generated. What was never edited is
// the base's, for one look-up of its revision.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "chunks/chunk_source.h"
#include "edits/applied_edits.h"
#include "edits/change_feed.h"
#include "edits/merged_chunks.h"
#include "runtime/metrics/metrics.h"

namespace talus::server {

class EditedChunks final : public ChunkSource {
 public:
  /// All outlive this. `base` answers through `merged`; `edits` are those of `merged`.
  EditedChunks(ChunkSource& base, const AppliedEdits& edits, MergedChunks& merged, ChangeFeed& feed,
               Metrics& metrics)
      : base_{base}, edits_{edits}, merged_{merged}, feed_{feed}, metrics_{metrics} {}

  [[nodiscard]] EncodedChunkPtr find(ChunkKey key) override;
  [[nodiscard]] EncodedChunkPtr newer(ChunkKey key, std::uint64_t revision) override;
  [[nodiscard]] std::uint64_t revision(ChunkKey key) const override { return edits_.revision(key); }
  [[nodiscard]] std::optional<ChangedVoxels> changes_since(ChunkKey key, std::uint64_t since,
                                                           std::size_t most) const override {
    return edits_.changes_since(key, since, most);
  }
  /// Rows of chunks that were ever edited count as mixed.
  [[nodiscard]] MixedRows column(ChunkKey key) override;
  [[nodiscard]] bool has_little_to_do() const override { return base_.has_little_to_do(); }
  [[nodiscard]] int columns_together() const override { return base_.columns_together(); }
  [[nodiscard]] std::size_t submit(const MailboxPtr& mailbox, std::span<const ChunkKey> keys,
                                   Urgency urgency) override;
  void hasten(ClientId client, std::span<const ChunkKey> keys) override { base_.hasten(client, keys); }
  void cancel(ClientId client, std::span<const ChunkKey> keys) override { base_.cancel(client, keys); }
  void set_wanted(const MailboxPtr& mailbox, std::span<const LevelBox> boxes) override;
  /// Of the ground as generated, as maps are.
  void submit_heights(const MailboxPtr& mailbox, std::uint64_t ticket, HeightsQuery query) override {
    base_.submit_heights(mailbox, ticket, std::move(query));
  }
  void cancel_heights(ClientId client, std::uint64_t ticket) override {
    base_.cancel_heights(client, ticket);
  }
  [[nodiscard]] PicturePtr find_map(const map::Tile& tile) override { return base_.find_map(tile); }

 private:
  ChunkSource& base_;
  const AppliedEdits& edits_;
  MergedChunks& merged_;
  ChangeFeed& feed_;
  Metrics& metrics_;
};

}  // namespace talus::server
