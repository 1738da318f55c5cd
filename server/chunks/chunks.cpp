#include "chunks/chunks.h"

#include <algorithm>
#include <utility>

namespace talus::server {
namespace {

// The part of the chunk cache's bytes that goes to rows of columns: a column takes less than the smallest
// chunk.
constexpr std::size_t kRowsShare = 16;

std::size_t bytes_of_rows(const GenerationSettings& settings) {
  return settings.chunk_cache_bytes / kRowsShare;
}

std::size_t bytes_of_chunks(const GenerationSettings& settings) {
  return settings.chunk_cache_bytes - bytes_of_rows(settings) - settings.map_cache_bytes -
         settings.merged_cache_bytes;
}

}  // namespace

Chunks::Chunks(std::unique_ptr<const Generator> generator, const GenerationSettings& settings, Logger log,
               Metrics& metrics, MemoryBudget& memory, const Clock& clock, std::optional<Edits> edits,
               std::unique_ptr<ColumnCache> columns)
    : generator_{std::move(generator)},
      settings_{settings},
      metrics_{metrics},
      memory_{memory},
      edits_{edits},
      fitted_bytes_{settings.chunk_cache_bytes + settings.patch_cache_bytes},
      columns_{std::move(columns)},
      chunks_{bytes_of_chunks(settings)},
      rows_{*generator_, settings.patch_tiles, bytes_of_rows(settings)},
      maps_{settings.map_cache_bytes},
      merged_{edits ? std::make_unique<MergedChunks>(edits->applied, log, settings.merged_cache_bytes)
                    : nullptr},
      maker_{*generator_, chunks_, rows_, metrics, log, &maps_},
      generator_memory_{memory, settings.threads, log, settings.piece_bytes, settings.ground_bytes},
      patches_{
          {*generator_, maker_, chunks_, rows_, wanted_, generator_memory_, metrics, clock, columns_.get()},
          log,
          settings.patch_tiles,
          settings.patch_cache_bytes,
          settings.threads},
      pool_{{maker_, patches_, generator_memory_, metrics, memory, clock, merged_.get()},
            {settings.threads, settings.patch_tiles, settings.queue_chunks, settings.own_chunks},
            log} {
  memory_.when_jobs_resume([this] { pool_.jobs_resume(); });
}

Chunks::~Chunks() {
  memory_.when_jobs_resume(nullptr);
}

void Chunks::start() {
  pool_.start();
}

EncodedChunkPtr Chunks::find(ChunkKey key, Version version) {
  const std::uint64_t newest = version == Version::edited ? revision(key) : kBaseRevision;
  const bool edited = newest != kBaseRevision;
  EncodedChunkPtr chunk = edited ? merged_->newer(key, newest - 1) : maker_.known(key);
  if (chunk == nullptr) {
    metrics_.cache_misses.add();
  } else {
    (!edited && chunk->uniform() ? metrics_.uniform_answers : metrics_.cache_hits).add();
  }
  return chunk;
}

EncodedChunkPtr Chunks::newer(ChunkKey key, std::uint64_t revision) {
  return this->revision(key) <= revision ? nullptr : merged_->newer(key, revision);
}

std::optional<ChangedVoxels> Chunks::changes_since(ChunkKey key, std::uint64_t since,
                                                   std::size_t max_voxels) const {
  return edits_ ? edits_->applied.changes_since(key, since, max_voxels) : std::nullopt;
}

MixedRows Chunks::column(ChunkKey key, Version version) {
  MixedRows rows = rows_.known(key);
  const bool with_edits = version == Version::edited && edits_;
  const ChunkRange edited = with_edits ? edits_->applied.edited_rows(key) : ChunkRange{};
  if (edited.size() == 0) return rows;
  rows.first = std::min(rows.first, static_cast<std::int32_t>(edited.first));
  rows.last = std::max(rows.last, static_cast<std::int32_t>(edited.last));
  return rows;
}

std::size_t Chunks::submit(const MailboxPtr& mailbox, std::span<const ChunkKey> keys, Urgency urgency,
                           Version version) {
  return pool_.add({mailbox, version}, keys, urgency);
}

void Chunks::hasten(ClientId client, std::span<const ChunkKey> keys) {
  pool_.hasten(client, keys);
}

void Chunks::cancel(ClientId client, std::span<const ChunkKey> keys) {
  pool_.cancel(client, keys);
}

void Chunks::set_wanted(const MailboxPtr& mailbox, std::span<const LevelBox> boxes) {
  if (edits_) edits_->feed.watch(mailbox, boxes);
  wanted_.set(mailbox->owner(), boxes);
}

void Chunks::set_watched(const MailboxPtr& mailbox, std::span<const LevelBox> boxes) {
  if (edits_) edits_->feed.watch(mailbox, boxes);
  wanted_.set(mailbox->owner(), {});
}

void Chunks::submit_heights(const MailboxPtr& mailbox, std::uint64_t ticket, HeightsQuery query) {
  pool_.add(HeightsTask{mailbox, ticket, std::move(query)});
}

void Chunks::cancel_heights(ClientId client, std::uint64_t ticket) {
  pool_.cancel_heights(client, ticket);
}

PicturePtr Chunks::find_map(const map::Tile& tile) {
  PicturePtr picture = maps_.find(tile);
  if (picture != nullptr) metrics_.map_tiles_found.add();
  return picture;
}

bool Chunks::fit_caches() {
  pool_.jobs_resume();
  const std::unique_lock lock{fitting_, std::try_to_lock};
  if (!lock) return true;  // another thread is doing it
  const std::uint64_t configured = settings_.chunk_cache_bytes + settings_.patch_cache_bytes;
  const std::uint64_t allowed = memory_.for_caches(configured);
  const std::uint64_t change = allowed > fitted_bytes_ ? allowed - fitted_bytes_ : fitted_bytes_ - allowed;
  if (change > configured / 256 || (allowed == configured && change > 0)) {
    const auto share = [&](std::size_t bytes) {
      return static_cast<std::size_t>(static_cast<double>(bytes) * static_cast<double>(allowed) /
                                      static_cast<double>(configured));
    };
    chunks_.set_capacity(share(bytes_of_chunks(settings_)));
    rows_.set_capacity(share(bytes_of_rows(settings_)));
    maps_.set_capacity(share(settings_.map_cache_bytes));
    if (merged_ != nullptr) merged_->set_capacity(share(settings_.merged_cache_bytes));
    patches_.set_capacity(share(settings_.patch_cache_bytes));
    fitted_bytes_ = allowed;
  }
  std::size_t chunks = kChunksPerFit;
  const auto tiles =
      static_cast<std::size_t>(settings_.patch_tiles) * static_cast<std::size_t>(settings_.patch_tiles);
  std::size_t patches = std::max<std::size_t>(1, kTilesPerFit / tiles);
  const bool patches_fit = patches_.fit(patches);
  const bool chunks_fit = chunks_.fit(chunks) && rows_.fit(chunks) && maps_.fit(chunks) &&
                          (merged_ == nullptr || merged_->fit(chunks));
  const std::size_t merged = merged_ == nullptr ? 0 : merged_->bytes();
  memory_.set(MemoryUse::chunk_cache, chunks_.bytes() + rows_.bytes() + maps_.bytes() + merged);
  memory_.set(MemoryUse::patch_cache, patches_.bytes());
  return patches_fit && chunks_fit;
}

void Chunks::count_columns() {
  if (columns_ != nullptr) memory_.set(MemoryUse::column_cache, columns_->status().memory_bytes);
}

void Chunks::keep_on_disk() {
  if (columns_ == nullptr) return;
  patches_.keep_all();
  columns_->flush();
}

Chunks::State Chunks::status() {
  const GenerationPool::State pool = pool_.status();
  return {pool.jobs,        pool.clients,  chunks_.bytes(),
          patches_.bytes(), maps_.bytes(), columns_ ? std::optional{columns_->status()} : std::nullopt};
}

}  // namespace talus::server
