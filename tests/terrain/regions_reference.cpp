#include "regions_reference.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <talus/voxel/coords.h>

namespace talus::terrain::test::reference {
namespace {

using Values = std::array<float, kSlowCount>;

float& of(Values& values, Slow slow) {
  return values[static_cast<std::size_t>(slow)];
}

float unit(float v) {
  return std::min(std::max(v, 0.0F), 1.0F);
}
float ramp(float a, float b, float v) {
  return unit((v - a) * (1 / (b - a)));
}
float s_curve(float t) {
  return t * t * (3 - 2 * t);
}

struct WarpOffset {
  std::int32_t east = 0;
  std::int32_t south = 0;
  float east_by_x = 0;  // how the displacements grow a column
  float east_by_z = 0;
  float south_by_x = 0;
  float south_by_z = 0;
};

WarpOffset warp_at(const SlowFields& fields, std::int64_t x, std::int64_t z) {
  const auto along = [&](const std::array<RotatedNoise, 2>& noise, std::int32_t& far, float& by_x,
                         float& by_z) {
    const SlopedNoise wide = sloped_rotated_fbm(noise[0], x, z);
    const SlopedNoise narrow = sloped_rotated_fbm(noise[1], x, z);
    const auto sum = [&](float w, float n) { return fields.warp_reach[0] * w + fields.warp_reach[1] * n; };
    far = static_cast<std::int32_t>(std::lrint(sum(wide.value, narrow.value)));
    by_x = sum(wide.east, narrow.east) / 256;
    by_z = sum(wide.south, narrow.south) / 256;
  };
  WarpOffset warp;
  along(fields.warp_east, warp.east, warp.east_by_x, warp.east_by_z);
  along(fields.warp_south, warp.south, warp.south_by_x, warp.south_by_z);
  return warp;
}

Values sample(const Regions& regions, std::int64_t x, std::int64_t z) {
  const SlowFields& f = regions.slow;
  const WarpOffset warp = warp_at(f, x, z);
  const auto field = [&](const SlowFields::Field& of) {
    return of.equalized(of.warped ? rotated_fbm(of.noise, x, z, warp.east, warp.south)
                                  : rotated_fbm(of.noise, x, z));
  };
  const float c = field(f.continents);
  const float r = std::abs(field(f.ranges));
  const float e = field(f.hilliness);
  const float t = std::clamp(0.75F * field(f.temperature) + 0.3F + f.warmer, -1.0F, 1.2F);
  const float m = std::clamp(field(f.moisture) + f.wetter, -1.0F, 1.0F);
  const float inland = f.inland(c);
  const float belt = f.belt(r) * inland * f.passes(e);
  const float mesa = std::max(f.mesas_anywhere, ramp(0.05F, -0.3F, m) * ramp(-0.1F, 0.15F, t)) *
                     (1 - 0.85F * s_curve(unit(2 * belt))) * ramp(f.mesa_coast[0], f.mesa_coast[1], c);
  Values values{};
  of(values, Slow::base) = f.base(c);
  of(values, Slow::belt) = belt;
  of(values, Slow::hills) = f.hills(e) * (0.12F + 0.88F * inland) * (1 - 0.55F * mesa) * (1 - 0.5F * belt);
  of(values, Slow::mesa) = mesa;
  of(values, Slow::terrace) = field(f.mesas);
  of(values, Slow::temperature) = t;
  of(values, Slow::moisture) = m;
  for (std::size_t river = 0; river < 3; ++river) {
    const SlopedNoise noise = sloped_rotated_fbm(f.rivers[river], x, z, warp.east, warp.south);
    const float n = noise.value;
    const float gx = noise.east * (1 + warp.east_by_x) + noise.south * warp.south_by_x;
    const float gz = noise.east * warp.east_by_z + noise.south * (1 + warp.south_by_z);
    const float kappa = f.saddle[river == 0 ? 0 : 1];
    const float d = n / std::sqrt(gx * gx + gz * gz + kappa * std::abs(n) + 1e-14F) * f.units_a_column;
    values[static_cast<std::size_t>(Slow::river) + river] = std::clamp(d, -1000.0F, 1000.0F);
  }
  for (int k = 0; k < kSlowOctaves; ++k) {
    const std::uint64_t seed = derived_seed(regions.shape.seed, static_cast<std::uint64_t>(k));
    const RotatedLattice lattice = rotated_lattice(seed, regions.shape.period, k, regions.shape.turn);
    const auto east = static_cast<std::uint64_t>(static_cast<std::int64_t>(warp.east >> 1));
    const auto south = static_cast<std::uint64_t>(static_cast<std::int64_t>(warp.south >> 1));
    const auto by = [](std::uint64_t sum) {
      return static_cast<std::uint64_t>(static_cast<std::int64_t>(sum) >> 8);
    };
    values[static_cast<std::size_t>(Slow::shape_0) + static_cast<std::size_t>(k)] =
        rotated_sample(lattice, lattice.u(x, z) + by(lattice.du * east + lattice.dv * south),
                       lattice.v(x, z) + by(lattice.du * south - lattice.dv * east))
            .value;
  }
  return values;
}

using Four = std::array<float, 4>;

/// How much of each of four samples in a row lies at t, of the way from the second to the third.
Four catmull_rom(float t) {
  return {((2 - t) * t - 1) * t * 0.5F, ((3 * t - 5) * t * t + 2) * 0.5F, ((4 - 3 * t) * t + 1) * t * 0.5F,
          (t - 1) * t * t * 0.5F};
}

Values between(const Regions& regions, std::int64_t x, std::int64_t z) {
  const std::int64_t west = floor_div(x, 16) * 16;
  const std::int64_t north = floor_div(z, 16) * 16;
  const float t = static_cast<float>(x - west) / 16;
  const Four shares = catmull_rom(static_cast<float>(z - north) / 16);
  std::array<std::array<Values, 4>, 4> samples;
  for (std::size_t j = 0; j < 4; ++j) {
    for (std::size_t i = 0; i < 4; ++i) {
      samples[j][i] = sample(regions, west + (static_cast<std::int64_t>(i) - 1) * 16,
                             north + (static_cast<std::int64_t>(j) - 1) * 16);
    }
  }
  Values values{};
  for (std::size_t k = 0; k < kSlowCount; ++k) {
    Four p{};
    for (std::size_t i = 0; i < 4; ++i) {
      p[i] = samples[0][i][k] * shares[0] + samples[1][i][k] * shares[1] + samples[2][i][k] * shares[2] +
             samples[3][i][k] * shares[3];
    }
    const float c1 = 0.5F * (p[2] - p[0]);
    const float c3 = 0.5F * (p[3] - p[0]) + 1.5F * (p[1] - p[2]);
    const float c2 = p[2] - p[1] - c1 - c3;
    values[k] = p[1] + t * (c1 + t * (c2 + t * c3));
  }
  return values;
}

float valley(float d, float w, float v) {
  const float t = unit((d - w) / (v - w));
  return 0.72F * s_curve(t) + 0.28F * (t * t);
}

}  // namespace

std::int32_t region_height_fx(const Regions& regions, float highest_fx, std::int64_t x, std::int64_t z) {
  Values v = between(regions, x, z);
  const RegionShape& p = regions.at_columns;
  const float B = of(v, Slow::base);
  const float G = unit(of(v, Slow::belt));
  const float A = of(v, Slow::hills);
  float ridge = 0;
  float fbm = 0;
  float small = 0;
  float shown = 1;
  for (int k = 0; k < kShapeOctaves; ++k) {
    const auto i = static_cast<std::size_t>(k);
    float n = 0;
    if (k < kSlowOctaves) {
      n = v[static_cast<std::size_t>(Slow::shape_0) + i];
    } else {
      const std::uint64_t seed = derived_seed(regions.shape.seed, i);
      const RotatedLattice lattice = rotated_lattice(seed, regions.shape.period, k, regions.shape.turn);
      n = rotated_sample(lattice, lattice.u(x, z), lattice.v(x, z)).value;
    }
    const float inside = std::max(0.0F, 0.045F - std::abs(n));
    const float distance = std::abs(n) + inside * inside * (0.5F / 0.045F);
    const float s = std::max(0.0F, 1 - 1.8F * distance);
    const float signal = s * s * shown;
    ridge += p.ridge_weights[i] * signal;
    shown = std::min(1.0F, 0.3F + 1.1F * signal);
    if (k >= 1) fbm += p.hill_weights[i] * n;
    if (k >= 3) small += p.small_weights[i] * n;
  }
  const float filled = unit(0.5F + 0.45F * fbm);
  const float hill = filled * std::sqrt(filled);
  const float r0 = std::max(0.0F, p.ridge_scale * ridge - 0.1F);
  const float over = std::max(0.0F, r0 - 0.9F);
  const float R = std::min(r0, 0.9F) + over / (1 + 3 * over);

  const float bs = B + p.range_base * s_curve(G);
  const float above = std::max(0.0F, bs - p.carve[0]);
  const float up = above * above / (above + 20);
  const float kb = 1.2F + up;
  const float low = p.carve[1];
  const float a1 = 0.45F + 0.55F * ramp(low + 90, low + 30, bs);
  const float a2 = ramp(low + 28, low, bs + 0.3F * A);
  const float wide = 0.8F + 0.8F * ramp(24, 3, B);
  const float high = p.carve[0];
  const float w1 = p.half_width[0] * (wide * (0.25F + 0.75F * ramp(high + 12, high - 28, bs)));
  const float w2 = p.half_width[1] * (wide * (0.25F + 0.75F * ramp(low + 12, low - 16, bs + 0.3F * A)));
  const float shallow = 1 - 0.7F * ramp(0.5F, 6, up);
  const float dp1 = std::min(p.bed + 1.2F, w1 / 2) * shallow;
  const float dp2 = std::min(0.8F * p.bed + 1.2F, w2 / 2) * shallow;
  const float d1 = of(v, Slow::river);
  const float d2 = d1 > 0 ? of(v, Slow::tributary_a) : of(v, Slow::tributary_b);
  const float D1 = std::abs(d1);
  const float D2 = std::abs(d2);
  const float s1 = 1 - a1 * (1 - valley(D1, w1, p.valley[0] + G * 150));
  const float s2 = 1 - a2 * (1 - valley(D2, w2, p.valley[1] + G * 120));
  const float s = s1 * s2;
  const float b1 = a1 * dp1 * s_curve(unit(1 - D1 / w1));
  const float b2 = a2 * dp2 * s_curve(unit(1 - D2 / w2));
  const float field = of(v, Slow::terrace) + p.mesa_roughness * small - 0.6F * (1 - unit(1.15F * s)) + 0.1F;
  const float mesa =
      std::max(0.0F, of(v, Slow::mesa)) * p.mesa_height * p.terraces(field) * s_curve(unit(4 * s));
  const float hm = bs + A * hill + G * p.range_relief * R;
  float h = hm > kb ? kb + (hm - kb) * s : hm;
  h = h + mesa - std::max(b1, b2) * ramp(-9, -1, hm);
  h = h * (0.3F + 0.7F * s_curve(unit(std::abs(h) * (1.0F / 7))));
  const float fx = std::min(std::max(1.0F, h + p.sea_level) * p.subvoxels_a_unit, highest_fx);
  return static_cast<std::int32_t>(std::lrint(fx));
}

}  // namespace talus::terrain::test::reference
