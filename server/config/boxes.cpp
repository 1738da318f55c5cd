#include "config/boxes.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "runtime/log/escape.h"

#include "config/trimmed.h"

namespace talus::server {
namespace {

// Range of the world's voxels along each axis.
constexpr std::int64_t kLowest = -(std::int64_t{1} << 36);
constexpr std::int64_t kHighest = (std::int64_t{1} << 36) - 1;

constexpr std::string_view kForm =
    "write boxes as X,Z:X,Z or X,Y,Z:X,Y,Z, two corners each, separated by semicolons, as in "
    "-16,-16:16,16; 40,60,0:71,90,31";

/// Parses "X,Z" or "X,Y,Z"; nullopt if malformed.
std::optional<std::vector<std::int64_t>> parse_corner(std::string_view text) {
  std::vector<std::int64_t> numbers;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t comma = std::min(text.find(',', from), text.size());
    const std::string_view part = trimmed(text.substr(from, comma - from));
    std::int64_t number = 0;
    const auto [stop, error] = std::from_chars(part.data(), part.data() + part.size(), number);
    if (part.empty() || error != std::errc{} || stop != part.data() + part.size()) return std::nullopt;
    if (number < kLowest || number > kHighest) return std::nullopt;
    numbers.push_back(number);
    from = comma + 1;
  }
  if (numbers.size() != 2 && numbers.size() != 3) return std::nullopt;
  return numbers;
}

std::optional<Box> parse_box(std::string_view text) {
  const std::size_t colon = text.find(':');
  if (colon == std::string_view::npos) return std::nullopt;
  const auto a = parse_corner(text.substr(0, colon));
  const auto b = parse_corner(text.substr(colon + 1));
  if (!a || !b || a->size() != b->size()) return std::nullopt;
  const auto [first_x, last_x] = std::minmax(a->front(), b->front());
  const auto [first_z, last_z] = std::minmax(a->back(), b->back());
  Box box = Box::of_columns(first_x, first_z, last_x, last_z);
  if (a->size() == 3) std::tie(box.first.y, box.last.y) = std::minmax((*a)[1], (*b)[1]);
  return box;
}

}  // namespace

Box Box::of_columns(std::int64_t first_x, std::int64_t first_z, std::int64_t last_x, std::int64_t last_z) {
  return {{first_x, kLowest, first_z}, {last_x, kHighest, last_z}};
}

bool Box::holds(const Box& other) const {
  return first.x <= other.first.x && first.y <= other.first.y && first.z <= other.first.z &&
         last.x >= other.last.x && last.y >= other.last.y && last.z >= other.last.z;
}

bool Box::meets(const Box& other) const {
  return first.x <= other.last.x && first.y <= other.last.y && first.z <= other.last.z &&
         last.x >= other.first.x && last.y >= other.first.y && last.z >= other.first.z;
}

std::string to_string(const Box& box) {
  const auto& [first, last] = box;
  if (first.y == kLowest && last.y == kHighest)
    return fmt::format("{},{}:{},{}", first.x, first.z, last.x, last.z);
  return fmt::format("{},{},{}:{},{},{}", first.x, first.y, first.z, last.x, last.y, last.z);
}

tl::expected<Boxes, std::string> Boxes::parse(std::string_view text) {
  Boxes boxes;
  if (trimmed(text).empty()) return boxes;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t semicolon = std::min(text.find(';', from), text.size());
    const std::string_view part = trimmed(text.substr(from, semicolon - from));
    const auto box = parse_box(part);
    if (!box) {
      return tl::make_unexpected(
          fmt::format("\"{}\" is not a box of the world; {}", escaped(part, 80), kForm));
    }
    if (boxes.size() == kMax) {
      return tl::make_unexpected(fmt::format("the list has more than {} boxes; combine some", kMax));
    }
    boxes.add(*box);
    from = semicolon + 1;
  }
  return boxes;
}

std::string Boxes::text() const {
  std::string text;
  for (const Box& box : boxes_) text += (text.empty() ? "" : "; ") + to_string(box);
  return text;
}

}  // namespace talus::server
