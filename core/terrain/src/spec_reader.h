// world.toml -> WorldSpec, checked key by key. Private to the room.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include <talus/terrain/world.h>

namespace talus::terrain {

/// Where the keys stand that World::parse judges together with others.
struct SpecLines {
  int wavelength = 0;
  int amplitude = 0;
  int strata_wavelength = 0;
  int sea_level = 0;
  int warp = 0;
  int height_map = 0;
  int stratified = 0;
  std::vector<int> eroded_thickness;                    // one for each [[eroded]]
  std::map<std::string, int, std::less<>> caves;        // by key; that of the table where a key is left out
  std::map<std::string, int, std::less<>> underground;  // of folds, faults and veins, by "folds.strike"
};

struct ReadSpec {
  WorldSpec spec;
  SpecLines lines;
};

/// An error on one line, whatever stood in the file: a key or a name may hold any character.
[[nodiscard]] SpecError error_of(const std::string& message);

/// Every key present, of the right type and in its own range, no unknown keys, no name twice. Bounds that
/// span several keys are World::parse's.
[[nodiscard]] tl::expected<ReadSpec, SpecError> read_spec(std::string_view toml, std::string_view file);

}  // namespace talus::terrain
