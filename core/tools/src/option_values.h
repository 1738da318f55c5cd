// Values of options as people type them: "X,Z" pairs, sizes, and the regions that they name.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include <talus/terrain/field.h>
#include <talus/voxel/coords.h>

#include "failure.h"

namespace talus::tools {

struct IntegerPair {
  std::int64_t first = 0;
  std::int64_t second = 0;
  bool operator==(const IntegerPair&) const = default;
};

/// "X,Z": two whole numbers, either of which may be negative. `option` names the source in errors.
[[nodiscard]] Expected<IntegerPair> parse_pair(std::string_view option, std::string_view text);

/// "W,H": two numbers from 1 to `longest`.
[[nodiscard]] Expected<IntegerPair> parse_size(std::string_view option, std::string_view text,
                                               std::int64_t longest);

/// For CLI11's check(): what is wrong with a seed; empty: nothing. CLI11 reads more than 64 bits as the
/// largest.
[[nodiscard]] std::string fault_of_seed(const std::string& text);
/// The same for a number from `least` to `most`. CLI::Range would accept nan.
[[nodiscard]] std::string fault_of_number(const std::string& text, double least, double most);

[[nodiscard]] Expected<Lod> parse_lod(std::int64_t level);

/// Columns of `lod`, the first of which holds base column `base`. Refused where a column lies outside the
/// world; `option` names the source.
[[nodiscard]] Expected<terrain::Region> region_from_origin(std::string_view option, IntegerPair base,
                                                           IntegerPair size, Lod lod);

/// Columns of `lod`; the one that holds base column `base` is column (size / 2) of the region.
[[nodiscard]] Expected<terrain::Region> region_around(std::string_view option, IntegerPair base,
                                                      IntegerPair size, Lod lod);

}  // namespace talus::tools
