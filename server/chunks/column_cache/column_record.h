// Serializes generated columns of chunks. FORMAT.md defines the bytes. Pure functions.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <talus/voxel/coords.h>

#include "chunks/chunk_source.h"
#include "chunks/encoded_chunk.h"

namespace talus::server {

/// The range of mixed rows of a column, and the mixed chunks known, by ascending y.
struct ColumnRecord {
  struct Entry {
    std::int32_t y = 0;
    EncodedChunkPtr chunk;
  };
  MixedRows rows;
  std::vector<Entry> chunks;
};

/// In key order, columns of a level that are near each other are adjacent. `column` must be a column_of().
[[nodiscard]] std::string column_key(ChunkKey column);

/// Replaces the content of `out`. All chunks have revision kBaseRevision and lie in `rows`.
void encode(ChunkKey column, const ColumnRecord& record, std::vector<std::byte>& out);

/// Returns nullopt if the value was not made by encode() for this column.
[[nodiscard]] std::optional<ColumnRecord> decode_column(ChunkKey column, std::span<const std::byte> value);

}  // namespace talus::server
