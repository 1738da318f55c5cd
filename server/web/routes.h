// What a player's HTTP request asks for. Pure. Source: PROTOCOL.md, "HTTP".
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <tl/expected.hpp>

#include <talus/map/tile.h>
#include <talus/terrain/heights.h>
#include <talus/voxel/coords.h>

namespace talus::server::web {

/// Answers of several columns of chunks: so many a side, aligned.
inline constexpr std::int32_t kMaxSquareEdge = 4;

/// Of land with its edits: whose edits, and up to which.
struct Edition {
  std::string_view store;
  std::uint64_t revision = 0;
};

struct WorldRoute {};
struct StreamRoute {};
struct ChunkRoute {
  std::string_view fingerprint;
  std::string_view codec;
  ChunkKey key;
  std::optional<Edition> edition{};  // none: as generated
};
struct ColumnsRoute {
  std::string_view fingerprint;
  std::string_view codec;
  ChunkKey corner;  // the column of least x and z; y is 0
  std::int32_t edge = 1;
  bool square = false;  // columns came as a square, also one of a single column
  std::optional<Edition> edition{};
};
/// Which columns of a region were edited.
struct EditsRoute {
  std::string_view fingerprint;
  std::string_view store;
  ChunkKey region;  // the region's column of least x and z; y is 0
};
struct HeightsRoute {
  std::vector<terrain::BaseColumn> columns;
  std::int64_t width = 0;  // of a grid, whose columns go row by row southward; 0: a list
  bool looks = false;
  std::vector<std::string_view> fields;
  bool npy = false;
};
struct MapRoute {
  std::string_view fingerprint;
  map::Tile tile;
};
using Route =
    std::variant<WorldRoute, StreamRoute, ChunkRoute, ColumnsRoute, EditsRoute, HeightsRoute, MapRoute>;

struct RouteError {
  int status = 404;
  std::string text;  // one line: what is wrong and what would be right
};

/// Whether the path is one of players, whatever it asks for.
[[nodiscard]] bool is_for_players(std::string_view path);

/// The last part of the path of this revision of the same: what a redirection names.
[[nodiscard]] std::string last_part_of(const ChunkRoute& route, std::uint64_t revision);
[[nodiscard]] std::string last_part_of(const ColumnsRoute& route, std::uint64_t revision);

/// Every chunk has one path, so that caches hold it once: numbers as std::to_chars writes them, and no query.
/// At most `max_columns` columns of heights. Views into `path` and `query`.
[[nodiscard]] tl::expected<Route, RouteError> find_route(std::string_view path, std::string_view query,
                                                         std::size_t max_columns);

}  // namespace talus::server::web
