// What is asked of the ground without its voxels, and the answer: heights of base columns, or a map of them.
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

struct HeightsFound;

/// Writes the body of an answer. It is called, and may be let go, by a generator's thread after whoever asked
/// has gone: it owns what it reads.
using HeightsBody = std::function<std::string(const HeightsFound&)>;

struct HeightsQuery {
  std::vector<terrain::BaseColumn> columns{};
  bool looks = false;
  std::vector<std::uint8_t> fields{};  // places in terrain::place_names()
  std::optional<map::Tile> tile{};     // is drawn; then there are no columns
  HeightsBody body{};                  // writes what is found; null: nobody does
};

/// A tile of the map.
struct Picture {
  std::string png;  // the file
};
using PicturePtr = std::shared_ptr<const Picture>;

/// In the order of the columns asked for. Where the query has a body, nothing but that comes.
struct HeightsFound {
  std::vector<std::int32_t> heights_fx{};  // of the ground, subvoxels
  std::vector<std::uint8_t> looks{};       // numbers of World::look_names(); none where not asked for
  std::vector<float> values{};             // of each column those of all fields, in the order of the request
  PicturePtr picture{};                    // of the tile asked for
  std::string body{};
};

}  // namespace talus::server
