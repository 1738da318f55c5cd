#include "map_picture.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>

namespace talus::cli {
namespace {

// Darker than land: light grey would look like snow or rock.
const glm::vec3 kUnseen = to_light(0x2B313A);
const glm::vec3 kUnseenStripe = to_light(0x3D4551);
const glm::vec3 kEdge = to_light(0x0E1116);  // around known land
const glm::vec3 kPath = to_light(0xFFFFFF);
const glm::vec3 kPathOutline = to_light(0x14181E);
const glm::vec3 kSun = glm::normalize(glm::vec3{-0.55F, 0.75F, -0.5F});  // from the north-west
constexpr int kStripe = 2;                                               // pixels
constexpr int kStripeApart = 7;                                          // distance between stripes
constexpr double kPathHalf = 1.0;                                        // pixels
constexpr double kOutlineHalf = 2.2;
constexpr int kSmoothRing = 2;  // columns; without it, hills would be shaded as staircases

using Points = std::vector<std::optional<SurfacePoint>>;

// The drawn surface, at every `step`-th column.
struct Sheet {
  int width = 0;
  int height = 0;
  std::int64_t step = 1;
  Points points;

  [[nodiscard]] const SurfacePoint* at(int x, int y) const {
    if (x < 0 || y < 0 || x >= width || y >= height) return nullptr;
    const auto& point =
        points[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
    return point ? &*point : nullptr;
  }
};

Sheet sheet_of(const SurfaceMap& surface, const Extent& extent) {
  Sheet sheet;
  sheet.step = (std::max(extent.width, extent.depth) + kMaxMapSide - 1) / kMaxMapSide;
  sheet.width = static_cast<int>((extent.width + sheet.step - 1) / sheet.step);
  sheet.height = static_cast<int>((extent.depth + sheet.step - 1) / sheet.step);
  sheet.points.reserve(static_cast<std::size_t>(sheet.width) * static_cast<std::size_t>(sheet.height));
  for (int y = 0; y < sheet.height; ++y) {
    for (int x = 0; x < sheet.width; ++x) {
      sheet.points.push_back(surface.at(extent.x + x * sheet.step, extent.z + y * sheet.step));
    }
  }
  return sheet;
}

// Mean ground height around a pixel, over known pixels.
float smooth_height(const Sheet& sheet, int x, int y) {
  float sum = 0;
  float weight = 0;
  for (int dy = -kSmoothRing; dy <= kSmoothRing; ++dy) {
    for (int dx = -kSmoothRing; dx <= kSmoothRing; ++dx) {
      const SurfacePoint* point = sheet.at(x + dx, y + dy);
      if (point == nullptr) continue;
      const auto share =
          static_cast<float>((kSmoothRing + 1 - std::abs(dx)) * (kSmoothRing + 1 - std::abs(dy)));
      sum += share * static_cast<float>(point->ground);
      weight += share;
    }
  }
  return weight > 0 ? sum / weight : 0;
}

class SmoothHeights {
 public:
  explicit SmoothHeights(const Sheet& sheet) : width_{sheet.width}, height_{sheet.height} {
    values_.reserve(sheet.points.size());
    for (int y = 0; y < height_; ++y) {
      for (int x = 0; x < width_; ++x) values_.push_back(smooth_height(sheet, x, y));
    }
  }
  [[nodiscard]] float at(int x, int y) const {
    const int cx = std::clamp(x, 0, width_ - 1);
    const int cy = std::clamp(y, 0, height_ - 1);
    return values_[static_cast<std::size_t>(cy) * static_cast<std::size_t>(width_) +
                   static_cast<std::size_t>(cx)];
  }

 private:
  int width_;
  int height_;
  std::vector<float> values_;
};

// 1 on a plain; depends on the sun on the slope, and is lower in hollows than on ridges.
float light_at(const Sheet& sheet, const SmoothHeights& heights, int x, int y) {
  const auto known = [&](int px, int py) { return sheet.at(px, py) != nullptr; };
  if (!known(x - 1, y) || !known(x + 1, y) || !known(x, y - 1) || !known(x, y + 1)) return 1.0F;
  const float run = 2.0F * static_cast<float>(sheet.step);
  const float slope_x = (heights.at(x + 1, y) - heights.at(x - 1, y)) / run;
  const float slope_z = (heights.at(x, y + 1) - heights.at(x, y - 1)) / run;
  const glm::vec3 normal = glm::normalize(glm::vec3{-slope_x, 1.0F, -slope_z});
  const float sun = std::max(0.0F, glm::dot(normal, kSun)) / kSun.y;
  float rim = 0;
  for (const auto& [dx, dy] : {std::pair{-5, 0}, {5, 0}, {0, -5}, {0, 5}}) {
    if (known(x + dx, y + dy)) rim += (heights.at(x + dx, y + dy) - heights.at(x, y)) / 4.0F;
  }
  const float sky = glm::clamp(1.0F - rim * 0.035F / static_cast<float>(sheet.step), 0.7F, 1.15F);
  return (0.25F + 0.75F * sun) * sky;
}

// As in talus-gen's maps: red is absorbed first, and water darkens with depth.
glm::vec3 water_over(const glm::vec3& bed, const glm::vec3& water, std::int32_t rows) {
  const auto depth = static_cast<float>(rows);
  const glm::vec3 through = 0.42F * glm::exp(-depth * glm::vec3{0.76F, 0.38F, 0.28F});
  const float deep = glm::mix(0.42F, 1.0F, std::exp(-depth / 28.0F));
  return water * deep * (1.0F - through) + bed * through;
}

// Unknown land is hatched, with an edge around known land.
glm::vec3 unseen(const Sheet& sheet, int x, int y) {
  for (const auto& [dx, dy] : {std::pair{-1, 0}, {1, 0}, {0, -1}, {0, 1}}) {
    if (sheet.at(x + dx, y + dy) != nullptr) return kEdge;
  }
  return (x + y) % kStripeApart < kStripe ? kUnseenStripe : kUnseen;
}

// A smooth line: stores the distance of the pixels that it may cover.
class Line {
 public:
  Line(int width, int height) : width_{width}, height_{height} {}

  void dot(const glm::dvec2& at) {
    constexpr int kRing = 3;
    const glm::ivec2 middle{glm::floor(at)};
    for (int y = std::max(middle.y - kRing, 0); y <= std::min(middle.y + kRing, height_ - 1); ++y) {
      for (int x = std::max(middle.x - kRing, 0); x <= std::min(middle.x + kRing, width_ - 1); ++x) {
        const double apart = glm::length(glm::dvec2{x + 0.5, y + 0.5} - at);
        const auto found = nearest_.try_emplace({x, y}, apart).first;
        found->second = std::min(found->second, apart);
      }
    }
  }

  void draw(Picture& picture) const {
    const auto covered = [](double half, double apart) {
      return static_cast<float>(glm::clamp(half + 0.5 - apart, 0.0, 1.0));
    };
    for (const auto& [place, apart] : nearest_) {
      glm::vec3& pixel = picture.at(place.first, place.second);
      pixel = glm::mix(pixel, kPathOutline, 0.85F * covered(kOutlineHalf, apart));
      pixel = glm::mix(pixel, kPath, covered(kPathHalf, apart));
    }
  }

 private:
  int width_;
  int height_;
  std::map<std::pair<int, int>, double> nearest_;
};

void draw_path(Picture& picture, const Extent& extent, std::int64_t step,
               const std::vector<glm::dvec2>& path) {
  if (path.empty()) return;
  const auto in_picture = [&](const glm::dvec2& at) {
    return (at - glm::dvec2{extent.x, extent.z}) / static_cast<double>(step);
  };
  Line line{picture.width, picture.height};
  for (std::size_t i = 1; i < path.size(); ++i) {
    const glm::dvec2 from = in_picture(path[i - 1]);
    const glm::dvec2 to = in_picture(path[i]);
    const int parts = std::max(1, static_cast<int>(std::ceil(glm::length(to - from) * 2.0)));
    for (int part = 0; part < parts; ++part) line.dot(glm::mix(from, to, static_cast<double>(part) / parts));
  }
  // Draw a ring at the end of the flight.
  for (int degree = 0; degree < 360; degree += 4) {
    const double angle = degree * 0.017453292519943295;
    line.dot(in_picture(path.back()) + glm::dvec2{std::cos(angle), std::sin(angle)} * 6.0);
  }
  line.draw(picture);
}

}  // namespace

Picture draw_map(const SurfaceMap& surface, const std::vector<client::Material>& materials,
                 const Extent& extent, const std::vector<glm::dvec2>& path) {
  std::vector<glm::vec3> colours;
  for (const auto& material : materials) {
    const std::size_t id = to_integer(material.id);
    if (colours.size() <= id) colours.resize(id + 1, kUnseen);
    colours[id] = to_light(material.colour);
  }
  const auto colour_of = [&](MaterialId material) {
    const std::size_t id = to_integer(material);
    return id < colours.size() ? colours[id] : kUnseen;
  };
  const Sheet sheet = sheet_of(surface, extent);
  const SmoothHeights heights{sheet};
  Picture picture{sheet.width, sheet.height};
  for (int y = 0; y < sheet.height; ++y) {
    for (int x = 0; x < sheet.width; ++x) {
      const SurfacePoint* point = sheet.at(x, y);
      glm::vec3& pixel = picture.at(x, y);
      if (point == nullptr) {
        pixel = unseen(sheet, x, y);
        continue;
      }
      pixel = colour_of(point->material) * light_at(sheet, heights, x, y);
      if (point->water) pixel = water_over(pixel, colour_of(*point->water), point->top - point->ground);
    }
  }
  draw_path(picture, extent, sheet.step, path);
  return picture;
}

}  // namespace talus::cli
