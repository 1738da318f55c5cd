#include "noise/rotated_lattice.h"

#include <array>

#include "noise/lattice_place.h"

namespace talus::terrain {
namespace {

struct Angle {
  std::int64_t cosine = 0;  // in 2^-30
  std::int64_t sine = 0;
};
// 16, 25, 34, 43, 52, 61, 70 and 79 degrees.
constexpr std::array<Angle, kLatticeAngles> kLatticeDirections{{{1032146887, 295963357},
                                                                {973140576, 453782903},
                                                                {890172315, 600428808},
                                                                {785285058, 732290163},
                                                                {661061475, 846120104},
                                                                {520560366, 939115760},
                                                                {367241333, 1008987269},
                                                                {204879599, 1054014162}}};

float odd_number(std::uint32_t bits, int count) {
  return static_cast<float>((static_cast<std::int32_t>(bits) >> (32 - count)) | 1);
}

struct Corner {
  float along_u = 0;
  float along_v = 0;
  float value = 0;

  [[nodiscard]] float toward(float du, float dv) const { return (along_u * du + along_v * dv) + value; }
};

Corner corner(std::uint32_t u_hash, std::uint32_t v_hash) {
  const std::uint32_t hash = corner_hash(u_hash, v_hash);
  return {odd_number(hash, 11) * kGradientUnit, odd_number(hash << 11, 11) * kGradientUnit,
          (odd_number(hash << 22, 5) + odd_number(hash << 27, 5)) * kValueUnit};
}

float inside_of(std::uint64_t position) {
  return static_cast<float>(static_cast<std::uint32_t>(position) >> 8) * (1.0F / 16777216.0F);
}

}  // namespace

RotatedLattice rotated_lattice(std::uint64_t octave_seed, std::int64_t period, int k, int turn) {
  const Angle& angle = kLatticeDirections[static_cast<std::size_t>((turn + 5 * k) % kLatticeAngles)];
  const auto cells = [&](std::int64_t share) {
    return static_cast<std::uint64_t>(((share << (2 + k)) + period / 2) / period);
  };
  const std::uint64_t salts = derived_seed(octave_seed, 2);
  return {cells(angle.cosine),
          cells(angle.sine),
          derived_seed(octave_seed, 0),
          derived_seed(octave_seed, 1),
          static_cast<std::uint32_t>(salts),
          static_cast<std::uint32_t>(salts >> 32)};
}

RotatedSample rotated_sample(const RotatedLattice& lattice, std::uint64_t u, std::uint64_t v) {
  const std::uint32_t u_key = static_cast<std::uint32_t>(u >> 32) * kRotatedCellStep + lattice.u_salt;
  const std::uint32_t v_key = static_cast<std::uint32_t>(v >> 32) * kRotatedCellStep + lattice.v_salt;
  const std::uint32_t u_0 = mix32(u_key);
  const std::uint32_t u_1 = mix32(u_key + kRotatedCellStep);
  const std::uint32_t v_0 = mix32(v_key);
  const std::uint32_t v_1 = mix32(v_key + kRotatedCellStep);
  const Corner c00 = corner(u_0, v_0);
  const Corner c10 = corner(u_1, v_0);
  const Corner c01 = corner(u_0, v_1);
  const Corner c11 = corner(u_1, v_1);
  const float du = inside_of(u);
  const float dv = inside_of(v);
  const float back_u = du - 1.0F;
  const float back_v = dv - 1.0F;
  const float a00 = c00.toward(du, dv);
  const float a10 = c10.toward(back_u, dv);
  const float a01 = c01.toward(du, back_v);
  const float a11 = c11.toward(back_u, back_v);
  const float faded_u = fade(du);
  const float faded_v = fade(dv);
  const float on_0 = lerp(a00, a10, faded_u);
  const float on_1 = lerp(a01, a11, faded_u);
  const float rise_u = fade_slope(du);
  const float along_0 = lerp(c00.along_u, c10.along_u, faded_u) + rise_u * (a10 - a00);
  const float along_1 = lerp(c01.along_u, c11.along_u, faded_u) + rise_u * (a11 - a01);
  const float across =
      lerp(lerp(c00.along_v, c10.along_v, faded_u), lerp(c01.along_v, c11.along_v, faded_u), faded_v);
  return {lerp(on_0, on_1, faded_v), lerp(along_0, along_1, faded_v),
          across + fade_slope(dv) * (on_1 - on_0)};
}

}  // namespace talus::terrain
