// Stacks of patches in memory, bounded in bytes: found, made, and turned into chunks before they go. Callable
// from any thread.
//
// A chunk is a fiftieth of what its part of the patch takes. So when a piece of work on a patch ends, those
// of its mixed chunks that somebody looks at, or comes to look at soon, are extracted into the chunk cache,
// and the patch is let go: the next is made in its memory, which is still in the processor's cache. A patch
// stays that was dear to make, that no View has, or that has more rows than are extracted; and what is wanted
// of it is extracted when it is evicted. Chunks of a patch that goes are kept on disk where that pays.
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <functional>
#include <mutex>
#include <span>
#include <utility>
#include <vector>

#include "chunks/cache/chunk_cache.h"
#include "chunks/cache/clock_cache.h"
#include "chunks/column_cache/column_cache.h"
#include "chunks/generation/begun_patch.h"
#include "chunks/generation/chunk_maker.h"
#include "chunks/generation/column_rows.h"
#include "chunks/generation/cost_model.h"
#include "chunks/generation/generator_memory.h"
#include "chunks/generation/stacks_pool.h"
#include "chunks/generation/wanted_chunks.h"
#include "runtime/clock.h"

namespace talus::server {

/// A patch in memory.
struct StoredPatch {
  StacksPtr stacks;
  /// It was made for chunks that no View has: who asks for chunks one by one mostly comes to ask for those
  /// beside them, and all are extracted.
  bool outside_views = false;
  /// Thread time that it took to make.
  std::chrono::nanoseconds spent{};
};

class PatchStore {
 public:
  /// Rows of a column that are extracted before its patch is evicted: worlds can be far deeper than what
  /// anybody looks at.
  static constexpr std::int32_t kMaxExtractedRows = 8;
  /// Rows of a column that are looked at for chunks to be kept on disk.
  static constexpr std::int32_t kMaxKeptRows = 64;

  /// A patch that takes longer to make is kept. About one in twenty that are let go is made again, and memory
  /// out of the processor's cache costs a tenth of a millisecond more.
  static constexpr std::chrono::milliseconds kDearPatch{2};

  /// What a patch store works with; all of it outlives the store.
  struct Parts {
    const Generator& generator;
    ChunkMaker& maker;
    ChunkCache& chunks;
    ColumnRows& rows;
    const WantedChunks& wanted;
    GeneratorMemory& memory;
    Metrics& metrics;
    const Clock& clock;
    ColumnCache* columns = nullptr;  // null: nothing is kept on disk
  };
  /// Keeps the memory of `max_spare` patches that were let go, for the next.
  PatchStore(const Parts& parts, Logger log, int patch_tiles, std::size_t capacity_bytes,
             std::size_t max_spare);
  /// What of its patches is worth it is kept on disk.
  ~PatchStore();
  PatchStore(const PatchStore&) = delete;
  PatchStore& operator=(const PatchStore&) = delete;

  /// Whether the patch is in memory. Not a use.
  [[nodiscard]] bool holds(const PatchKey& patch) const;

  /// Reads the chunks' columns, which are of the patch, from the disk into memory, as far as they are kept
  /// there; false where none is, or the patch is in memory and cutting is cheaper.
  [[nodiscard]] bool read_columns(const PatchKey& patch, std::span<const ChunkKey> chunks);

  /// One piece of work on one patch: obtain() it, make chunks of it, and let it go by finish().
  struct Loan {
    PatchKey patch{};
    StacksPtr stacks{};                                     // null where the patch could not be made
    bool given_up = false;                                  // after_step() ended it
    BegunPatchPtr begun{};                                  // after_step() paused it
    std::chrono::nanoseconds spent{};                       // as StoredPatch's
    bool in_views = false;                                  // some View has all that was asked of it
    std::vector<std::pair<PatchKey, StoredPatch>> evicted;  // for this one
  };
  /// The patch from memory, or made now, from where it is if it was `begun`, as far as after_step() lets it.
  /// `asked` are the chunks that somebody waits for. `measured` gets what it took once it is made.
  [[nodiscard]] Loan obtain(const PatchKey& patch, std::span<const ChunkKey> asked, BegunPatchPtr begun,
                            const AskAfterStep& after_step, MeasuredWork& measured);
  /// Extracts what Views want of the patch, lets it go where nothing more is, and extracts what was evicted
  /// for it: call it when nobody waits for this thread any more. Ends early, and keeps the patch, once
  /// stops() is true, which is asked before each chunk.
  void finish(const Loan& loan, MeasuredWork& measured, const std::function<bool()>& stops);

  /// On disk, what of all patches in memory is worth it.
  void keep_all();

  /// Takes no time: call fit() until all fits.
  void set_capacity(std::size_t capacity_bytes);
  /// ClockCache's: evicts what is too much, without extraction.
  [[nodiscard]] bool fit(std::size_t& looks);
  [[nodiscard]] std::size_t bytes() const;

 private:
  /// Fills in what became of it.
  void make(Loan& loan, BegunPatchPtr begun, const AskAfterStep& after_step, MeasuredWork& measured);
  void put(Loan& loan, bool outside_views);
  /// Returns whether all that is wanted of the patch is in the chunk cache now.
  bool extract_wanted(const PatchKey& key, const StoredPatch& patch, MeasuredWork& measured,
                      const std::function<bool()>& stops);
  void note_chunks(const MeasuredWork& measured);
  /// On disk, those of its chunks that are in memory.
  void keep_columns(const PatchKey& key, const StoredPatch& patch);
  /// Whether the patch is not worth its memory any more.
  [[nodiscard]] bool may_go(const Loan& loan, MeasuredWork& measured, const std::function<bool()>& stops);
  [[nodiscard]] bool in_views(std::span<const ChunkKey> keys) const;
  /// Whether all mixed chunks of the patch are in the chunk cache, where they stay longer for their size, and
  /// no column has more of them than would be extracted.
  [[nodiscard]] bool fully_extracted(const PatchKey& patch, const terrain::Stacks& stacks);
  /// Of the key's column over these stacks.
  [[nodiscard]] MixedRows rows_of(ChunkKey column, const terrain::Stacks& stacks);
  [[nodiscard]] bool in_some_view(const PatchKey& patch) const;

  const Parts parts_;
  const Logger log_;
  const int patch_tiles_;
  std::atomic<std::int64_t> chunk_ns_{0};  // thread time that one of late took
  StacksPool spare_;
  mutable std::mutex mutex_;
  ClockCache<PatchKey, StoredPatch> patches_;
};

}  // namespace talus::server
