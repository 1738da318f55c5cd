// Stacks of patches in memory, bounded in bytes: finds them, makes them, and turns them into chunks before
// they go. Callable from any thread.
//
// A chunk takes a fiftieth of the memory of its part of the patch. So when a piece of work on a patch ends,
// the mixed chunks that Views contain, or will soon contain, are extracted into the chunk cache, and the
// patch is released: the next is made in its memory, which is still in the processor's cache. A patch stays
// if it was expensive to make, if no View has it, or if it has more rows than are extracted; what is wanted
// of it is extracted when it is evicted. Chunks of a released patch are kept on disk if that pays.
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
  /// The patch was made for chunks that no View has. A client that asks for single chunks mostly asks for
  /// their neighbours next, so all are extracted.
  bool outside_views = false;
  /// Thread time of making it.
  std::chrono::nanoseconds spent{};
};

class PatchStore {
 public:
  /// Maximum number of rows of a column that are extracted before its patch is evicted: worlds can be far
  /// deeper than any View.
  static constexpr std::int32_t kMaxExtractedRows = 8;
  /// Maximum number of rows of a column that are searched for chunks to be kept on disk.
  static constexpr std::int32_t kMaxKeptRows = 64;

  /// A patch that takes longer to make is kept. About one in twenty that are released is made again, and
  /// memory outside the processor's cache costs a tenth of a millisecond more.
  static constexpr std::chrono::milliseconds kDearPatch{2};

  /// The parts that a patch store works with; all of them outlive the store.
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
  /// Keeps the memory of `max_spare` released patches for the next.
  PatchStore(const Parts& parts, Logger log, int patch_tiles, std::size_t capacity_bytes,
             std::size_t max_spare);
  /// Keeps on disk what is worth it of its patches.
  ~PatchStore();
  PatchStore(const PatchStore&) = delete;
  PatchStore& operator=(const PatchStore&) = delete;

  /// Returns true if the patch is in memory. Does not count as a use.
  [[nodiscard]] bool holds(const PatchKey& patch) const;

  /// Reads the chunks' columns, which are of the patch, from the disk into memory, as far as they are kept
  /// there. Returns false if nothing is kept, or if the patch is in memory and extracting is cheaper.
  [[nodiscard]] bool read_columns(const PatchKey& patch, std::span<const ChunkKey> chunks);

  /// One piece of work on one patch: obtain() it, make chunks of it, and release it by finish().
  struct Loan {
    PatchKey patch{};
    StacksPtr stacks{};                                     // null if the patch could not be made
    bool given_up = false;                                  // after_step() ended it
    BegunPatchPtr begun{};                                  // after_step() paused it
    std::chrono::nanoseconds spent{};                       // StoredPatch's spent
    bool in_views = false;                                  // some View has all chunks that were asked for
    std::vector<std::pair<PatchKey, StoredPatch>> evicted;  // evicted to make room for this one
  };
  /// Returns the patch from memory, or makes it now, from where it is if it was `begun`, as far as
  /// after_step() lets it. `asked`: the chunks that clients wait for. `measured` gets the cost when it is
  /// made.
  [[nodiscard]] Loan obtain(const PatchKey& patch, std::span<const ChunkKey> asked, BegunPatchPtr begun,
                            const AskAfterStep& after_step, MeasuredWork& measured);
  /// Extracts what Views want of the patch, releases the patch if nothing more is wanted, and extracts what
  /// was evicted for it. Call it when no client waits for this thread any more. Ends early, and keeps the
  /// patch, if stops() returns true; it is called before each chunk.
  void finish(const Loan& loan, MeasuredWork& measured, const std::function<bool()>& stops);

  /// Writes to disk what is worth it of all patches in memory.
  void keep_all();

  /// Takes constant time: call fit() until all fits.
  void set_capacity(std::size_t capacity_bytes);
  /// ClockCache's: evicts what is too much, without extraction.
  [[nodiscard]] bool fit(std::size_t& probes);
  [[nodiscard]] std::size_t bytes() const;

 private:
  /// Fills in the outcome.
  void make(Loan& loan, BegunPatchPtr begun, const AskAfterStep& after_step, MeasuredWork& measured);
  void put(Loan& loan, bool outside_views);
  /// Returns true if all that is wanted of the patch is in the chunk cache now.
  bool extract_wanted(const PatchKey& key, const StoredPatch& patch, MeasuredWork& measured,
                      const std::function<bool()>& stops);
  void note_chunks(const MeasuredWork& measured);
  /// Writes to disk the chunks of it that are in memory.
  void keep_columns(const PatchKey& key, const StoredPatch& patch);
  /// Returns true if the patch is not worth its memory any more.
  [[nodiscard]] bool may_go(const Loan& loan, MeasuredWork& measured, const std::function<bool()>& stops);
  [[nodiscard]] bool in_views(std::span<const ChunkKey> keys) const;
  /// Returns true if all mixed chunks of the patch are in the chunk cache, where they stay longer for their
  /// size, and no column has more of them than would be extracted.
  [[nodiscard]] bool fully_extracted(const PatchKey& patch, const terrain::Stacks& stacks);
  /// Returns the rows of the key's column over these stacks.
  [[nodiscard]] MixedRows rows_of(ChunkKey column, const terrain::Stacks& stacks);
  [[nodiscard]] bool in_some_view(const PatchKey& patch) const;

  const Parts parts_;
  const Logger log_;
  const int patch_tiles_;
  std::atomic<std::int64_t> chunk_ns_{0};  // thread time of recent chunks
  StacksPool spare_;
  mutable std::mutex mutex_;
  ClockCache<PatchKey, StoredPatch> patches_;
};

}  // namespace talus::server
