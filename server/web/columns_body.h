// Columns of chunks in one body, and which were edited. Pure. Source: PROTOCOL.md, "Columns of chunks" and
// "Edited land".
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <talus/voxel/coords.h>

#include "chunks/edited_land.h"
#include "chunks/encoded_chunk.h"

namespace talus::server::web {

inline constexpr const char* kBytes = "application/octet-stream";

/// Of one body. A column beyond has to be asked for chunk by chunk.
inline constexpr std::size_t kMaxBodyBytes = std::size_t{4} << 20;

/// As many chunks, one over the other, that are the same.
struct ChunkRun {
  std::int32_t first_y = 0;
  std::uint32_t count = 0;
  EncodedChunkPtr chunk;
};

/// One more chunk upward: a run of its own where it differs from the chunk below, so that a column's bytes
/// are the same however much of it was known when it was asked for.
void add_chunk(std::vector<ChunkRun>& runs, std::int32_t y, EncodedChunkPtr chunk);

/// Appends a column; its runs go upward and leave out no chunk of the world.
void append_column(std::string& body, const std::vector<ChunkRun>& runs);

/// Before the columns of a square, which go row by row southward, each after its length in bytes.
void append_square_head(std::string& body, std::int32_t edge);
void append_length(std::string& body, std::uint32_t bytes);

/// The edited columns of a region.
void append_edited_columns(std::string& body, const std::vector<EditedColumn>& columns);

}  // namespace talus::server::web
