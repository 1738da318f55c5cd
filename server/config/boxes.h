// Lists of boxes of base voxels, in which edits are allowed or forbidden.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include <talus/voxel/coords.h>

namespace talus::server {

/// Both corners are inclusive; `first` is the lowest.
struct Box {
  VoxelPos first;
  VoxelPos last;

  /// Box of all rows of columns (first_x, first_z) to (last_x, last_z).
  [[nodiscard]] static Box of_columns(std::int64_t first_x, std::int64_t first_z, std::int64_t last_x,
                                      std::int64_t last_z);

  [[nodiscard]] bool holds(const Box& other) const;
  [[nodiscard]] bool meets(const Box& other) const;
  bool operator==(const Box&) const = default;
};

/// Inverse of Boxes::parse().
[[nodiscard]] std::string to_string(const Box& box);

class Boxes {
 public:
  /// Every edit is checked against all boxes; the bound keeps that cheaper than sending the edit.
  static constexpr std::size_t kMax = 64;

  Boxes() = default;

  /// Parses "X,Z:X,Z" (all rows between two columns) or "X,Y,Z:X,Y,Z" (between two voxels), inclusive, in any
  /// order, several separated by ";"; "" for an empty list. An error is one line that names the wrong part.
  [[nodiscard]] static tl::expected<Boxes, std::string> parse(std::string_view text);

  void add(const Box& box) { boxes_.push_back(box); }

  [[nodiscard]] bool empty() const { return boxes_.empty(); }
  [[nodiscard]] std::size_t size() const { return boxes_.size(); }
  [[nodiscard]] auto begin() const { return boxes_.begin(); }
  [[nodiscard]] auto end() const { return boxes_.end(); }
  /// Inverse of parse().
  [[nodiscard]] std::string text() const;

  bool operator==(const Boxes&) const = default;

 private:
  std::vector<Box> boxes_;
};

}  // namespace talus::server
