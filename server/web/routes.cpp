#include "web/routes.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <span>

#include <fmt/format.h>

#include "chunks/edited_land.h"
#include "net/http/query.h"

namespace talus::server::web {
namespace {

constexpr std::string_view kRoot = "/v1/";
constexpr std::size_t kMaxSegments = 8;

tl::unexpected<RouteError> wrong(int status, std::string text) {
  return tl::make_unexpected(RouteError{status, std::move(text)});
}

/// Parses a number as std::to_chars writes it; rejects 007, +7 and -0.
std::optional<std::int64_t> number_of(std::string_view text) {
  const std::string_view digits = text.substr(text.starts_with('-') ? 1 : 0);
  if (digits.starts_with('0') && text.size() > 1) return std::nullopt;
  // Each chunk's path has four short numbers; from_chars takes three times as long for them.
  constexpr std::size_t kShort = 18;
  if (!digits.empty() && digits.size() <= kShort) {
    std::int64_t number = 0;
    for (const char digit : digits) {
      if (digit < '0' || digit > '9') return std::nullopt;
      number = 10 * number + (digit - '0');
    }
    return digits.size() < text.size() ? -number : number;
  }
  std::int64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return number;
}

/// Parses "4x4"; nullopt unless it is a square of edge 1, 2 or 4.
std::optional<std::int32_t> edge_of(std::string_view text) {
  for (std::int32_t edge = 1; edge <= kMaxSquareEdge; edge *= 2) {
    if (text == fmt::format("{}x{}", edge, edge)) return edge;
  }
  return std::nullopt;
}

/// Parses a path of generated land.
tl::expected<Route, RouteError> base_chunks(std::span<const std::string_view> parts) {
  constexpr std::string_view kForms =
      "/v1/{fingerprint}/{codec}/{lod}/{x}/{y}/{z} is a chunk, .../{lod}/{x}/{z} a column of chunks, "
      ".../{lod}/{x}/{z}/4x4 a square of them, "
      "/v1/{fingerprint}/{store_id}/{codec}/{lod}/{x}/{y}/{z}@{revision} a "
      "chunk with its edits, /v1/{fingerprint}/map/{zoom}/{x}/{z}.png a tile of the map";
  if (parts.size() != 5 && parts.size() != 6) return wrong(404, std::string{kForms});
  const bool square = parts.size() == 6 && parts[5].find('x') != std::string_view::npos;
  std::array<std::int64_t, 4> numbers{};
  std::size_t count = 0;
  for (std::size_t i = 2; i < parts.size() - (square ? 1 : 0); ++i) {
    const auto number = number_of(parts[i]);
    if (!number) {
      return wrong(
          404, fmt::format("'{}' is not an integer such as 0, 7 or -12; {}", parts[i].substr(0, 40), kForms));
    }
    numbers[count++] = *number;
  }
  const auto lod = Lod::checked(numbers[0]);
  if (!lod) return wrong(404, lod.error().message);
  const bool column = count == 3;
  const auto key = checked_chunk(numbers[1], column ? 0 : numbers[2], numbers[count - 1], *lod);
  if (!key) return wrong(404, key.error().message);
  if (!column) return ChunkRoute{parts[0], parts[1], *key};
  ColumnsRoute route{parts[0], parts[1], *key, 1, square};
  if (!square) return route;
  const auto edge = edge_of(parts[5]);
  if (!edge) return wrong(404, fmt::format("'{}' is not one of 1x1, 2x2, 4x4", parts[5].substr(0, 40)));
  if (floor_mod(key->coord.x, *edge) != 0 || floor_mod(key->coord.z, *edge) != 0) {
    return wrong(404, fmt::format("squares of {} begin at multiples of {}", parts[5], *edge));
  }
  route.edge = *edge;
  return route;
}

/// A path whose last part ends in "@{revision}" has the store's id after the fingerprint. Without these two
/// it is a path of generated land.
tl::expected<Route, RouteError> chunks(std::span<const std::string_view> parts) {
  const std::size_t mark = parts.back().find('@');
  if (mark == std::string_view::npos && parts.size() == 7) {
    return wrong(
        404,
        "@{revision} is missing; paths with a store id end in it, as in "
        "/v1/{fingerprint}/{store_id}/{codec}/{lod}/{x}/{y}/{z}@0, and the answer redirects to the newest");
  }
  if (mark == std::string_view::npos) return base_chunks(parts);
  const std::string_view text = parts.back().substr(mark + 1);
  const auto revision = number_of(text);
  if (!revision || *revision < 0 || parts.size() < 2) {
    return wrong(404, fmt::format("'{}' is not a revision such as 0 or 12; "
                                  "/v1/{{fingerprint}}/{{store_id}}/{{codec}}/{{lod}}/{{x}}/{{y}}/"
                                  "{{z}}@{{revision}} is a chunk with its edits",
                                  text.substr(0, 40)));
  }
  std::array<std::string_view, kMaxSegments> rest;
  std::size_t count = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (i != 1) rest[count++] = parts[i];
  }
  rest[count - 1] = rest[count - 1].substr(0, mark);
  auto route = base_chunks(std::span{rest}.first(count));
  if (!route) return route;
  const Edition edition{parts[1], static_cast<std::uint64_t>(*revision)};
  if (auto* const chunk = std::get_if<ChunkRoute>(&*route)) {
    chunk->edition = edition;
  } else {
    std::get<ColumnsRoute>(*route).edition = edition;
  }
  return route;
}

tl::expected<Route, RouteError> edited_region(std::span<const std::string_view> parts) {
  constexpr std::string_view kForm =
      "/v1/{fingerprint}/{store_id}/edits/{lod}/{x}/{z} lists the edited columns of chunk columns 32 x to 32 "
      "x + 31, 32 z to 32 z + 31";
  constexpr std::int64_t kFar = std::int64_t{1} << 32;
  if (parts.size() != 6) return wrong(404, std::string{kForm});
  std::array<std::int64_t, 3> numbers{};
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const auto number = number_of(parts[i + 3]);
    if (!number) {
      return wrong(404, fmt::format("'{}' is not an integer such as 0, 7 or -12; {}",
                                    parts[i + 3].substr(0, 40), kForm));
    }
    numbers[i] = std::clamp(*number, -kFar, kFar);
  }
  const auto lod = Lod::checked(numbers[0]);
  if (!lod) return wrong(404, lod.error().message);
  const auto key = checked_chunk(numbers[1] * kRegionColumns, 0, numbers[2] * kRegionColumns, *lod);
  if (!key) return wrong(404, key.error().message);
  return EditsRoute{parts[0], parts[1], *key};
}

tl::expected<Route, RouteError> map_tile(std::span<const std::string_view> parts) {
  constexpr std::string_view kForm = "/v1/{fingerprint}/map/{zoom}/{x}/{z}.png is a tile of the map";
  constexpr std::string_view kEnding = ".png";
  if (parts.size() != 5 || !parts[4].ends_with(kEnding)) return wrong(404, std::string{kForm});
  const std::array texts{parts[2], parts[3], parts[4].substr(0, parts[4].size() - kEnding.size())};
  std::vector<std::int64_t> numbers;
  for (const std::string_view text : texts) {
    const auto number = number_of(text);
    if (!number)
      return wrong(404,
                   fmt::format("'{}' is not an integer such as 0, 7 or -12; {}", text.substr(0, 40), kForm));
    numbers.push_back(*number);
  }
  const auto tile = map::checked_tile(numbers[0], numbers[1], numbers[2]);
  if (!tile) return wrong(404, tile.error());
  return MapRoute{parts[0], *tile};
}

constexpr std::string_view kHeightForms =
    "/v1/heights?columns=X,Z;X,Z or ?x=X&z=Z&w=COLUMNS&h=ROWS[&step=S], with &looks=1, &fields=NAME,NAME and "
    "&format=npy if wanted";

tl::expected<void, RouteError> list_columns(std::string_view text, std::size_t max_columns,
                                            HeightsRoute& route) {
  for (const std::string_view each : http::split(text, ';', max_columns + 2)) {
    const auto pair = http::split(each, ',', 3);
    const auto x = number_of(pair[0]);
    const auto z = pair.size() == 2 ? number_of(pair[1]) : std::nullopt;
    if (!x || !z) return wrong(400, fmt::format("columns: '{}' is not X,Z", each.substr(0, 40)));
    route.columns.push_back({*x, *z});
  }
  return {};
}

tl::expected<void, RouteError> grid_columns(http::Query& query, std::size_t max_columns,
                                            HeightsRoute& route) {
  // Beyond any world; check_heights() enforces the world's bounds.
  constexpr std::int64_t kFar = std::int64_t{1} << 40;
  const auto read = [&](std::string_view key, std::optional<std::int64_t> otherwise, std::int64_t min,
                        std::int64_t max) -> tl::expected<std::int64_t, RouteError> {
    const auto pair = query.take(key);
    const auto number = pair ? number_of(pair->value) : otherwise;
    if (number && *number >= min && *number <= max) return *number;
    return wrong(400, fmt::format("{}: {} is needed; {}", key,
                                  fmt::format("an integer from {} to {}", min, max), kHeightForms));
  };
  const auto columns = static_cast<std::int64_t>(max_columns);
  const auto x = read("x", std::nullopt, -kFar, kFar);
  if (!x) return tl::make_unexpected(x.error());
  const auto z = read("z", std::nullopt, -kFar, kFar);
  if (!z) return tl::make_unexpected(z.error());
  const auto width = read("w", std::nullopt, 1, columns);
  if (!width) return tl::make_unexpected(width.error());
  const auto depth = read("h", std::nullopt, 1, columns / *width);
  if (!depth) return tl::make_unexpected(depth.error());
  const auto step = read("step", 1, 1, kMaxHeightsStep);
  if (!step) return tl::make_unexpected(step.error());
  route.width = *width;
  for (std::int64_t row = 0; row < *depth; ++row) {
    for (std::int64_t column = 0; column < *width; ++column) {
      route.columns.push_back({*x + column * *step, *z + row * *step});
    }
  }
  return {};
}

/// A plain comma separates names. A percent-encoded comma may be part of a name.
std::vector<std::string> field_names(std::string_view raw) {
  std::vector<std::string> names;
  for (const std::string_view each : http::split(raw, ',', 64))
    names.push_back(http::form_decoded(each).value_or(""));
  return names;
}

tl::expected<Route, RouteError> heights(std::string_view text, std::size_t max_columns) {
  auto query = http::Query::parse(text);
  if (!query) return wrong(400, query.error());
  for (const http::Query::Pair& pair : query->left()) {
    if (std::find(kHeightsKeys.begin(), kHeightsKeys.end(), pair.key) != kHeightsKeys.end()) continue;
    return wrong(400,
                 fmt::format("'{}' is not a key of this query; {}", pair.key.substr(0, 40), kHeightForms));
  }
  HeightsRoute route;
  const auto list = query->take("columns");
  if (const auto done =
          list ? list_columns(list->value, max_columns, route) : grid_columns(*query, max_columns, route);
      !done) {
    return tl::make_unexpected(done.error());
  }
  if (const auto looks = query->take("looks")) {
    if (looks->value != "0" && looks->value != "1") return wrong(400, "looks: give 0 or 1");
    route.looks = looks->value == "1";
  }
  if (const auto fields = query->take("fields")) route.fields = field_names(fields->raw);
  if (const auto format = query->take("format")) {
    if (format->value != "json" && format->value != "npy") return wrong(400, "format: give json or npy");
    route.npy = format->value == "npy";
  }
  if (route.npy && (route.looks || !route.fields.empty())) {
    return wrong(400, "format: .npy holds heights alone; ask for looks and fields in JSON");
  }
  if (!query->left().empty()) {
    return wrong(400, fmt::format("'{}' is given twice, or with columns; {}", query->left().front().key,
                                  kHeightForms));
  }
  return route;
}

/// `name`: the rest of the path after "files/".
tl::expected<Route, RouteError> world_file(std::string_view fingerprint, std::string_view name) {
  auto decoded = http::percent_decoded(name);
  if (decoded && !decoded->empty()) return FileRoute{fingerprint, *std::move(decoded)};
  return wrong(404, "/v1/{fingerprint}/files/{name} is a file that the world's file names, percent-encoded");
}

}  // namespace

std::string last_part_of(const ChunkRoute& route, std::uint64_t revision) {
  return fmt::format("{}@{}", route.key.coord.z, revision);
}

std::string last_part_of(const ColumnsRoute& route, std::uint64_t revision) {
  return route.square ? fmt::format("{0}x{0}@{1}", route.edge, revision)
                      : fmt::format("{}@{}", route.corner.coord.z, revision);
}

bool is_for_players(std::string_view path) {
  return path.starts_with(kRoot);
}

tl::expected<Route, RouteError> find_route(std::string_view path, std::optional<std::string_view> query,
                                           std::size_t max_columns) {
  std::array<std::string_view, kMaxSegments> segments;
  std::string_view rest = path.substr(std::min(kRoot.size(), path.size()));
  std::size_t count = 0;
  for (std::size_t slash = 0; slash != std::string_view::npos && count < segments.size(); ++count) {
    slash = count + 1 < segments.size() ? rest.find('/') : std::string_view::npos;
    segments[count] = rest.substr(0, slash);
    rest.remove_prefix(std::min(rest.size(), segments[count].size() + 1));
  }
  const std::span<const std::string_view> parts = std::span{segments}.first(count);
  if (parts.size() == 1 && parts[0] == "heights") return heights(query.value_or(""), max_columns);
  if (query && !query->empty()) {
    return wrong(400, "this path takes no query: caches would hold an answer many times");
  }
  if (parts.size() == 1 && parts[0] == "world") return WorldRoute{};
  if (parts.size() == 1 && parts[0] == "stream") return StreamRoute{};
  if (query) return wrong(404, "this path has no '?' at its end: caches would hold an answer twice");
  if (parts.size() > 1 && parts[1] == "map") return map_tile(parts);
  if (parts.size() == 2 && parts[1] == "world.toml") return FileRoute{parts[0], {}};
  if (parts.size() > 2 && parts[1] == "files") {
    return world_file(parts[0],
                      path.substr(kRoot.size() + parts[0].size() + std::string_view{"/files/"}.size()));
  }
  if (parts.size() > 2 && parts[2] == "edits") return edited_region(parts);
  return chunks(parts);
}

}  // namespace talus::server::web
