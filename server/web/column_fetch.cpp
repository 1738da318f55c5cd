#include "web/column_fetch.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "web/columns_body.h"

namespace talus::server::web {
namespace {

std::int64_t first_row(Lod lod) {
  return -chunk_limit(lod);
}

}  // namespace

// A column's mixed rows are known once any of its chunks was generated.
asio::awaitable<Answer> ColumnFetch::append(ChunkKey column, std::string& body, std::size_t held) {
  const SessionContext& shared = exchange_.shared();
  constexpr std::size_t kBatch = 64;
  const Lod lod = column.lod;
  const auto known = [&](const MixedRows& rows) {
    return rows.first != std::numeric_limits<std::int32_t>::min();
  };
  MixedRows rows = exchange_.chunks().column(column, version_);
  if (!known(rows)) {
    column.coord.y = static_cast<std::int32_t>(floor_div(shared.world.spawn.y >> lod.value(), kChunkSize));
    const std::vector<ChunkKey> one(1, column);
    if (const auto made = co_await fetch_.get(one, version_, exchange_.deadline()); !made)
      co_return fetch_failed(made.error(), shared.memory);
    rows = exchange_.chunks().column(column, version_);
  }
  // If unknown, any row between the world's lowest and highest may be mixed.
  if (!known(rows)) {
    const HeightRange& heights = shared.world.heights;
    rows.first = static_cast<std::int32_t>(floor_div(heights.low >> lod.value(), kChunkSize)) - 1;
    rows.last = static_cast<std::int32_t>(floor_div(heights.high >> lod.value(), kChunkSize)) + 1;
    if (const ChunkRange edited = edits_ == nullptr ? ChunkRange{} : edits_->edited_rows(column);
        edited.size() > 0) {
      rows.first = std::min(rows.first, static_cast<std::int32_t>(edited.first));
      rows.last = std::max(rows.last, static_cast<std::int32_t>(edited.last));
    }
  }
  std::vector<ChunkRun> runs;
  std::size_t fetched = 0;
  const std::int64_t top = chunk_limit(lod) - 1;
  for (std::int64_t y = std::int64_t{rows.first} - 1; y <= std::int64_t{rows.last} + 1;) {
    std::vector<ChunkKey> keys;
    for (; keys.size() < kBatch && y <= std::int64_t{rows.last} + 1; ++y) {
      column.coord.y = static_cast<std::int32_t>(y);
      keys.push_back(column);
    }
    auto made = co_await fetch_.get(keys, version_, exchange_.deadline());
    if (!made) co_return fetch_failed(made.error(), shared.memory);
    for (std::size_t i = 0; i < keys.size(); ++i) {
      revision_ = std::max(revision_, (*made)[i]->revision());
      add_chunk(runs, keys[i].coord.y, (*made)[i]);
    }
    chunks_ += keys.size() - (fetched == 0 ? 2 : 0);  // the chunks below and above were known
    fetched += keys.size();
    std::size_t bytes = body.size();
    for (const ChunkRun& run : runs) bytes += run.chunk->payload().size();
    exchange_.hold(held + bytes);
    if (bytes > kMaxBodyBytes || runs.size() > UINT16_MAX) co_return body_too_large();
  }
  // The first run extends to the bottom of the world, the last to its top.
  runs.front().count += static_cast<std::uint32_t>(runs.front().first_y - first_row(lod));
  runs.front().first_y = static_cast<std::int32_t>(first_row(lod));
  runs.back().count = static_cast<std::uint32_t>(top - runs.back().first_y + 1);
  append_column(body, runs);
  co_return std::nullopt;
}

}  // namespace talus::server::web
