#include "session/heights_check.h"

#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <utility>

#include <fmt/format.h>

#include <talus/protocol/limits.h>

namespace talus::server {
namespace {

using wire::ErrorCode;

/// Whether the column's chunks are in the world.
bool in_world(const terrain::BaseColumn& column) {
  const std::int64_t limit = chunk_limit(Lod{}) * kChunkSize;
  return -limit <= column.x && column.x < limit && -limit <= column.z && column.z < limit;
}

std::size_t count_tiles(const std::vector<terrain::BaseColumn>& columns) {
  std::set<std::pair<std::int64_t, std::int64_t>> tiles;
  for (const terrain::BaseColumn& column : columns) {
    tiles.emplace(floor_div(column.x, kChunkSize), floor_div(column.z, kChunkSize));
  }
  return tiles.size();
}

}  // namespace

tl::expected<HeightsQuery, Rejection> check_heights(const wire::GetHeights& get, const SessionLimits& limits,
                                                    std::size_t world_fields) {
  const std::size_t count = get.columns() == nullptr ? 0 : get.columns()->size();
  if (count > limits.heights_per_request) {
    return rejected(ErrorCode::too_large,
                    fmt::format("GetHeights has {} columns, over the limit heights_per_request {}", count,
                                limits.heights_per_request));
  }
  std::vector<terrain::BaseColumn> columns;
  columns.reserve(count);
  for (flatbuffers::uoffset_t i = 0; i < count; ++i) {
    const terrain::BaseColumn column{get.columns()->Get(i)->x(), get.columns()->Get(i)->z()};
    if (!in_world(column)) {
      return rejected(ErrorCode::out_of_range,
                      fmt::format("column ({}, {}) is outside the world; x and z are -2^36 to 2^36 - 1",
                                  column.x, column.z));
    }
    columns.push_back(column);
  }
  if (const std::size_t tiles = count_tiles(columns); tiles > limits.height_tiles_per_request) {
    return rejected(
        ErrorCode::too_large,
        fmt::format("GetHeights reaches into {} tiles of 32 x 32 columns; in this world at most {}", tiles,
                    limits.height_tiles_per_request));
  }
  HeightsQuery query{std::move(columns), get.looks(), {}};
  if (get.fields() == nullptr) return query;
  if (get.fields()->size() > protocol::kMaxFieldsPerRequest) {
    return rejected(ErrorCode::too_large, fmt::format("GetHeights asks for {} fields; at most {}",
                                                      get.fields()->size(), protocol::kMaxFieldsPerRequest));
  }
  query.fields.assign(get.fields()->begin(), get.fields()->end());
  for (const std::uint8_t field : query.fields) {
    if (field >= world_fields) {
      return rejected(ErrorCode::out_of_range,
                      fmt::format("GetHeights asks for field {}; Welcome has {}", field, world_fields));
    }
  }
  return query;
}

}  // namespace talus::server
