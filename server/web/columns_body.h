// Serializes columns of chunks, and lists of edited columns. Pure functions. Source: PROTOCOL.md, "Columns of
// chunks" and "Edited land".
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <talus/voxel/coords.h>

#include "chunks/edited_land.h"
#include "chunks/encoded_chunk.h"

namespace talus::server::web {

inline constexpr const char* kBytes = "application/octet-stream";

/// Maximum size of a body. The chunks of a larger column have to be requested one by one.
inline constexpr std::size_t kMaxBodyBytes = std::size_t{4} << 20;

/// `count` identical chunks, one above the other.
struct ChunkRun {
  std::int32_t first_y = 0;
  std::uint32_t count = 0;
  EncodedChunkPtr chunk;
};

/// Adds the next chunk upward: a new run only if it differs from the chunk below. So a column's bytes do not
/// depend on how much of it was known when it was requested.
void add_chunk(std::vector<ChunkRun>& runs, std::int32_t y, EncodedChunkPtr chunk);

/// Appends a column. Its runs go upward and cover every chunk of the world.
void append_column(std::string& body, const std::vector<ChunkRun>& runs);

/// Begins a square of columns, which follow row by row southward, each after its length in bytes.
void append_square_head(std::string& body, std::int32_t edge);
void append_length(std::string& body, std::uint32_t bytes);

/// Appends the edited columns of a region.
void append_edited_columns(std::string& body, const std::vector<EditedColumn>& columns);

}  // namespace talus::server::web
