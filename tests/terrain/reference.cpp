#include "reference.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include <talus/terrain/lattice_hash.h>
#include <talus/terrain/strata.h>

namespace talus::test::reference {
namespace {

using terrain::Axis;

double corner(std::uint64_t seed, std::int64_t cell_x, std::int64_t cell_z, double dx, double dz) {
  const std::uint32_t hash = terrain::corner_hash(terrain::axis_hash(seed, Axis::x, cell_x),
                                                  terrain::axis_hash(seed, Axis::z, cell_z));
  const double angle = (static_cast<double>(hash >> 28) + 0.5) * std::numbers::pi / 8;
  return std::numbers::sqrt2 * (std::cos(angle) * dx + std::sin(angle) * dz);
}

double fade(double t) {
  return t * t * t * (t * (t * 6 - 15) + 10);
}

std::int64_t offset_of(std::uint64_t octave_seed, Axis axis, std::int64_t period) {
  const std::uint64_t draw = terrain::derived_seed(octave_seed, static_cast<std::uint64_t>(axis)) >> 32;
  return static_cast<std::int64_t>((draw * static_cast<std::uint64_t>(period)) >> 32);
}

// One octave at a lattice position and a part of a column past it, between -1 and 1.
double octave(const terrain::Fbm& noise, int k, std::int64_t x, std::int64_t z, double past_x = 0,
              double past_z = 0) {
  const std::uint64_t seed = terrain::derived_seed(noise.seed, static_cast<std::uint64_t>(k));
  const std::int64_t px = x * (std::int64_t{1} << k) + offset_of(seed, Axis::x, noise.period);
  const std::int64_t pz = z * (std::int64_t{1} << k) + offset_of(seed, Axis::z, noise.period);
  const auto period = static_cast<double>(noise.period);
  double u = (static_cast<double>(floor_mod(px, noise.period)) + past_x * std::pow(2.0, k)) / period;
  double v = (static_cast<double>(floor_mod(pz, noise.period)) + past_z * std::pow(2.0, k)) / period;
  const std::int64_t cx = floor_div(px, noise.period) + static_cast<std::int64_t>(std::floor(u));
  const std::int64_t cz = floor_div(pz, noise.period) + static_cast<std::int64_t>(std::floor(v));
  u -= std::floor(u);
  v -= std::floor(v);
  const double north = std::lerp(corner(seed, cx, cz, u, v), corner(seed, cx + 1, cz, u - 1, v), fade(u));
  const double south =
      std::lerp(corner(seed, cx, cz + 1, u, v - 1), corner(seed, cx + 1, cz + 1, u - 1, v - 1), fade(u));
  return std::lerp(north, south, fade(v));
}

}  // namespace

double fbm(const terrain::Fbm& noise, std::int64_t x, std::int64_t z, double past_x, double past_z) {
  double sum = 0;
  double all = 0;
  for (int k = 0; k < noise.octaves; ++k) {
    const double weight = std::pow(0.5, k);
    all += weight;
    if (noise.period < (std::int64_t{2} << k)) continue;
    sum += weight * octave(noise, k, x, z, past_x, past_z);
  }
  return sum / all;
}

double ridges(const terrain::Fbm& noise, double feedback, std::int64_t x, std::int64_t z) {
  double sum = 0;
  double all = 0;
  double shown = 1;
  for (int k = 0; k < noise.octaves; ++k) {
    const double weight = std::pow(0.5, k);
    all += weight;
    if (noise.period < (std::int64_t{2} << k)) continue;
    const double signal = std::pow(1 - std::abs(octave(noise, k, x, z)), 2) * shown;
    sum += weight * signal;
    shown = std::min(feedback * signal, 1.0);
  }
  return sum / all - 0.5;
}

double warped(const terrain::Surface& surface, std::int64_t x, std::int64_t z) {
  const double reach = static_cast<double>(surface.warp.reach_fx) / 256;
  return fbm(surface.noise, x, z, reach * fbm(surface.warp.east, x, z),
             reach * fbm(surface.warp.south, x, z));
}

double catmull_rom(double before, double at, double after, double last, double t) {
  return 0.5 * (2 * at + t * (after - before) + t * t * (2 * before - 5 * at + 4 * after - last) +
                t * t * t * (3 * at - before - 3 * after + last));
}

double height_map(const terrain::PlacedMap& map, std::int64_t x, std::int64_t z) {
  const terrain::Field& heights = *map.heights_fx;
  const auto mirrored = [](std::int64_t i, int n) {
    while (i < 0 || i >= n) i = i < 0 ? -i : 2 * (std::int64_t{n} - 1) - i;
    return static_cast<int>(i);
  };
  const auto sample = [&](std::int64_t i, std::int64_t j) -> double {
    const bool inside = i >= 0 && j >= 0 && i < heights.width && j < heights.depth;
    if (!inside && map.outside == terrain::Outside::sea) return 0;
    if (map.outside == terrain::Outside::repeat) {
      return heights.at(static_cast<int>(floor_mod(i, std::int64_t{heights.width})),
                        static_cast<int>(floor_mod(j, std::int64_t{heights.depth})));
    }
    return heights.at(mirrored(i, heights.width), mirrored(j, heights.depth));
  };
  // Whole samples in integers, so that the parts of one are as good far out as at the origin.
  const std::int64_t from_x = x * 65536 - map.x_q16;
  const std::int64_t from_z = z * 65536 - map.z_q16;
  const std::int64_t i = floor_div(from_x, map.spacing_x_q16);
  const std::int64_t j = floor_div(from_z, map.spacing_z_q16);
  const double u =
      static_cast<double>(floor_mod(from_x, map.spacing_x_q16)) / static_cast<double>(map.spacing_x_q16);
  const double v =
      static_cast<double>(floor_mod(from_z, map.spacing_z_q16)) / static_cast<double>(map.spacing_z_q16);
  const auto along = [&](std::int64_t row) {
    return catmull_rom(sample(i - 1, row), sample(i, row), sample(i + 1, row), sample(i + 2, row), u);
  };
  return catmull_rom(along(j - 1), along(j), along(j + 1), along(j + 2), v);
}

double surface_fx(const terrain::WorldSpec& spec, double noise) {
  const double level = std::clamp(0.5 + spec.surface.gain * noise, 0.0, 1.0);
  return std::pow(level, spec.surface.exponent) * spec.surface.amplitude * spec.resolution * 256;
}

std::int32_t slope(const terrain::Field& heights, int x, int z) {
  std::int32_t greatest = 0;
  for (int dz = -1; dz <= 1; ++dz) {
    for (int dx = -1; dx <= 1; ++dx) {
      greatest = std::max(greatest, std::abs(heights.at(x, z) - heights.at(x + dx, z + dz)));
    }
  }
  return greatest;
}

void remove_until_stable(terrain::Field& thickness, std::int32_t repose_fx) {
  bool moved = true;
  while (moved) {
    moved = false;
    for (int z = 0; z < thickness.depth; ++z) {
      for (int x = 0; x < thickness.width; ++x) {
        for (int nz = std::max(z - 1, 0); nz <= std::min(z + 1, thickness.depth - 1); ++nz) {
          for (int nx = std::max(x - 1, 0); nx <= std::min(x + 1, thickness.width - 1); ++nx) {
            const std::int32_t stable = thickness.at(nx, nz) + repose_fx;
            if (thickness.at(x, z) <= stable) continue;
            thickness.at(x, z) = stable;
            moved = true;
          }
        }
      }
    }
  }
}

Stack strata(const terrain::World& world, std::int64_t x, std::int64_t z, std::int32_t height_fx) {
  Stack stack;
  std::int64_t top = 0;
  const auto& sequence = world.strata();
  for (std::size_t j = 0; j < sequence.size(); ++j) {
    float noise = 0;
    terrain::sample_fbm(terrain::layer_noise(world.spec(), sequence[j].roughness, j), {&x, 1}, {&z, 1},
                        {&noise, 1});
    const auto mean_fx = static_cast<float>(static_cast<double>(sequence[j].thickness_q16) / 65536 *
                                            world.spec().resolution * 256);
    const float swell = std::max(0.0F, 1.0F + static_cast<float>(2 * sequence[j].roughness) * noise);
    top += std::lrintf(mean_fx * swell);
    const bool fills = j + 1 == sequence.size();
    const auto cut = static_cast<std::int32_t>(fills ? height_fx : std::min<std::int64_t>(top, height_fx));
    if (!stack.empty() && stack.back().material == sequence[j].material) {
      stack.back().top_fx = cut;
    } else {
      stack.push_back({sequence[j].material, cut});
    }
  }
  return stack;
}

Stack insert(const terrain::World& world, const Stack& stack, const std::vector<std::int32_t>& thickness) {
  const std::int32_t height = stack.back().top_fx;
  // Pile the loose materials in the air, heaviest first, then sink the pile until its top is the surface.
  std::vector<std::size_t> order;
  for (std::size_t m = 0; m < thickness.size(); ++m) {
    std::size_t at = 0;
    while (at < order.size() && world.loose()[order[at]].weight > world.loose()[m].weight) ++at;
    order.insert(order.begin() + static_cast<std::ptrdiff_t>(at), m);  // before those of equal weight: lower
  }
  // Of equal weight the first of the spec lies on top, so later ones go below: as inserted above.
  Stack pile;
  std::int32_t sum = 0;
  for (const std::size_t m : order) pile.push_back({world.loose()[m].material, sum += thickness[m]});
  const std::int32_t sink = height - sum;
  Stack all;
  for (const Layer& layer : stack) all.push_back({layer.material, std::min(layer.top_fx, std::max(0, sink))});
  for (const Layer& layer : pile) all.push_back({layer.material, std::max(0, layer.top_fx + sink)});
  return all;
}

void erode_step(const std::vector<terrain::LooseRules>& rules, terrain::Neighbours neighbours,
                terrain::LooseGround& ground) {
  struct Pipe {
    std::size_t material;
    int x;
    int z;
    std::int32_t amount;
  };
  std::vector<Pipe> pipes;
  const int width = ground.base.width;
  const int depth = ground.base.depth;
  const auto height = [&ground](std::size_t material, int x, int z) {
    std::int32_t sum = ground.base.at(x, z);
    for (std::size_t m = 0; m <= material; ++m) sum += ground.thickness[m].at(x, z);
    return sum;
  };
  for (std::size_t m = rules.size(); m-- > 0;) {
    for (int i = width * depth - 1; i >= 0; --i) {
      const int x = i % width;
      const int z = i / width;
      std::vector<Pipe> lower;  // `amount` is how much
      std::int64_t sum = 0;
      for (int dz = -1; dz <= 1; ++dz) {
        for (int dx = -1; dx <= 1; ++dx) {
          if (dx == 0 && dz == 0) continue;
          const bool straight = dx == 0 || dz == 0;
          if (neighbours == terrain::Neighbours::von_neumann && !straight) continue;
          if (neighbours == terrain::Neighbours::diagonal && straight) continue;
          if (x + dx < 0 || x + dx >= width || z + dz < 0 || z + dz >= depth) continue;
          const std::int32_t drop = height(m, x, z) - height(m, x + dx, z + dz);
          if (drop <= rules[m].c_fx) continue;
          lower.push_back({m, x + dx, z + dz, drop});
          sum += drop;
        }
      }
      const std::int32_t step = std::min(std::max(1, rules[m].c_fx / 8), ground.thickness[m].at(x, z));
      if (lower.empty() || step == 0) continue;
      std::int32_t left = step;
      std::size_t steepest = 0;
      for (std::size_t k = 0; k < lower.size(); ++k) {
        if (lower[k].amount > lower[steepest].amount) steepest = k;
      }
      for (Pipe& pipe : lower) {
        pipe.amount = static_cast<std::int32_t>(std::int64_t{step} * pipe.amount / sum);
        left -= pipe.amount;
      }
      lower[steepest].amount += left;
      pipes.insert(pipes.end(), lower.begin(), lower.end());
      pipes.push_back({m, x, z, -step});
    }
  }
  for (const Pipe& pipe : pipes) ground.thickness[pipe.material].at(pipe.x, pipe.z) += pipe.amount;
}

MaterialId voxel(const terrain::World& world, const Stack& stack, std::int64_t y, Lod lod) {
  const std::int64_t centre = 256 * y + 128;
  const std::int32_t height = stack.back().top_fx;
  if (centre >= height) {
    const bool wet = world.sea_fx() && centre < (*world.sea_fx() >> lod.value());
    return wet ? kWater : kAir;
  }
  const bool topmost = centre + 256 >= height;
  if (lod.value() > 0 && topmost) {
    for (std::size_t k = stack.size(); k-- > 0;) {
      if (stack[k].top_fx > (k == 0 ? 0 : stack[k - 1].top_fx)) return stack[k].material;
    }
  }
  if (centre < 0) return stack.front().material;
  for (const Layer& layer : stack) {
    if (centre < layer.top_fx) return layer.material;
  }
  std::abort();
}

}  // namespace talus::test::reference
