// The input is the target of an HTTP request of a player. Whatever it is, it has a route or an error of one
// line, and a chunk's path is the only one of its chunk.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string_view>
#include <variant>

#include <fmt/format.h>

#include "web/routes.h"

using namespace talus::server::web;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t kMaxColumns = 100;
  const std::string_view target{reinterpret_cast<const char*>(data), size};
  const std::size_t mark = target.find('?');
  const std::string_view path = target.substr(0, mark);
  const auto query = mark == std::string_view::npos ? std::nullopt : std::optional{target.substr(mark + 1)};
  const auto route = find_route(path, query, kMaxColumns);
  if (!route) {
    if (route.error().status < 400 || route.error().text.empty()) std::abort();
    return 0;
  }
  if (const auto* const heights = std::get_if<HeightsRoute>(&*route)) {
    if (heights->columns.size() > kMaxColumns + 2) std::abort();
  }
  if (const auto* const chunk = std::get_if<ChunkRoute>(&*route)) {
    if (query) std::abort();  // it would be a second path
    const auto& [coord, lod] = chunk->key;
    const auto& edition = chunk->edition;
    const std::string again =
        fmt::format("/v1/{}{}{}/{}/{}/{}/{}/{}{}", chunk->fingerprint, edition ? "/" : "",
                    edition ? edition->store : std::string_view{}, chunk->codec, lod.value(), coord.x,
                    coord.y, coord.z, edition ? fmt::format("@{}", edition->revision) : "");
    if (is_for_players(path) && again != path) std::abort();
  }
  if (const auto* const edits = std::get_if<EditsRoute>(&*route)) {
    const auto& [coord, lod] = edits->region;
    if (coord.x % 32 != 0 || coord.z % 32 != 0) std::abort();
    const std::string again = fmt::format("/v1/{}/{}/edits/{}/{}/{}", edits->fingerprint, edits->store,
                                          lod.value(), coord.x / 32, coord.z / 32);
    if (is_for_players(path) && again != path) std::abort();
  }
  if (const auto* const map = std::get_if<MapRoute>(&*route)) {
    const std::string again =
        fmt::format("/v1/{}/map/{}/{}/{}.png", map->fingerprint, map->tile.zoom, map->tile.x, map->tile.z);
    if (is_for_players(path) && again != path) std::abort();
  }
  return 0;
}
