#include "map_picture.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>

namespace talus::cli {
namespace {

const glm::vec3 kUnseen = to_light(0xD3D8DF);
const glm::vec3 kUnseenStripe = to_light(0xBBC2CC);
const glm::vec3 kPath = to_light(0xFFF4D6);
const glm::vec3 kSun = glm::normalize(glm::vec3{-0.55F, 0.75F, -0.5F});  // from the north-west
constexpr int kStripe = 3;                                               // pixels, and as many between two
constexpr int kSmoothRing = 2;  // columns: voxel steps would else shade every hill as a staircase

using Points = std::vector<std::optional<SurfacePoint>>;

// What is drawn: the surface at every `step`-th column.
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

// Mean ground height around a pixel, of what is known there.
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

// 1 on a plain: sun on the slope, and less sky in hollows than on ridges.
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

// As talus-gen's maps have it: red is lost first, and water grows darker with its depth.
glm::vec3 water_over(const glm::vec3& bed, const glm::vec3& water, std::int32_t rows) {
  const auto depth = static_cast<float>(rows);
  const glm::vec3 through = 0.42F * glm::exp(-depth * glm::vec3{0.76F, 0.38F, 0.28F});
  const float deep = glm::mix(0.42F, 1.0F, std::exp(-depth / 28.0F));
  return water * deep * (1.0F - through) + bed * through;
}

void draw_path(Picture& picture, const Extent& extent, std::int64_t step,
               const std::vector<glm::dvec2>& path) {
  const auto dot = [&](glm::dvec2 at, float strength) {
    const auto x =
        static_cast<int>(std::floor((at.x - static_cast<double>(extent.x)) / static_cast<double>(step)));
    const auto y =
        static_cast<int>(std::floor((at.y - static_cast<double>(extent.z)) / static_cast<double>(step)));
    if (x < 0 || y < 0 || x >= picture.width || y >= picture.height) return;
    picture.at(x, y) = glm::mix(picture.at(x, y), kPath, strength);
  };
  for (std::size_t i = 1; i < path.size(); ++i) {
    const double length = glm::length(path[i] - path[i - 1]) / static_cast<double>(step);
    const int parts = std::max(1, static_cast<int>(std::ceil(length)));
    for (int part = 0; part < parts; ++part) {
      dot(glm::mix(path[i - 1], path[i], static_cast<double>(part) / parts), 0.8F);
    }
  }
  if (path.empty()) return;
  // A ring where the flight ended.
  for (int degree = 0; degree < 360; degree += 4) {
    const double angle = degree * 0.017453292519943295;
    dot(path.back() + glm::dvec2{std::cos(angle), std::sin(angle)} * 4.0 * static_cast<double>(step), 0.9F);
  }
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
        // Hatched, as maps are where nothing is known.
        pixel = (x + y) / kStripe % 2 == 0 ? kUnseenStripe : kUnseen;
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
