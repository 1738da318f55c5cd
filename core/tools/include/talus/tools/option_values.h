// Parses values of options: "X,Z" pairs, sizes, and the regions that they describe.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include <talus/terrain/field.h>
#include <talus/tools/failure.h>
#include <talus/voxel/coords.h>

namespace talus::tools {

struct IntegerPair {
  std::int64_t first = 0;
  std::int64_t second = 0;
  bool operator==(const IntegerPair&) const = default;
};

/// "X,Z": two integers, possibly negative. `option` names the source in errors.
[[nodiscard]] Expected<IntegerPair> parse_pair(std::string_view option, std::string_view text);

/// "W,H": two integers from 1 to `longest`.
[[nodiscard]] Expected<IntegerPair> parse_size(std::string_view option, std::string_view text,
                                               std::int64_t longest);

[[nodiscard]] Expected<Lod> parse_lod(std::int64_t level);

/// Columns of `lod`, the first of which contains base column `base`. Fails if a column lies outside the
/// world; `option` names the source.
[[nodiscard]] Expected<terrain::Region> region_from_origin(std::string_view option, IntegerPair base,
                                                           IntegerPair size, Lod lod);

/// Columns of `lod`; the column that contains base column `base` is column (size / 2) of the region.
[[nodiscard]] Expected<terrain::Region> region_around(std::string_view option, IntegerPair base,
                                                      IntegerPair size, Lod lod);

}  // namespace talus::tools
