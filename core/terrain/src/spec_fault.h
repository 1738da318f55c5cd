// What is wrong with a spec beyond a single key. Private to the room.
#pragma once

#include <optional>
#include <sstream>
#include <string>

namespace talus::terrain {

struct SpecFault {
  int line = 0;
  std::string key;
  std::string what;
};

[[nodiscard]] std::string text_of(const auto&... parts) {
  std::ostringstream text;
  (text << ... << parts);
  return text.str();
}

/// A length of the spec that must come to `least` to `most` voxels.
[[nodiscard]] inline std::optional<SpecFault> out_of_range(int line, const std::string& table,
                                                           const std::string& key, double units,
                                                           int resolution, double least, double most) {
  const double voxels = units * resolution;
  if (voxels >= least && voxels <= most) return std::nullopt;
  return SpecFault{line, table + "." + key,
                   text_of(key, " * resolution is ", voxels, " voxels; ", least, " to ", most)};
}

}  // namespace talus::terrain
