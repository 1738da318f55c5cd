// Parses the paths of players' HTTP requests. Pure functions. Source: PROTOCOL.md, "HTTP".
#pragma once

#include <array>
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

/// Maximum edge of an aligned square of columns in one answer.
inline constexpr std::int32_t kMaxSquareEdge = 4;

/// Keys of the query of /v1/heights.
inline constexpr std::array<std::string_view, 9> kHeightsKeys{"columns", "x",     "z",      "w",     "h",
                                                              "step",    "looks", "fields", "format"};
/// Maximum distance between the columns of a grid, in base columns.
inline constexpr std::int64_t kMaxHeightsStep = std::int64_t{1} << 20;

/// The store and the revision of edited land.
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
  std::optional<Edition> edition{};  // empty: as generated
};
struct ColumnsRoute {
  std::string_view fingerprint;
  std::string_view codec;
  ChunkKey corner;  // the column with the least x and z; y is 0
  std::int32_t edge = 1;
  bool square = false;  // the answer has the format of a square, even for a single column
  std::optional<Edition> edition{};
};
/// The edited columns of a region.
struct EditsRoute {
  std::string_view fingerprint;
  std::string_view store;
  ChunkKey region;  // the region's column with the least x and z; y is 0
};
struct HeightsRoute {
  std::vector<terrain::BaseColumn> columns;
  std::int64_t width = 0;  // a grid's; its columns go row by row southward; 0: a list
  bool looks = false;
  std::vector<std::string> fields;  // one whose comma was encoded may be several names
  bool npy = false;
};
struct MapRoute {
  std::string_view fingerprint;
  map::Tile tile;
};
/// A file of a published world.
struct FileRoute {
  std::string_view fingerprint;
  std::string name;  // in the world's spec; empty: the spec itself
};
using Route = std::variant<WorldRoute, StreamRoute, ChunkRoute, ColumnsRoute, EditsRoute, HeightsRoute,
                           MapRoute, FileRoute>;

struct RouteError {
  int status = 404;
  std::string text;  // one line: the fault and the remedy
};

/// Returns true for all paths of players, valid or not.
[[nodiscard]] bool is_for_players(std::string_view path);

/// Returns the last part of the path with this revision instead, for a redirect.
[[nodiscard]] std::string last_part_of(const ChunkRoute& route, std::uint64_t revision);
[[nodiscard]] std::string last_part_of(const ColumnsRoute& route, std::uint64_t revision);

/// Every chunk has a single path, so that caches store it once: numbers as std::to_chars writes them, and no
/// query, not even an empty one. `query`: nullopt if the target has no '?'. At most `max_columns` columns of
/// heights. The result has views into `path`.
[[nodiscard]] tl::expected<Route, RouteError> find_route(std::string_view path,
                                                         std::optional<std::string_view> query,
                                                         std::size_t max_columns);

}  // namespace talus::server::web
