// The interface through which sessions, HTTP and the edit log get chunks and heights. Chunks (chunks.h)
// implements it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include <talus/voxel/coords.h>
#include <talus/voxel/material.h>
#include <talus/voxel/view_shape.h>

#include "chunks/applied_edits.h"
#include "chunks/chunk_change.h"
#include "chunks/encoded_chunk.h"
#include "chunks/heights_query.h"
#include "chunks/mailbox.h"

namespace talus::server {

/// Rows of chunks of one column. Every chunk outside of them is uniform, at kBaseRevision.
struct MixedRows {
  std::int32_t first = std::numeric_limits<std::int32_t>::min();
  std::int32_t last = std::numeric_limits<std::int32_t>::max();  // first - 1 if no row is mixed
  MaterialId below{};  // of every chunk under `first`; air is above `last`

  /// Returns the material of a uniform row; nullopt if the row may be mixed.
  [[nodiscard]] std::optional<MaterialId> uniform_at(std::int32_t y) const {
    if (y < first) return below;
    if (y > last) return kAir;
    return std::nullopt;
  }
};

/// Chunks wanted soon are generated before chunks wanted later, but never take all of the generators' time.
enum class Urgency : std::uint8_t { soon, later };

/// Callable from any thread. No call generates, reads a disk, or waits for a thread that does.
class ChunkSource {
 public:
  virtual ~ChunkSource() = default;

  /// Returns the chunk if it is in memory or costs nothing to know; else null. Version::edited: with its
  /// newest edit.
  [[nodiscard]] virtual EncodedChunkPtr find(ChunkKey key, Version version) = 0;

  /// Returns the chunk with edits newer than `revision` if it is in memory; else null. It is called when a
  /// queued chunk is written.
  [[nodiscard]] virtual EncodedChunkPtr newer(ChunkKey key, std::uint64_t revision) = 0;

  /// Returns the revision of the chunk's newest edit, whether or not the chunk is in memory; kBaseRevision if
  /// it was never edited. It never falls. It is raised before ChunksChanged is sent, so a client that has not
  /// received that yet finds the change here.
  [[nodiscard]] virtual std::uint64_t revision(ChunkKey) const { return kBaseRevision; }
  /// Returns the voxels that changed after revision `since`; nullopt if that is not known, or if they are
  /// more than `max_voxels`.
  [[nodiscard]] virtual std::optional<ChangedVoxels> changes_since(ChunkKey, std::uint64_t /*since*/,
                                                                   std::size_t /*max_voxels*/) const {
    return std::nullopt;
  }

  /// See AppliedEdits.
  virtual void edited_chunks(const LevelBox&, const ColumnFilter&, std::vector<ChunkKey>&) const {}

  /// Returns what is known of the key's column. Version::edited: rows of edited chunks count as mixed.
  [[nodiscard]] virtual MixedRows column(ChunkKey key, Version version) = 0;

  /// True if so few chunks are queued that generator threads may soon be idle.
  [[nodiscard]] virtual bool has_little_to_do() const { return false; }

  /// Chunks of one level in one square of this number of columns a side, aligned to its size, are made
  /// together: submit them in one call. A power of two.
  [[nodiscard]] virtual int columns_together() const = 0;

  /// Queues the chunks for the mailbox's owner, which receives one ChunkReady for each. Returns how many were
  /// accepted, from the first on; the others are refused, because the queue is full or memory is short. A
  /// chunk for which the owner waits already comes in the version for which it was submitted first.
  ///
  /// Refused keys get no answer. An owner with nothing else pending receives QueueHasRoom when a retry may
  /// succeed; after it has cancelled its last pending key, it must retry on its own.
  [[nodiscard]] virtual std::size_t submit(const MailboxPtr& mailbox, std::span<const ChunkKey> keys,
                                           Urgency urgency, Version version) = 0;
  /// Chunks for which the client waits are wanted soon from now on. No effect on other chunks.
  virtual void hasten(ClientId client, std::span<const ChunkKey> keys) = 0;
  /// An answer that is in the mailbox already may still be taken from there.
  virtual void cancel(ClientId client, std::span<const ChunkKey> keys) = 0;

  /// Replaces the boxes in which the mailbox's owner views chunks, or will soon if it moves on as it does;
  /// empty: it views none. The owner receives ChunksChanged when a chunk in them is edited. The boxes are
  /// also a hint of what else to generate. Throws std::bad_alloc.
  virtual void set_wanted(const MailboxPtr& mailbox, std::span<const LevelBox> boxes) = 0;

  /// The same for an owner that needs edited chunks alone: the boxes are no hint.
  virtual void set_watched(const MailboxPtr& mailbox, std::span<const LevelBox> boxes) {
    set_wanted(mailbox, boxes);
  }

  /// Queues a query for surface heights of base columns, as generated, and what else it asks for. One
  /// HeightsReady comes. The caller never uses a ticket twice.
  virtual void submit_heights(const MailboxPtr& mailbox, std::uint64_t ticket, HeightsQuery query) = 0;
  virtual void cancel_heights(ClientId client, std::uint64_t ticket) = 0;

  /// Returns the tile of the map if it is in memory; else null, and submit_heights() draws it.
  [[nodiscard]] virtual PicturePtr find_map(const map::Tile&) { return nullptr; }
};

}  // namespace talus::server
