#include "view_picture.h"

#include <array>
#include <atomic>
#include <cmath>
#include <thread>

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vector_relational.hpp>

#include "look.h"
#include "scene.h"
#include "sky.h"

namespace talus::cli {
namespace {

// Two samples of a pixel agree if the square roots of their light, near sRGB, differ by less in each channel.
constexpr float kSameRoot = 1.0F / 64;
constexpr double kShadowReach = 900.0;   // voxels
constexpr float kThroughClouds = 0.85F;  // share of the sun's light
constexpr double kCalmDistance = 150.0;  // voxels over which waves fall to 1/e
// Water as in the viewer: client_sample/web/viewer/src/engine/shaders/water.ts and terrain.ts.
const glm::vec3 kWaterBody{0.012F, 0.085F, 0.11F};       // reflectance of deep water
const glm::vec3 kWaterScatter{0.012F, 0.075F, 0.095F};   // reflectance of the water between surface and bed
const glm::vec3 kWaterAbsorption{0.30F, 0.085F, 0.06F};  // light absorbed per voxel
constexpr double kWaterReach = 96.0;                     // maximum distance at which a bed is visible, voxels

// A constant pseudo-random value per voxel, 0 to 1.
float speckle(const glm::i64vec3& voxel) {
  auto bits = static_cast<std::uint64_t>(voxel.x) * 0x9E3779B97F4A7C15U ^
              static_cast<std::uint64_t>(voxel.y) * 0xC2B2AE3D27D4EB4FU ^
              static_cast<std::uint64_t>(voxel.z) * 0x165667B19E3779F9U;
  bits = (bits ^ (bits >> 29U)) * 0xBF58476D1CE4E5B9U;
  return static_cast<float>((bits >> 40U) & 0xFFFFU) / 65535.0F;
}

class Painter {
 public:
  Painter(const client::ChunkStore& store, const std::vector<client::Material>& materials,
          const Camera& camera, double visible_voxels)
      : scene_{store,
               materials,
               {static_cast<std::int64_t>(std::floor(camera.position.x)),
                static_cast<std::int64_t>(std::floor(camera.position.y)),
                static_cast<std::int64_t>(std::floor(camera.position.z))}},
        eye_{camera.position - glm::dvec3{to_vec(scene_.origin())}},
        forward_{camera.direction},
        right_{glm::normalize(glm::cross(camera.direction, glm::dvec3{0, 1, 0}))},
        up_{glm::cross(right_, camera.direction)},
        half_width_{std::tan(camera.field_of_view_degrees * 0.5 * 0.017453292519943295)},
        reach_{visible_voxels} {
    const Looks looks;
    for (const auto& material : materials) {
      colours_[to_integer(material.id)] = looks.colour_of(material);
    }
    // From behind the camera's left shoulder, low enough for long shadows.
    const glm::dvec3 level = glm::normalize(glm::dvec3{forward_.x, 0, forward_.z});
    sky_ = Sky{glm::normalize(glm::vec3{level * -0.35 - right_ * 0.95 + glm::dvec3{0, 0.62, 0}})};
  }

  [[nodiscard]] glm::vec3 pixel(int x, int y, int width, int height) const {
    const auto sample = [&](double across, double down) {
      const double right = (2.0 * (x + across) / width - 1.0) * half_width_;
      const double up = (1.0 - 2.0 * (y + down) / height) * half_width_ * height / width;
      return shown(sky_.exposure * light_along(glm::normalize(forward_ + right_ * right + up_ * up)));
    };
    // Two samples on a diagonal, and two more if these reveal an edge. An edge along the diagonal may be
    // missed between the other two, so the diagonals alternate.
    const double left = (x + y) % 2 == 0 ? 0.25 : 0.75;
    const double right = 1.0 - left;
    const glm::vec3 first = sample(left, 0.25);
    const glm::vec3 second = sample(right, 0.75);
    const glm::vec3 half = (first + second) * 0.5F;
    const glm::vec3 apart = glm::abs(glm::sqrt(first) - glm::sqrt(second));
    if (glm::all(glm::lessThan(apart, glm::vec3{kSameRoot}))) return half;
    return (half + (sample(right, 0.25) + sample(left, 0.75)) * 0.5F) * 0.5F;
  }

 private:
  [[nodiscard]] glm::vec3 light_along(const glm::dvec3& ray) const {
    const glm::vec3 direction{ray};
    const auto hit = scene_.cast(eye_, ray, reach_, Scene::Stop::at_anything);
    if (!hit) return sky_.seen(direction);
    const glm::vec3 light = scene_.liquid(hit->material) ? water(*hit, ray) : ground(*hit);
    return hazed(light, hit->distance, direction);
  }

  [[nodiscard]] glm::vec3 hazed(const glm::vec3& light, double distance, const glm::vec3& direction) const {
    const auto part = static_cast<float>(distance / reach_);
    const float clear = std::exp(-2.8F * part * part) * (1.0F - glm::smoothstep(0.86F, 1.0F, part));
    return glm::mix(sky_.haze(direction), light, clear);
  }

  [[nodiscard]] glm::vec3 ground(const Hit& hit) const {
    const glm::vec3 normal{hit.normal};
    const float facing = std::max(0.0F, glm::dot(normal, sky_.to_sun));
    const float sun = facing > 0 && sunlit(hit) ? facing * kThroughClouds : 0.0F;
    return colour_of(hit) * (sky_.sunlight * sun + sky_.ambient(normal) * openness(hit));
  }

  // Light of the bed seen through water; `sun` is the share that reaches the surface, 0 to 1.
  [[nodiscard]] glm::vec3 bed_light(const Hit& hit, float path, float sun) const {
    const glm::vec3 normal{hit.normal};
    const float facing = std::max(0.0F, glm::dot(normal, sky_.to_sun));
    const glm::vec3 lit =
        colour_of(hit) * (sky_.sunlight * (facing * sun) + sky_.ambient(normal) * openness(hit));
    return lit * glm::exp(-kWaterAbsorption * std::min(path, 40.0F)) + scattered(path);
  }

  [[nodiscard]] glm::vec3 scattered(float path) const {
    return kWaterScatter * (1.0F - std::exp(-0.11F * path)) *
           (sky_.sunlight * 0.28F + sky_.from_above * 0.75F);
  }

  [[nodiscard]] glm::vec3 colour_of(const Hit& hit) const {
    const glm::i64vec3 place = to_vec(scene_.origin()) + glm::i64vec3{hit.voxel};
    const float grain = 0.90F + 0.20F * speckle(place);
    // Patches a few voxels wide, so that a meadow is not uniform.
    const float patch = 0.94F + 0.12F * speckle({place.x >> 3, place.y >> 3, place.z >> 3});
    return colours_[hit.material] * (grain * patch);
  }

  [[nodiscard]] bool sunlit(const Hit& hit) const {
    // The steps of a slope would each cast a small shadow; the ray starts beyond the next few, which
    // openness() shades.
    const glm::dvec3 from =
        hit.point + glm::dvec3{hit.normal} * 0.02 + glm::dvec3{sky_.to_sun} * (1.8 * hit.size);
    return !scene_.cast(from, glm::dvec3{sky_.to_sun}, kShadowReach, Scene::Stop::at_solid);
  }

  // Share of the sky that a point of a face sees past neighbouring voxels: each corner is darkened by the
  // voxels around it, and the corners are interpolated across the face.
  [[nodiscard]] float openness(const Hit& hit) const {
    const int axis = hit.normal.x != 0 ? 0 : hit.normal.y != 0 ? 1 : 2;
    const int first = (axis + 1) % 3;
    const int second = (axis + 2) % 3;
    const glm::ivec3 before = hit.voxel + hit.normal * hit.size;
    std::array<std::array<bool, 3>, 3> filled{};
    for (int i = -1; i <= 1; ++i) {
      for (int j = -1; j <= 1; ++j) {
        glm::ivec3 at = before;
        at[first] += i * hit.size;
        at[second] += j * hit.size;
        filled[static_cast<std::size_t>(i + 1)][static_cast<std::size_t>(j + 1)] =
            (i != 0 || j != 0) && scene_.solid_at(at);
      }
    }
    const auto corner = [&](std::size_t i, std::size_t j) {
      const bool side_a = filled[i][1];
      const bool side_b = filled[1][j];
      const int covered = side_a && side_b ? 3 : int{side_a} + int{side_b} + int{filled[i][j]};
      return 1.0F - 0.22F * static_cast<float>(covered);
    };
    const auto across = [&](int which) {
      return static_cast<float>(glm::clamp((hit.point[which] - hit.voxel[which]) / hit.size, 0.0, 1.0));
    };
    const float u = across(first);
    const float v = across(second);
    return glm::mix(glm::mix(corner(0, 0), corner(2, 0), u), glm::mix(corner(0, 2), corner(2, 2), u), v);
  }

  // Slope of small waves: a few crossing sines, which fade in the distance, where a wave would be narrower
  // than a pixel and appear as noise.
  [[nodiscard]] glm::vec2 wave_slope(const Hit& hit) const {
    struct Wave {
      double east, south;  // 2 pi over the wavelength, 5 to 14 voxels, along each axis
      float slope;
    };
    constexpr std::array<Wave, 4> kWaves{
        {{0.41, 0.19, 0.010F}, {-0.33, 0.52, 0.008F}, {0.70, -0.46, 0.006F}, {0.15, 1.20, 0.004F}}};
    const glm::dvec3 place = glm::dvec3{to_vec(scene_.origin())} + hit.point;
    glm::vec2 slope{0.0F};
    for (const Wave& wave : kWaves) {
      const auto height = static_cast<float>(std::cos(wave.east * place.x + wave.south * place.z));
      slope += wave.slope * height * glm::normalize(glm::vec2{wave.east, wave.south});
    }
    return slope * static_cast<float>(std::exp(-hit.distance / kCalmDistance));
  }

  // Share of land in the mirror image in this direction, 0 to 1. Averages heights at a few distances, or
  // single voxels of the bank would appear in the mirror with sharp edges.
  [[nodiscard]] float hills(const glm::dvec3& from, const glm::dvec3& away) const {
    constexpr double kLow = -2.0;   // height of the land above the ray at which it begins to show
    constexpr double kHigh = 10.0;  // height at which it hides the sky
    float most = 0.0F;
    for (const double distance : {14.0, 28.0, 56.0, 112.0, 224.0}) {
      const glm::dvec3 top = from + away * distance + glm::dvec3{0, kHigh, 0};
      const auto land = scene_.cast(top, {0, -1, 0}, kHigh - kLow, Scene::Stop::at_solid);
      if (!land) continue;
      const double above = kHigh - land->distance;
      most = std::max(most, static_cast<float>(glm::smoothstep(kLow, kHigh, above)));
    }
    return most;
  }

  [[nodiscard]] glm::vec3 mirrored(const glm::dvec3& from, const glm::vec3& away) const {
    const glm::vec3 sky = sky_.seen(away);
    // One dark tone for all hills: a mirror that shows every colour would look like glass.
    const glm::vec3 land =
        (sky_.from_above * 0.10F + sky_.sunlight * 0.04F) * glm::vec3{0.55F, 0.7F, 0.4F} + sky * 0.25F;
    return glm::mix(sky, land, 0.8F * hills(from, glm::dvec3{away}));
  }

  [[nodiscard]] glm::vec3 water(const Hit& hit, const glm::dvec3& ray) const {
    const bool top = hit.normal.y > 0;
    const glm::vec3 direction{ray};
    const float sun = sunlit(hit) ? kThroughClouds : 0.0F;
    const auto bed = scene_.cast(hit.point + ray * 0.01, ray, kWaterReach, Scene::Stop::at_solid);
    const auto along = static_cast<float>(bed ? bed->distance : kWaterReach);
    // Light passes through the water above the bed twice; from the side, only the visible path counts.
    const float depth = top ? along * -direction.y : along;
    const float path = top ? depth * (1.0F + 0.6F / std::max(-direction.y, 0.25F)) : along;
    const glm::vec3 below = bed ? bed_light(*bed, path, sun) : scattered(path);
    const glm::vec3 body =
        glm::mix(colours_[hit.material] * glm::vec3{0.35F, 0.75F, 0.8F}, kWaterBody, 0.6F) *
        (sky_.sunlight * (0.3F * sun) + sky_.from_above * 0.8F);
    const float murk = 0.06F + 0.55F * (1.0F - std::exp(-0.10F * depth));

    const glm::vec2 lean = wave_slope(hit);
    const glm::vec3 normal = top ? glm::normalize(glm::vec3{lean.x, 1.0F, lean.y}) : glm::vec3{hit.normal};
    const float head_on = glm::clamp(-glm::dot(direction, normal), 0.0F, 1.0F);
    const float mirror = 0.02F + 0.98F * std::pow(1.0F - head_on, 5.0F);
    glm::vec3 away = glm::reflect(direction, normal);
    away.y = std::abs(away.y);
    return glm::mix(glm::mix(below, body, murk), mirrored(hit.point, away), mirror);
  }

  Scene scene_;
  Sky sky_;
  // By material; black if it is missing in Welcome.
  std::vector<glm::vec3> colours_ = std::vector<glm::vec3>(std::size_t{1} << 16U, glm::vec3{0.0F});
  glm::dvec3 eye_, forward_, right_, up_;
  double half_width_;
  double reach_;
};

}  // namespace

Picture draw_view(const client::ChunkStore& store, const std::vector<client::Material>& materials,
                  const Camera& camera, double visible_voxels, int width, int height,
                  const std::function<void(int)>& rows_done) {
  const Painter painter{store, materials, camera, visible_voxels};
  Picture picture{width, height};
  std::atomic<int> next_row{0};
  std::atomic<int> rows{0};
  const auto paint_row = [&](int y) {
    for (int x = 0; x < width; ++x) picture.at(x, y) = painter.pixel(x, y, width, height);
    ++rows;
  };
  std::jthread second{[&] {
    for (int y = next_row++; y < height; y = next_row++) paint_row(y);
  }};
  for (int y = next_row++; y < height; y = next_row++) {
    paint_row(y);
    rows_done(rows.exchange(0));
  }
  second.join();
  if (const int rest = rows.exchange(0); rest > 0) rows_done(rest);
  return picture;
}

}  // namespace talus::cli
