// A column of chunks as generated, in bytes: FORMAT.md has each of them. Pure.
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

/// Which rows of a column are mixed, and those of its mixed chunks that are there, by rising y.
struct ColumnRecord {
  struct Entry {
    std::int32_t y = 0;
    EncodedChunkPtr chunk;
  };
  MixedRows rows;
  std::vector<Entry> chunks;
};

/// By rising key, columns of a level that lie together stand together. `column` is a column_of().
[[nodiscard]] std::string column_key(ChunkKey column);

/// Replaces what `out` holds. Chunks are of revision kBaseRevision and of rows.
void encode(ChunkKey column, const ColumnRecord& record, std::vector<std::byte>& out);

/// Nothing where the value is not one that encode() made for this column.
[[nodiscard]] std::optional<ColumnRecord> decode_column(ChunkKey column, std::span<const std::byte> value);

}  // namespace talus::server
