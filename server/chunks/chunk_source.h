// Where a session gets chunks and heights. BaseChunks (generation/) gives them as generated; EditedChunks
// (edits/) stands before it, with a cache of its own for chunks that were edited.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>

#include <talus/voxel/coords.h>
#include <talus/voxel/material.h>
#include <talus/voxel/view_shape.h>

#include "chunks/chunk_change.h"
#include "chunks/encoded_chunk.h"
#include "chunks/heights_query.h"
#include "chunks/mailbox.h"

namespace talus::server {

/// Rows of chunks of one column outside which every chunk is known to be uniform, at revision 0.
struct MixedRows {
  std::int32_t first = std::numeric_limits<std::int32_t>::min();
  std::int32_t last = std::numeric_limits<std::int32_t>::max();  // first - 1 where none is mixed
  MaterialId below{};  // of every chunk under `first`; air is above `last`

  /// The material of a uniform row; none where the row may hold anything.
  [[nodiscard]] std::optional<MaterialId> uniform_at(std::int32_t y) const {
    if (y < first) return below;
    if (y > last) return kAir;
    return std::nullopt;
  }
};

/// What is wanted soon goes before what is wanted later, but never takes all of the generators' time.
enum class Urgency : std::uint8_t { soon, later };

/// Callable from any thread. No call generates, reads a disk, or waits for who does.
class ChunkSource {
 public:
  virtual ~ChunkSource() = default;

  /// The newest version of the chunk where it is in memory or costs nothing to know; else null.
  [[nodiscard]] virtual EncodedChunkPtr find(ChunkKey key) = 0;

  /// A version newer than `revision`, where there is one in memory; else null, as always where chunks never
  /// change. Asked when a chunk that waited is written.
  [[nodiscard]] virtual EncodedChunkPtr newer(ChunkKey key, std::uint64_t revision) = 0;

  /// Of the newest version, in memory or not: kBaseRevision as generated. Never falls. It is raised before
  /// the change is told, so who was not told yet finds it here.
  [[nodiscard]] virtual std::uint64_t revision(ChunkKey) const { return kBaseRevision; }
  /// The voxels that changed after revision `since`. None where that is not known, or they are more than
  /// `most`.
  [[nodiscard]] virtual std::optional<ChangedVoxels> changes_since(ChunkKey, std::uint64_t /*since*/,
                                                                   std::size_t /*most*/) const {
    return std::nullopt;
  }

  /// What is known of the key's column. A source that has edited chunks counts their rows as mixed.
  [[nodiscard]] virtual MixedRows column(ChunkKey key) = 0;

  /// Whether so few chunks wait that threads may soon have none to make.
  [[nodiscard]] virtual bool has_little_to_do() const { return false; }

  /// Chunks of one level in the same square of so many columns a side, aligned to its size, are made
  /// together: who wants several asks for them at once. A power of two.
  [[nodiscard]] virtual int columns_together() const = 0;

  /// Lets the mailbox's owner wait for the chunks: one ChunkReady comes for each. Returns how many, from the
  /// first on; the others are refused, as the queue is full or memory short. For those no answer comes; but
  /// where the owner waits for nothing else, a QueueHasRoom does when it is worth another try. Who cancels
  /// the last of what it waits for tries again by itself.
  [[nodiscard]] virtual std::size_t submit(const MailboxPtr& mailbox, std::span<const ChunkKey> keys,
                                           Urgency urgency) = 0;
  /// Chunks that the client waits for are wanted soon from now on. No effect on others.
  virtual void hasten(ClientId client, std::span<const ChunkKey> keys) = 0;
  /// An answer already in the mailbox may still be found there.
  virtual void cancel(ClientId client, std::span<const ChunkKey> keys) = 0;

  /// The chunks that the mailbox's owner looks at, and those that it comes to look at soon if it moves on as
  /// it does; in place of what was said before, empty: none. A hint on what else is worth making; and from
  /// here on ChunksChanged comes where one of them is edited. Throws std::bad_alloc.
  virtual void set_wanted(const MailboxPtr& mailbox, std::span<const LevelBox> boxes) = 0;

  /// Surface heights of base columns, as generated, and what else the query asks for; one HeightsReady comes.
  /// The caller never gives a ticket twice.
  virtual void submit_heights(const MailboxPtr& mailbox, std::uint64_t ticket, HeightsQuery query) = 0;
  virtual void cancel_heights(ClientId client, std::uint64_t ticket) = 0;

  /// The tile of the map where it is in memory; else null, and submit_heights() draws it.
  [[nodiscard]] virtual PicturePtr find_map(const map::Tile&) { return nullptr; }
};

}  // namespace talus::server
