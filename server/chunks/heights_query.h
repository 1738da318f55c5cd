// Queries about the ground without its voxels, and their answers: heights of base columns, or a map tile.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <talus/map/tile.h>
#include <talus/terrain/heights.h>

namespace talus::server {

struct HeightsResult;

/// Writes the body of an answer. A generator's thread may call or destroy it after the client has gone, so it
/// must own everything that it reads.
using HeightsBody = std::function<std::string(const HeightsResult&)>;

struct HeightsQuery {
  std::vector<terrain::BaseColumn> columns{};
  bool looks = false;
  std::vector<std::uint8_t> fields{};  // places in terrain::place_names()
  std::optional<map::Tile> tile{};     // the tile to draw; `columns` is empty then
  HeightsBody body{};                  // writes the answer's body; may be null
};

/// A tile of the map.
struct Picture {
  std::string png;  // the file
};
using PicturePtr = std::shared_ptr<const Picture>;

/// In the order of the queried columns. If the query has a body, only `body` is set.
struct HeightsResult {
  std::vector<std::int32_t> heights_fx{};  // the ground's, in subvoxels
  std::vector<std::uint8_t> looks{};       // numbers in World::look_names(); empty if not requested
  std::vector<float> values{};  // for each column the values of all fields, in the order of the query
  PicturePtr picture{};         // the queried tile
  std::string body{};
};

}  // namespace talus::server
