// What a GetHeights asks of base columns, and the answer.
#pragma once

#include <cstdint>
#include <vector>

#include <talus/terrain/heights.h>

namespace talus::server {

struct HeightsQuery {
  std::vector<terrain::BaseColumn> columns{};
  bool looks = false;
  std::vector<std::uint8_t> fields{};  // places in terrain::place_names()
};

/// In the order of the columns asked for.
struct HeightsFound {
  std::vector<std::int32_t> heights_fx{};  // of the ground, subvoxels
  std::vector<std::uint8_t> looks{};       // numbers of World::look_names(); none where not asked for
  std::vector<float> values{};             // of each column those of all fields, in the order of the request
};

}  // namespace talus::server
