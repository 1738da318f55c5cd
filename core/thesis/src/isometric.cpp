#include "isometric.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include <talus/tools/ordered_work.h>
#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>

#include "voxel_light.h"
#include "voxel_rays.h"

namespace talus::tools {
namespace {

constexpr int kBandRows = 16;
constexpr float kElevation = 0.56F;  // radians above the horizon, 32 degrees
constexpr float kMargin = 0.05F;     // of the picture, on each side
const glm::vec3 kSunlight{1.02F, 0.93F, 0.78F};
const glm::vec3 kSkylight{0.40F, 0.47F, 0.60F};
const glm::vec3 kGroundlight{0.15F, 0.14F, 0.135F};  // reflected by the terrain and the table
const glm::vec3 kTableFar{0.70F, 0.77F, 0.84F};
const glm::vec3 kTableNear{0.90F, 0.895F, 0.88F};

// A pseudo-random number from 0 to 1 for each voxel.
float speckle(glm::ivec3 voxel) {
  auto hash = static_cast<std::uint32_t>(voxel.x) * 0x8DA6B343U ^
              static_cast<std::uint32_t>(voxel.y) * 0xD8163841U ^
              static_cast<std::uint32_t>(voxel.z) * 0xCB1AB31FU;
  hash ^= hash >> 15;
  hash *= 0x2C1B3C6DU;
  hash ^= hash >> 13;
  return static_cast<float>(hash & 0xFFFFU) / 0xFFFF;
}

// Ordered dither of less than one 8-bit step either way: smooth ground stays smooth with few colours.
float dither(int x, int y) {
  constexpr std::array<std::array<int, 4>, 4> kOrder{
      {{0, 8, 2, 10}, {12, 4, 14, 6}, {3, 11, 1, 9}, {15, 7, 13, 5}}};
  const int place = kOrder[static_cast<std::size_t>(y % 4)][static_cast<std::size_t>(x % 4)];
  return 0.016F * ((static_cast<float>(place) + 0.5F) / 16 - 0.5F);
}

// Bright colours keep their hue instead of clipping.
glm::vec3 developed(glm::vec3 light) {
  return light * 1.12F / (1.0F + 0.16F * light);
}

// Origins of rays, for a picture that contains the whole box.
class Camera {
 public:
  Camera(const VoxelGrid& grid, int width, int height)
      : toward_{glm::vec3{std::cos(kElevation) * kHalf, std::sin(kElevation), std::cos(kElevation) * kHalf}},
        right_{glm::vec3{kHalf, 0, -kHalf}},
        up_{glm::vec3{-std::sin(kElevation) * kHalf, std::cos(kElevation), -std::sin(kElevation) * kHalf}} {
    glm::vec2 low{1e9F};
    glm::vec2 high{-1e9F};
    for (int corner = 0; corner < 8; ++corner) {
      const glm::vec3 point{(corner & 1) != 0 ? grid.width() : 0, (corner & 2) != 0 ? grid.rows() : 0,
                            (corner & 4) != 0 ? grid.depth() : 0};
      const glm::vec2 seen{glm::dot(point, right_), glm::dot(point, up_)};
      low = glm::min(low, seen);
      high = glm::max(high, seen);
    }
    const glm::vec2 picture{width, height};
    const glm::vec2 fits = (high - low) / (picture * (1 - 2 * kMargin));
    voxels_per_pixel_ = std::max(fits.x, fits.y);
    const glm::vec2 middle = (low + high) / 2.0F;
    corner_ = middle + glm::vec2{-picture.x, picture.y} / 2.0F * voxels_per_pixel_;
    distance_ = 2 * static_cast<float>(grid.width() + grid.rows() + grid.depth());
  }

  [[nodiscard]] glm::vec3 origin(float pixel_x, float pixel_y) const {
    const float x = corner_.x + pixel_x * voxels_per_pixel_;
    const float y = corner_.y - pixel_y * voxels_per_pixel_;
    return right_ * x + up_ * y + toward_ * distance_;
  }
  [[nodiscard]] glm::vec3 direction() const { return -toward_; }
  [[nodiscard]] float pixels_per_voxel() const { return 1 / voxels_per_pixel_; }

 private:
  static constexpr float kHalf = 0.70710678F;
  glm::vec3 toward_;  // the eye
  glm::vec3 right_;
  glm::vec3 up_;
  glm::vec2 corner_{0};
  float voxels_per_pixel_ = 1;
  float distance_ = 0;
};

class BandPainter {
 public:
  BandPainter(const VoxelRays& rays, const Camera& camera, std::span<const glm::vec3> lights,
              const IsometricOptions& options)
      : rays_{rays},
        camera_{camera},
        lights_{lights},
        options_{options},
        light_{rays},
        seam_{glm::clamp((camera.pixels_per_voxel() - 3) / 7, 0.0F, 1.0F)},
        // Both fade if voxels are smaller than a few pixels, as they would look like noise.
        grain_{0.16F * glm::clamp((camera.pixels_per_voxel() - 1) / 5, 0.0F, 1.0F)},
        corner_{glm::mix(0.22F, 0.45F, glm::clamp((camera.pixels_per_voxel() - 1) / 6, 0.0F, 1.0F))} {}

  [[nodiscard]] glm::vec3 pixel(int x, int y) {
    glm::vec3 sum{0};
    dither_ = dither(x, y);
    const int n = options_.samples;
    for (int i = 0; i < n * n; ++i) {
      const float sub_x = (static_cast<float>(i % n) + 0.5F) / static_cast<float>(n);
      const float sub_y = (static_cast<float>(i / n) + 0.5F) / static_cast<float>(n);
      sample_ = static_cast<std::size_t>(i);
      const glm::vec2 place{static_cast<float>(x) + sub_x, static_cast<float>(y) + sub_y};
      sum += glm::min(developed(trace(camera_.origin(place.x, place.y), place)), glm::vec3{1});
    }
    return sum / static_cast<float>(n * n);
  }

 private:
  glm::vec3 trace(glm::vec3 origin, glm::vec2 pixel) {
    const glm::vec3 direction = camera_.direction();
    const Sight sight = rays_.see(origin, direction);
    glm::vec3 colour =
        sight.solid ? solid(*sight.solid, origin + direction * sight.solid->distance) : table(origin, pixel);
    if (sight.water) {
      const float length = sight.solid ? sight.solid->distance - sight.water->distance : 1e9F;
      colour = water(*sight.water, origin + direction * sight.water->distance, colour, length);
    }
    return colour;
  }

  glm::vec3 lit(const RayHit& hit, glm::vec3 point) {
    const float sun = light_.sun(point, hit.face, sun_direction(sample_));
    const float sky = light_.sky(hit);
    return kSunlight * sun + kSkylight * sky + kGroundlight * (hit.face == Face::up ? 0.3F : 1.0F);
  }

  glm::vec3 solid(const RayHit& hit, glm::vec3 point) {
    const glm::vec3 inside = point - glm::vec3{hit.voxel};
    const FaceAxes axes = face_axes(hit.face);
    const glm::vec2 place = glm::clamp(
        glm::vec2{glm::dot(inside, glm::vec3{axes.u}), glm::dot(inside, glm::vec3{axes.v})}, 0.0F, 1.0F);
    const glm::vec2 rim = glm::min(place, 1.0F - place);
    const float seam = glm::smoothstep(0.0F, 0.09F, std::min(rim.x, rim.y));
    const MaterialId material = rays_.grid().at(hit.voxel.x, hit.voxel.y, hit.voxel.z);
    const float speckled = 1 + grain_ * (speckle(hit.voxel) - 0.5F);
    const float corners = 1 - corner_ * (1 - light_.corners(hit, place));
    return lights_[to_integer(material)] * lit(hit, point) * speckled * corners *
           (1 - 0.16F * seam_ * (1 - seam));
  }

  glm::vec3 water(const RayHit& hit, glm::vec3 point, glm::vec3 behind, float length) {
    const float through = 0.8F * std::exp(-length / options_.clear_water);
    const glm::vec3 own = lights_[to_integer(kWater)] * lit(hit, point);
    const glm::vec3 mirrored = hit.face == Face::up ? kSkylight * 0.10F : glm::vec3{0};
    return glm::mix(own, behind * glm::vec3{0.78F, 0.93F, 1.0F}, through) + mirrored;
  }

  // The table below the block, with its shadow, which fades at the edges of the picture so that it does not
  // look cut off.
  glm::vec3 table(glm::vec3 origin, glm::vec2 pixel) const {
    const glm::vec3 direction = camera_.direction();
    const glm::vec3 point = origin + direction * (-origin.y / direction.y);
    const glm::vec2 box{rays_.grid().width(), rays_.grid().depth()};
    const glm::vec2 place{point.x, point.z};
    const float away = glm::length(place - glm::clamp(place, glm::vec2{0}, box));
    const float reach = 0.035F * (box.x + box.y);
    float shade = 1 - 0.30F * std::exp(-away / reach);
    if (rays_.blocked(point + glm::vec3{0, 1e-2F, 0}, sun_direction(sample_))) {
      const auto width = static_cast<float>(options_.width);
      const float inward = std::min(pixel.x, width - pixel.x) / width;
      shade *= 1 - 0.20F * glm::smoothstep(0.0F, 0.07F, inward);
    }
    const float down = pixel.y / static_cast<float>(options_.height);
    return glm::mix(kTableFar, kTableNear, glm::smoothstep(0.0F, 1.0F, down)) *
               glm::mix(glm::vec3{0.78F, 0.86F, 1.0F}, glm::vec3{1}, shade) * shade +
           dither_;
  }

  const VoxelRays& rays_;
  const Camera& camera_;
  std::span<const glm::vec3> lights_;
  const IsometricOptions& options_;
  VoxelLight light_;
  float seam_;
  float grain_;
  float corner_;
  std::size_t sample_ = 0;
  float dither_ = 0;
};

}  // namespace

Image render_isometric(const VoxelGrid& grid, std::span<const glm::vec3> lights,
                       const IsometricOptions& options, ProgressBar& progress) {
  Image image{options.width, options.height};
  const VoxelRays rays{grid};
  const Camera camera{grid, options.width, options.height};
  const auto bands = static_cast<std::size_t>((options.height + kBandRows - 1) / kBandRows);
  const auto paint = [&](std::size_t band) {
    BandPainter painter{rays, camera, lights, options};
    const int first = static_cast<int>(band) * kBandRows;
    const int last = std::min(first + kBandRows, options.height);
    for (int y = first; y < last; ++y) {
      for (int x = 0; x < options.width; ++x) image.set(x, y, to_colour(painter.pixel(x, y)));
    }
    return static_cast<std::uint64_t>(last - first);
  };
  work_in_order(bands, thread_count(options.threads), paint, [&](std::size_t, std::uint64_t rows) {
    progress.advance(rows);
    return true;
  });
  return image;
}

}  // namespace talus::tools
