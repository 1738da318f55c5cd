#include "chunks/generation/patch_store.h"

#include <algorithm>
#include <exception>

namespace talus::server {

PatchStore::PatchStore(const Parts& parts, Logger log, int patch_tiles, std::size_t capacity_bytes,
                       std::size_t max_spare)
    : parts_{parts},
      log_{std::move(log)},
      patch_tiles_{patch_tiles},
      spare_{max_spare},
      patches_{capacity_bytes} {}

PatchStore::~PatchStore() {
  try {
    keep_all();
  } catch (const std::exception& error) {
    log_->warn("not all that was generated is kept on disk: {}", error.what());
  }
}

void PatchStore::keep_all() {
  if (parts_.columns == nullptr) return;
  std::vector<std::pair<PatchKey, StoredPatch>> held;
  {
    const std::lock_guard lock{mutex_};
    held.reserve(patches_.size());
    patches_.for_each([&](const PatchKey& key, const StoredPatch& patch) { held.emplace_back(key, patch); });
  }
  for (const auto& [key, patch] : held) keep_columns(key, patch);
}

bool PatchStore::holds(const PatchKey& patch) const {
  const std::lock_guard lock{mutex_};
  return patches_.holds(patch);
}

PatchStore::Loan PatchStore::obtain(const PatchKey& patch, std::span<const ChunkKey> asked,
                                    BegunPatchPtr begun, const AskAfterStep& after_step,
                                    MeasuredWork& measured) {
  // Asked now, as the client may have moved on when the patch is made.
  Loan loan;
  loan.patch = patch;
  loan.in_views = in_views(asked);
  if (begun == nullptr) {
    const std::lock_guard lock{mutex_};
    if (const StoredPatch* const found = patches_.find(patch)) {
      loan.stacks = found->stacks;
      loan.spent = found->spent;
      return loan;
    }
  }
  const bool outside_views = !in_some_view(patch);
  try {
    make(loan, std::move(begun), after_step, measured);
    if (loan.stacks == nullptr) return loan;
    parts_.memory.note_patch(loan.stacks->bytes());
    parts_.rows.note(patch, *loan.stacks);
    put(loan, outside_views);
  } catch (const std::exception& error) {
    log_->error("patch ({}, {}) at level of detail {} failed: {}", patch.x, patch.z, patch.lod.value(),
                error.what());
  }
  return loan;
}

void PatchStore::finish(const Loan& loan, MeasuredWork& measured, const std::function<bool()>& stops) {
  if (loan.stacks != nullptr && may_go(loan, measured, stops)) {
    note_chunks(measured);
    keep_columns(loan.patch, {loan.stacks, false, loan.spent});
    const std::lock_guard lock{mutex_};
    patches_.erase(loan.patch);
  }
  for (const auto& [key, patch] : loan.evicted) {
    (void)extract_wanted(key, patch, measured, stops);
    note_chunks(measured);
    keep_columns(key, patch);
  }
}

bool PatchStore::read_columns(const PatchKey& patch, std::span<const ChunkKey> chunks) {
  if (parts_.columns == nullptr || holds(patch)) return false;
  std::vector<ChunkKey> columns;
  for (const ChunkKey chunk : chunks) columns.push_back(column_of(chunk));
  std::sort(columns.begin(), columns.end());
  columns.erase(std::unique(columns.begin(), columns.end()), columns.end());
  bool any = false;
  for (const ChunkKey column : columns) {
    const auto kept = parts_.columns->find(column);
    if (!kept) continue;
    any = true;
    parts_.rows.note(column, kept->rows);
    for (const auto& [y, chunk] : kept->chunks) {
      parts_.chunks.put({{column.coord.x, y, column.coord.z}, column.lod}, chunk);
    }
  }
  return any;
}

void PatchStore::note_chunks(const MeasuredWork& measured) {
  if (measured.chunks == 0) return;
  const auto chunks = static_cast<std::int64_t>(measured.chunks);
  chunk_ns_.store(measured.chunk_time.count() / chunks, std::memory_order_relaxed);
}

void PatchStore::keep_columns(const PatchKey& key, const StoredPatch& patch) {
  if (parts_.columns == nullptr) return;
  const std::chrono::nanoseconds terrain = patch.spent / (patch_tiles_ * patch_tiles_);
  const std::chrono::nanoseconds chunk{chunk_ns_.load(std::memory_order_relaxed)};
  for_each_column(key, patch_tiles_, [&](ChunkKey column) {
    ColumnRecord record{rows_of(column, *patch.stacks), {}};
    const std::int64_t last =
        std::min<std::int64_t>(record.rows.last, std::int64_t{record.rows.first} + kMaxKeptRows - 1);
    for (std::int64_t y = record.rows.first; y <= last; ++y) {
      const auto row = static_cast<std::int32_t>(y);
      if (EncodedChunkPtr made = parts_.chunks.find({{column.coord.x, row, column.coord.z}, column.lod})) {
        record.chunks.push_back({row, std::move(made)});
      }
    }
    const bool bare = record.chunks.empty() && record.rows.last >= record.rows.first;
    if (!bare && parts_.columns->worth(terrain + chunk * record.chunks.size())) {
      parts_.columns->put(column, record);
    }
  });
}

bool PatchStore::may_go(const Loan& loan, MeasuredWork& measured, const std::function<bool()>& stops) {
  if (loan.spent > kDearPatch || !loan.in_views) return fully_extracted(loan.patch, *loan.stacks);
  return extract_wanted(loan.patch, {loan.stacks, false, {}}, measured, stops);
}

bool PatchStore::in_views(std::span<const ChunkKey> keys) const {
  return std::all_of(keys.begin(), keys.end(), [this](ChunkKey key) {
    const ChunkRange row{key.coord.y, key.coord.y};
    return parts_.wanted.rows_of(key, row) == row;
  });
}

void PatchStore::make(Loan& loan, BegunPatchPtr begun, const AskAfterStep& after_step,
                      MeasuredWork& measured) {
  const auto began = parts_.clock.thread_cpu();
  if (begun == nullptr) {
    begun = std::make_unique<BegunPatch>();
    begun->stacks = spare_.take();
    begun->build = parts_.generator.start_patch(loan.patch, std::move(*begun->stacks));
  }
  auto next = AfterStep::go_on;
  while (next == AfterStep::go_on && begun->build->step()) next = after_step();
  begun->spent += parts_.clock.thread_cpu() - began;
  switch (next) {
    case AfterStep::pause:
      loan.begun = std::move(begun);
      return;
    case AfterStep::give_up:
      loan.given_up = true;
      return;
    case AfterStep::go_on:
      break;
  }
  *begun->stacks = begun->build->take();
  parts_.metrics.patches_made.add();
  ++measured.patches;
  measured.patch_time += begun->spent;
  loan.spent = begun->spent;
  loan.stacks = spare_.share(std::move(begun->stacks));
}

void PatchStore::put(Loan& loan, bool outside_views) {
  StoredPatch patch{loan.stacks, outside_views, loan.spent};
  const std::lock_guard lock{mutex_};
  loan.evicted.reserve(patches_.size());  // so that nothing is allocated while patches are evicted
  patches_.put(loan.patch, std::move(patch), loan.stacks->bytes(),
               [&](const PatchKey& key, StoredPatch&& evicted) noexcept {
                 loan.evicted.emplace_back(key, std::move(evicted));
               });
}

bool PatchStore::extract_wanted(const PatchKey& key, const StoredPatch& patch, MeasuredWork& measured,
                                const std::function<bool()>& stops) {
  const auto began = parts_.clock.thread_cpu();
  bool all = true;
  for_each_column(key, patch_tiles_, [&](ChunkKey column) {
    const MixedRows mixed = rows_of(column, *patch.stacks);
    ChunkRange rows{mixed.first, mixed.last};
    if (!patch.outside_views) rows = parts_.wanted.rows_of(column, rows);
    const std::int64_t last = std::min(rows.last, rows.first + kMaxExtractedRows - 1);
    all = all && last == rows.last;
    for (std::int64_t y = rows.first; y <= last; ++y) {
      if (stops()) return void(all = false);
      const ChunkKey chunk{{column.coord.x, static_cast<std::int32_t>(y), column.coord.z}, column.lod};
      if (parts_.chunks.holds(chunk)) continue;
      (void)parts_.maker.chunk(patch.stacks.get(), chunk);
      all = all && parts_.chunks.holds(chunk);  // a small cache may not keep it
      ++measured.chunks;
    }
  });
  measured.chunk_time += parts_.clock.thread_cpu() - began;
  return all;
}

bool PatchStore::fully_extracted(const PatchKey& patch, const terrain::Stacks& stacks) {
  bool all = true;
  for_each_column(patch, patch_tiles_, [&](ChunkKey column) {
    if (!all) return;
    const MixedRows mixed = rows_of(column, stacks);
    all = std::int64_t{mixed.last} - mixed.first < kMaxExtractedRows;
    for (std::int32_t y = mixed.first; all && y <= mixed.last; ++y) {
      all = parts_.chunks.holds({{column.coord.x, y, column.coord.z}, column.lod});
    }
  });
  return all;
}

MixedRows PatchStore::rows_of(ChunkKey column, const terrain::Stacks& stacks) {
  const auto known = parts_.rows.exact(column);
  return known ? *known : parts_.generator.mixed_rows(stacks, column);
}

bool PatchStore::in_some_view(const PatchKey& patch) const {
  bool any = false;
  for_each_column(patch, patch_tiles_,
                  [&](ChunkKey column) { any = any || parts_.wanted.has_column(column); });
  return any;
}

void PatchStore::set_capacity(std::size_t capacity_bytes) {
  const std::lock_guard lock{mutex_};
  patches_.set_capacity(capacity_bytes);
}

bool PatchStore::fit(std::size_t& probes) {
  // Freeing a patch takes long: generators run in between.
  for (;;) {
    std::size_t one = std::min<std::size_t>(probes, 1);
    probes -= one;
    const std::lock_guard lock{mutex_};
    const bool fits = patches_.fit(one);
    probes += one;
    if (fits || probes == 0) return fits;
  }
}

std::size_t PatchStore::bytes() const {
  const std::lock_guard lock{mutex_};
  return patches_.bytes();
}

}  // namespace talus::server
