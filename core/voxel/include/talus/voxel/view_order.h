// The order in which the chunks of a View are wanted. The server sends them in it, and a client that makes
// chunks itself makes them in it. Pure functions of values.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <talus/voxel/coords.h>

namespace talus {

class ViewOrder {
 public:
  ViewOrder() = default;
  /// `centre`: the base chunk of the View's centre. `direction` may have any length; zero or not finite: no
  /// preference.
  ViewOrder(glm::i64vec3 centre, glm::vec3 direction) : centre_{centre} {
    const float length = glm::length(direction);
    if (std::isfinite(length) && length > 0.0F) direction_ = direction / length;
  }

  /// From the View's centre to the chunk's, in half base chunks, so that it is an integer. Chunks of a
  /// horizon 2^15 or more base chunks above or below count as 2^15 away, so that its square does not
  /// overflow.
  [[nodiscard]] glm::i64vec3 offset(ChunkKey key) const {
    const std::int64_t size = std::int64_t{1} << key.lod.value();
    const auto halves = [size](std::int64_t at, std::int64_t centre) {
      return (2 * at + 1) * size - (2 * centre + 1);
    };
    constexpr std::int64_t kFarthest = 1 << 16;
    return {halves(key.coord.x, centre_.x), std::clamp(halves(key.coord.y, centre_.y), -kFarthest, kFarthest),
            halves(key.coord.z, centre_.z)};
  }

  /// Lower for chunks wanted sooner: by ring, which is the distance of the centres in whole base chunks; then
  /// by the angle to the direction; then by the exact distance.
  [[nodiscard]] std::uint64_t rank(ChunkKey key) const {
    const glm::dvec3 to{offset(key)};
    const double distance = glm::length(to);
    const double cosine = distance > 0 ? std::clamp(glm::dot(direction_, to) / distance, -1.0, 1.0) : 1.0;
    constexpr double kAngleSteps = (1 << (kAngleBits - 1)) - 1;
    const auto angle = static_cast<std::uint64_t>((1.0 - cosine) * kAngleSteps);
    const auto distance_fx = static_cast<std::uint64_t>(distance / 2 * (1 << kRestBits));
    const std::uint64_t rest = distance_fx & ((1 << kRestBits) - 1);
    return ((distance_fx >> kRestBits) << kAngleBits | angle) << kRestBits | rest;
  }
  /// The ring of a rank.
  [[nodiscard]] static std::uint64_t ring_of(std::uint64_t rank) { return rank >> (kAngleBits + kRestBits); }

 private:
  // Bits of a rank, below the ring's.
  static constexpr int kAngleBits = 16;
  static constexpr int kRestBits = 8;

  glm::i64vec3 centre_{};
  glm::dvec3 direction_{};
};

}  // namespace talus
