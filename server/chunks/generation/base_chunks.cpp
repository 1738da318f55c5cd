#include "chunks/generation/base_chunks.h"

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

BaseChunks::BaseChunks(std::unique_ptr<const Generator> generator, const GenerationSettings& settings,
                       Logger log, Metrics& metrics, MemoryBudget& memory, const Clock& clock,
                       ChunkOverlay* overlay, std::unique_ptr<ColumnCache> columns)
    : generator_{std::move(generator)},
      settings_{settings},
      metrics_{metrics},
      memory_{memory},
      overlay_{overlay},
      fitted_bytes_{settings.chunk_cache_bytes + settings.patch_cache_bytes},
      columns_{std::move(columns)},
      chunks_{bytes_of_chunks(settings)},
      rows_{*generator_, settings.patch_tiles, bytes_of_rows(settings)},
      maps_{settings.map_cache_bytes},
      maker_{*generator_, chunks_, rows_, metrics, log, &maps_},
      generator_memory_{memory, settings.threads, log, settings.piece_bytes, settings.ground_bytes},
      patches_{
          {*generator_, maker_, chunks_, rows_, wanted_, generator_memory_, metrics, clock, columns_.get()},
          log,
          settings.patch_tiles,
          settings.patch_cache_bytes,
          settings.threads},
      pool_{{maker_, patches_, generator_memory_, metrics, memory, clock, overlay},
            {settings.threads, settings.patch_tiles, settings.queue_chunks, settings.own_chunks},
            log} {
  if (overlay_ != nullptr) overlay_->set_capacity(settings.merged_cache_bytes);
  memory_.when_jobs_resume([this] { pool_.jobs_resume(); });
}

BaseChunks::~BaseChunks() {
  memory_.when_jobs_resume(nullptr);
}

void BaseChunks::start() {
  pool_.start();
}

EncodedChunkPtr BaseChunks::find(ChunkKey key) {
  EncodedChunkPtr chunk = maker_.known(key);
  if (chunk == nullptr) {
    metrics_.cache_misses.add();
  } else {
    (chunk->uniform() ? metrics_.uniform_answers : metrics_.cache_hits).add();
  }
  return chunk;
}

EncodedChunkPtr BaseChunks::newer(ChunkKey, std::uint64_t) {
  return nullptr;
}

MixedRows BaseChunks::column(ChunkKey key) {
  return rows_.known(key);
}

std::size_t BaseChunks::submit(const MailboxPtr& mailbox, std::span<const ChunkKey> keys, Urgency urgency) {
  return pool_.submit(mailbox, keys, urgency);
}

void BaseChunks::hasten(ClientId client, std::span<const ChunkKey> keys) {
  pool_.hasten(client, keys);
}

void BaseChunks::cancel(ClientId client, std::span<const ChunkKey> keys) {
  pool_.cancel(client, keys);
}

void BaseChunks::set_wanted(const MailboxPtr& mailbox, std::span<const LevelBox> boxes) {
  wanted_.set(mailbox->owner(), boxes);
}

void BaseChunks::submit_heights(const MailboxPtr& mailbox, std::uint64_t ticket, HeightsQuery query) {
  pool_.submit_heights(HeightsTask{mailbox, ticket, std::move(query)});
}

void BaseChunks::cancel_heights(ClientId client, std::uint64_t ticket) {
  pool_.cancel_heights(client, ticket);
}

PicturePtr BaseChunks::find_map(const map::Tile& tile) {
  PicturePtr picture = maps_.find(tile);
  if (picture != nullptr) metrics_.map_tiles_found.add();
  return picture;
}

bool BaseChunks::fit_caches() {
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
    if (overlay_ != nullptr) overlay_->set_capacity(share(settings_.merged_cache_bytes));
    patches_.set_capacity(share(settings_.patch_cache_bytes));
    fitted_bytes_ = allowed;
  }
  std::size_t chunks = kChunksPerFit;
  const auto tiles =
      static_cast<std::size_t>(settings_.patch_tiles) * static_cast<std::size_t>(settings_.patch_tiles);
  std::size_t patches = std::max<std::size_t>(1, kTilesPerFit / tiles);
  const bool patches_fit = patches_.fit(patches);
  const bool chunks_fit = chunks_.fit(chunks) && rows_.fit(chunks) && maps_.fit(chunks) &&
                          (overlay_ == nullptr || overlay_->fit(chunks));
  const std::size_t merged = overlay_ == nullptr ? 0 : overlay_->bytes();
  memory_.set(MemoryUse::chunk_cache, chunks_.bytes() + rows_.bytes() + maps_.bytes() + merged);
  memory_.set(MemoryUse::patch_cache, patches_.bytes());
  return patches_fit && chunks_fit;
}

void BaseChunks::count_columns() {
  if (columns_ != nullptr) memory_.set(MemoryUse::column_cache, columns_->status().memory_bytes);
}

void BaseChunks::keep_on_disk() {
  if (columns_ == nullptr) return;
  patches_.keep_all();
  columns_->flush();
}

BaseChunks::Status BaseChunks::status() {
  const GenerationPool::Status pool = pool_.status();
  return {pool.jobs,        pool.clients,  chunks_.bytes(),
          patches_.bytes(), maps_.bytes(), columns_ ? std::optional{columns_->status()} : std::nullopt};
}

}  // namespace talus::server
