#include "features/ore_bodies.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>

#include <talus/terrain/lattice_hash.h>
#include <talus/voxel/coords.h>

namespace talus::terrain {
namespace {

constexpr std::int64_t kOne_q15 = 1 << 15;

// Sixteen directions of an axis, as 2^14 times their cosine; the sine is the cosine of eight steps before.
constexpr std::array<std::int32_t, 8> kCosine_q14{16384, 16069, 15137, 13623, 11585, 9102, 6270, 3196};

std::int64_t cosine_q14(int sixteenth) {
  const int turn = sixteenth & 15;
  return turn < 8    ? kCosine_q14[static_cast<std::size_t>(turn)]
         : turn == 8 ? 0
                     : -kCosine_q14[static_cast<std::size_t>(16 - turn)];
}

std::int64_t sine_q14(int sixteenth) {
  const int turn = sixteenth & 15;
  return turn == 0 ? 0 : turn < 8 ? kCosine_q14[static_cast<std::size_t>(8 - turn)] : cosine_q14(turn - 8);
}

// A sequence of random numbers for a body, from the hash of its cube. Never draw two in one expression: C++
// leaves the order of operands and arguments open.
class Draws {
 public:
  explicit Draws(std::uint64_t seed) : seed_{seed} {}
  // Returns `least` to `most` - 1.
  std::int64_t between(std::int64_t least, std::int64_t most) {
    const std::uint64_t draw = derived_seed(seed_, ++count_) >> 32;
    return least + static_cast<std::int64_t>((draw * static_cast<std::uint64_t>(most - least)) >> 32);
  }
  // Returns `least` to `most` percent of a length.
  std::int32_t part(std::int64_t length, std::int64_t least, std::int64_t most) {
    return static_cast<std::int32_t>(length * between(least, most + 1) / 100);
  }
  // Returns a steep tilt to either side.
  std::int64_t tilt_q12() {
    const std::int64_t steepness_q12 = between(1024, 7000);
    return between(0, 2) == 0 ? -steepness_q12 : steepness_q12;
  }

 private:
  std::uint64_t seed_;
  std::uint64_t count_ = 0;
};

struct Middle {
  std::int64_t x_fx = 0;
  std::int64_t y_fx = 0;
  std::int64_t z_fx = 0;
};

void set_axes(OreLobe& lobe, int sixteenth, std::int32_t along_fx, std::int32_t across_fx) {
  lobe.cos_q14 = cosine_q14(sixteenth);
  lobe.sin_q14 = sine_q14(sixteenth);
  lobe.per_along_q40 = (std::int64_t{1} << 40) / std::max(along_fx, 64);
  lobe.per_across_q40 = (std::int64_t{1} << 40) / std::max(across_fx, 64);
  lobe.reach_fx = along_fx;
}

// Adds a lump with up to three others that stick out of it.
void add_pocket(const Middle& middle, OreLobe lobe, std::int32_t radius_fx, Draws& draws,
                std::vector<OreLobe>& lobes) {
  const std::int32_t size_fx = draws.part(radius_fx, 60, 100);
  lobe.ragged_q15 = kOne_q15 * 2 / 5;
  lobe.sway_fx = size_fx / 16;
  for (int i = 0; i < 4; ++i) {
    const std::int32_t along_fx = i == 0 ? draws.part(size_fx, 60, 75) : draws.part(size_fx, 32, 50);
    const std::int32_t away_fx = i == 0 ? 0 : size_fx - along_fx;
    const auto sixteenth = static_cast<int>(draws.between(0, 16));
    const std::int64_t side = draws.between(0, 2) * 2 - 1;
    const auto up_fx = static_cast<std::int32_t>(i == 0 ? 0 : draws.part(away_fx, -60, 60));
    lobe.x_fx = middle.x_fx + side * away_fx * cosine_q14(sixteenth) / 20480;
    lobe.z_fx = middle.z_fx + side * away_fx * sine_q14(sixteenth) / 20480;
    lobe.y_fx = static_cast<std::int32_t>(middle.y_fx + up_fx);
    const std::int32_t across_fx = draws.part(along_fx, 70, 100);
    set_axes(lobe, static_cast<int>(draws.between(0, 16)), along_fx, across_fx);
    lobe.half_fx = draws.part(along_fx, 45, 75);
    lobe.tilt_along_q12 = draws.between(-1024, 1024);
    lobe.tilt_across_q12 = draws.between(-1024, 1024);
    lobe.rise_fx = std::min(along_fx, radius_fx - std::abs(up_fx));
    lobes.push_back(lobe);
  }
}

// The vertical thickness of a tilted sheet: about sqrt(1 + tilt^2) times its thickness.
std::int32_t upright(std::int32_t thickness_fx, std::int64_t tilt_q12) {
  const std::int64_t tilt = std::abs(tilt_q12);
  return static_cast<std::int32_t>(
      thickness_fx * (std::max<std::int64_t>(4096, tilt) + std::min<std::int64_t>(4096, tilt) * 2 / 5) >> 12);
}

// Adds a long tilted sheet, and three narrower ones that leave it at an angle.
void add_vein(const Middle& middle, OreLobe lobe, std::int32_t radius_fx, std::int32_t thickness_fx,
              Draws& draws, std::vector<OreLobe>& lobes) {
  const std::int32_t along_fx = draws.part(radius_fx, 75, 98);
  const std::int32_t across_fx = draws.part(along_fx, 30, 45);
  const auto sixteenth = static_cast<int>(draws.between(0, 16));
  lobe.ragged_q15 = kOne_q15 / 2;
  lobe.sway_fx = radius_fx / 10;
  lobe.x_fx = middle.x_fx;
  lobe.z_fx = middle.z_fx;
  lobe.y_fx = static_cast<std::int32_t>(middle.y_fx);
  set_axes(lobe, sixteenth, along_fx, across_fx);
  lobe.tilt_along_q12 = draws.between(-2048, 2049);
  lobe.tilt_across_q12 = draws.tilt_q12();
  lobe.half_fx = upright(thickness_fx, lobe.tilt_across_q12) / 2;
  lobe.rise_fx = radius_fx;
  lobes.push_back(lobe);

  const OreLobe main = lobe;
  for (int i = 0; i < 3; ++i) {
    const std::int64_t a_fx = draws.part(along_fx, -55, 55);
    const std::int64_t c_fx = draws.part(across_fx, -30, 30);
    const std::int64_t up_fx = (a_fx * main.tilt_along_q12 + c_fx * main.tilt_across_q12) >> 12;
    lobe.x_fx = middle.x_fx + ((a_fx * main.cos_q14 - c_fx * main.sin_q14) >> 14);
    lobe.z_fx = middle.z_fx + ((a_fx * main.sin_q14 + c_fx * main.cos_q14) >> 14);
    lobe.y_fx = static_cast<std::int32_t>(middle.y_fx + up_fx);
    const std::int32_t branch_fx = draws.part(along_fx, 28, 40);
    const std::int32_t branch_across_fx = draws.part(branch_fx, 30, 50);
    set_axes(lobe, sixteenth + static_cast<int>(draws.between(3, 14)), branch_fx, branch_across_fx);
    lobe.tilt_along_q12 = draws.between(-3000, 3001);
    lobe.tilt_across_q12 = draws.tilt_q12();
    lobe.half_fx = upright(draws.part(thickness_fx, 60, 85), lobe.tilt_across_q12) / 2;
    lobe.rise_fx = std::max(0, radius_fx - static_cast<std::int32_t>(std::abs(up_fx)));
    lobes.push_back(lobe);
  }
}

void add_body(const OreKind& kind, const Middle& middle, std::uint64_t seed, std::vector<OreLobe>& lobes) {
  OreLobe lobe;
  lobe.seed = seed;
  // About five grains along a body.
  lobe.grain_bits = static_cast<int>(std::bit_width(static_cast<std::uint32_t>(kind.size_fx) / 5U)) - 1;
  Draws draws{seed};
  if (kind.shape == OreShape::pocket) {
    add_pocket(middle, lobe, kind.size_fx / 2, draws, lobes);
  } else {
    add_vein(middle, lobe, kind.size_fx / 2, kind.thickness_fx, draws, lobes);
  }
}

// Returns true if the surroundings of `middle`, within the reaches, intersect the box.
bool meets(const OreBox& box, const Middle& middle, std::int64_t reach_fx, std::int64_t rise_fx) {
  const auto apart = [](std::int64_t at, std::int64_t reach, std::int64_t first, std::int64_t end) {
    return at + reach < first || at - reach >= end;
  };
  return !apart(middle.x_fx, reach_fx, box.x0 * kSubvoxels, box.x1 * kSubvoxels) &&
         !apart(middle.z_fx, reach_fx, box.z0 * kSubvoxels, box.z1 * kSubvoxels) &&
         !apart(middle.y_fx, rise_fx, box.low_fx, box.high_fx);
}

bool meets(const OreBox& box, const OreLobe& lobe) {
  return meets(box, {lobe.x_fx, lobe.y_fx, lobe.z_fx}, lobe.reach_fx, lobe.rise_fx);
}

std::int64_t place_in_grain_q15(const OreLobe& lobe, std::int64_t place_fx) {
  return ((place_fx & ((std::int64_t{1} << lobe.grain_bits) - 1)) << 15) >> lobe.grain_bits;
}

// Blends smoothly from one grain to the next.
std::int64_t weight_q15(std::int64_t t_q15) {
  return (t_q15 * t_q15 >> 15) * (3 * kOne_q15 - 2 * t_q15) >> 15;
}

// The root of a kind's draws, from which each coordinate of a cube derives a child.
class PublicDraw {
 public:
  explicit PublicDraw(std::uint64_t seed) : seed_{seed} {}
  [[nodiscard]] PublicDraw child(std::int64_t index) const {
    return PublicDraw{derived_seed(seed_, static_cast<std::uint64_t>(index))};
  }
  [[nodiscard]] std::uint64_t value() const { return seed_; }

 private:
  std::uint64_t seed_;
};

class SecretDraw {
 public:
  explicit SecretDraw(const SipHash& hash) : hash_{hash} {}
  [[nodiscard]] SecretDraw child(std::int64_t index) const {
    return SecretDraw{hash_.with(static_cast<std::uint64_t>(index))};
  }
  [[nodiscard]] std::uint64_t value() const { return hash_.value(); }

 private:
  SipHash hash_;
};

template <typename Draw>
void add_bodies(const OreKind& kind, const OreBox& box, const Draw& draw, std::vector<OreLobe>& lobes) {
  const std::int64_t edge = kind.size_fx;
  const std::int64_t reach = kind.size_fx / 2;
  const auto first = [&](std::int64_t from_fx) { return floor_div(from_fx - reach, edge); };
  const auto last = [&](std::int64_t end_fx) { return floor_div(end_fx - 1 + reach, edge); };
  // Bodies that would exceed their range of heights are omitted, so that no body is cut.
  const std::int64_t lowest = kind.low_fx + reach;
  const std::int64_t highest = kind.high_fx - reach;
  const std::int64_t first_y = std::max(first(box.low_fx), floor_div(lowest, edge));
  const std::int64_t last_y = std::min(last(box.high_fx), floor_div(highest, edge));
  if (first_y > last_y) return;
  for (std::int64_t cz = first(box.z0 * kSubvoxels); cz <= last(box.z1 * kSubvoxels); ++cz) {
    const Draw z_draw = draw.child(cz);
    for (std::int64_t cx = first(box.x0 * kSubvoxels); cx <= last(box.x1 * kSubvoxels); ++cx) {
      const Draw x_draw = z_draw.child(cx);
      for (std::int64_t cy = first_y; cy <= last_y; ++cy) {
        const std::uint64_t seed = x_draw.child(cy).value();
        if (seed >> 32 >= kind.chance_q32) continue;
        Draws draws{~seed};
        const Middle middle{cx * edge + draws.between(0, edge), cy * edge + draws.between(0, edge),
                            cz * edge + draws.between(0, edge)};
        if (middle.y_fx < lowest || middle.y_fx > highest) continue;
        if (!meets(box, middle, reach, reach)) continue;
        add_body(kind, middle, seed, lobes);
      }
    }
  }
}

}  // namespace

OreRow::OreRow(const OreLobe& lobe, std::int64_t column_z, std::int64_t low_fx, std::int64_t high_fx)
    : lobe_{lobe},
      low_fx_{low_fx},
      high_fx_{high_fx},
      z_fx_{column_z * kSubvoxels},
      along_q14_{(z_fx_ - lobe.z_fx) * lobe.sin_q14},
      across_q14_{(z_fx_ - lobe.z_fx) * lobe.cos_q14},
      misses_{std::abs(z_fx_ - lobe.z_fx) > lobe.reach_fx} {}

OreRow::GrainLine OreRow::grain_line(std::int64_t line) const {
  const std::int64_t north = z_fx_ >> lobe_.grain_bits;
  const std::int64_t south = weight_q15(place_in_grain_q15(lobe_, z_fx_));
  const auto corner = [&](std::int64_t at) {
    return mix64(lobe_.seed ^ (static_cast<std::uint64_t>(line) * 0x9E3779B97F4A7C15U +
                               static_cast<std::uint64_t>(at) * 0xD1B54A32D192ED03U));
  };
  const std::array corners{corner(north), corner(north + 1)};
  const auto blend = [&](int shift) {
    const auto at = [&](std::size_t i) { return static_cast<std::int64_t>((corners[i] >> shift) & 0x7FFF); };
    return at(0) * (kOne_q15 - south) + at(1) * south;
  };
  return {blend(0), blend(20)};
}

// The part of at() before its noise, in real numbers: the intersection of the row with the ellipse and of the
// tilted sheet with the heights. Both are widened by the possible rounding.
OreRow::Reach OreRow::reach() const {
  if (misses_) return {};
  const auto cos = static_cast<double>(lobe_.cos_q14);
  const auto sin = static_cast<double>(lobe_.sin_q14);
  const auto south = static_cast<double>(z_fx_ - lobe_.z_fx);
  const double per_along = static_cast<double>(lobe_.per_along_q40) * 0x1p-25;
  const double per_across = static_cast<double>(lobe_.per_across_q40) * 0x1p-25;
  // (a, c) are rounded down twice, and out is below 1 if they lie within 2^15 of the middle.
  const double radius = static_cast<double>(kOne_q15) + per_along + per_across + 2;
  const double u = per_along * 0x1p-14;
  const double v = per_across * 0x1p-14;
  const double square = u * u * cos * cos + v * v * sin * sin;
  const double apart = u * v * south * (cos * cos + sin * sin);
  const double inside = square * radius * radius - apart * apart;
  if (inside < 0) return {};
  const double middle = -south * sin * cos * (u * u - v * v) / square;
  const double half = std::sqrt(inside) / square;
  double from = std::max(middle - half, -static_cast<double>(lobe_.reach_fx));
  double to = std::min(middle + half, static_cast<double>(lobe_.reach_fx));

  const auto tilt_along = static_cast<double>(lobe_.tilt_along_q12);
  const auto tilt_across = static_cast<double>(lobe_.tilt_across_q12);
  const double rise = (cos * tilt_along - sin * tilt_across) * 0x1p-26;  // per subvoxel along the row
  const double here =
      static_cast<double>(lobe_.y_fx) + south * (sin * tilt_along + cos * tilt_across) * 0x1p-26;
  const double most = static_cast<double>(lobe_.half_fx) + static_cast<double>(lobe_.sway_fx) +
                      (std::abs(tilt_along) + std::abs(tilt_across)) * 0x1p-12 + 2;
  const double low = static_cast<double>(low_fx_) - most - here;
  const double high = static_cast<double>(high_fx_) + most - here;
  if (rise > 0) {
    from = std::max(from, low / rise);
    to = std::min(to, high / rise);
  } else if (rise < 0) {
    from = std::max(from, high / rise);
    to = std::min(to, low / rise);
  } else if (low > 0 || high < 0) {
    return {};
  }
  if (from > to) return {};
  // One more subvoxel on each side exceeds the rounding of doubles.
  const auto at = [&](double east) {
    return floor_div(lobe_.x_fx + static_cast<std::int64_t>(std::floor(east)), kSubvoxels);
  };
  return {at(from - 1), at(to + 1) + 1};
}

std::optional<OreSpan> OreRow::at(std::int64_t column_x) {
  const std::int64_t x_fx = column_x * kSubvoxels;
  const std::int64_t east = x_fx - lobe_.x_fx;
  if (misses_ || std::abs(east) > lobe_.reach_fx) return std::nullopt;
  const std::int64_t along = (along_q14_ + east * lobe_.cos_q14) >> 14;
  const std::int64_t across = (across_q14_ - east * lobe_.sin_q14) >> 14;
  const std::int64_t a = (along * lobe_.per_along_q40) >> 25;
  const std::int64_t c = (across * lobe_.per_across_q40) >> 25;
  std::int64_t out = (a * a + c * c) >> 15;
  if (out >= kOne_q15) return std::nullopt;
  const std::int64_t tilted =
      lobe_.y_fx + ((along * lobe_.tilt_along_q12 + across * lobe_.tilt_across_q12) >> 12);
  // Steep lobes pass a chunk's rows in few columns: only these need the noise.
  const std::int64_t most = lobe_.half_fx + lobe_.sway_fx;
  if (tilted + most < low_fx_ || tilted - most >= high_fx_) return std::nullopt;

  const std::int64_t grain = x_fx >> lobe_.grain_bits;
  if (grain != grain_) {
    west_ = grain_line(grain);
    east_ = grain_line(grain + 1);
    grain_ = grain;
  }
  const std::int64_t weight = weight_q15(place_in_grain_q15(lobe_, x_fx));
  const auto blend = [&](std::int64_t west_q30, std::int64_t east_q30) {
    return (west_q30 * (kOne_q15 - weight) + east_q30 * weight) >> 30;
  };
  out += (blend(west_.edge_q30, east_.edge_q30) * lobe_.ragged_q15) >> 15;
  if (out >= kOne_q15) return std::nullopt;
  // Blunt at the rim, like an ellipsoid.
  const std::int64_t half = lobe_.half_fx * (kOne_q15 - (out * out >> 15)) >> 15;
  const std::int64_t sway_q15 = 2 * blend(west_.sway_q30, east_.sway_q30) - kOne_q15;
  const std::int64_t middle = tilted + ((lobe_.sway_fx * sway_q15) >> 15);
  const std::int64_t from = std::max<std::int64_t>(middle - half, lobe_.y_fx - lobe_.rise_fx);
  const std::int64_t to = std::min<std::int64_t>(middle + half, lobe_.y_fx + lobe_.rise_fx);
  if (from >= to) return std::nullopt;
  return OreSpan{static_cast<std::int32_t>(from), static_cast<std::int32_t>(to)};
}

void add_lobes(const OreKind& kind, const OreBox& box, std::vector<OreLobe>& lobes) {
  const auto before = static_cast<std::ptrdiff_t>(lobes.size());
  if (kind.secret) {
    add_bodies(kind, box, SecretDraw{*kind.secret}, lobes);
  } else {
    add_bodies(kind, box, PublicDraw{kind.seed}, lobes);
  }
  lobes.erase(std::remove_if(lobes.begin() + before, lobes.end(),
                             [&](const OreLobe& lobe) { return !meets(box, lobe); }),
              lobes.end());
}

}  // namespace talus::terrain
