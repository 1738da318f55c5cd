#include "player/session/heights_check.h"

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

/// Returns true if the column's chunks are in the world.
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

tl::unexpected<Rejection> too_many_fields(std::size_t fields) {
  return rejected(ErrorCode::too_large, fmt::format("GetHeights asks for {} fields; at most {}", fields,
                                                    protocol::kMaxFieldsPerRequest));
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
  HeightsQuery query;
  query.columns.reserve(count);
  for (flatbuffers::uoffset_t i = 0; i < count; ++i) {
    query.columns.push_back({get.columns()->Get(i)->x(), get.columns()->Get(i)->z()});
  }
  query.looks = get.looks();
  if (get.fields() != nullptr) {
    if (get.fields()->size() > protocol::kMaxFieldsPerRequest) return too_many_fields(get.fields()->size());
    query.fields.assign(get.fields()->begin(), get.fields()->end());
  }
  if (auto checked = check_query(query, limits, world_fields); !checked) {
    return tl::make_unexpected(std::move(checked.error()));
  }
  return query;
}

tl::expected<void, Rejection> check_query(const HeightsQuery& query, const SessionLimits& limits,
                                          std::size_t world_fields) {
  for (const terrain::BaseColumn& column : query.columns) {
    if (!in_world(column)) {
      return rejected(ErrorCode::out_of_range,
                      fmt::format("column ({}, {}) is outside the world; x and z are -2^36 to 2^36 - 1",
                                  column.x, column.z));
    }
  }
  if (const std::size_t tiles = count_tiles(query.columns); tiles > limits.height_tiles_per_request) {
    return rejected(
        ErrorCode::too_large,
        fmt::format("GetHeights reaches into {} tiles of 32 x 32 columns; in this world at most {}", tiles,
                    limits.height_tiles_per_request));
  }
  if (query.fields.size() > protocol::kMaxFieldsPerRequest) return too_many_fields(query.fields.size());
  for (const std::uint8_t field : query.fields) {
    if (field >= world_fields) {
      return rejected(ErrorCode::out_of_range,
                      fmt::format("GetHeights asks for field {}; Welcome has {}", field, world_fields));
    }
  }
  return {};
}

}  // namespace talus::server
