#include <talus/terrain/land_measures.h>

#include <array>
#include <cmath>
#include <utility>

#include <talus/terrain/surface.h>
#include <talus/vectors/aligned.h>
#include <talus/vectors/instruction_set.h>
#include <talus/vectors/tables.h>

#include "surface/regions/region_rows.h"
#include "surface/regions/regions.h"

namespace talus::terrain {

struct LandPartsSampler::Scratch {
  explicit Scratch(const Surface& surface) : rows{surface, instruction_set()} {}

  RegionRows rows;
  std::size_t width = 0;
  AlignedVector<float> height, terraces, bed, river, flood_plain;

  [[nodiscard]] std::span<const float> row_of(const AlignedVector<float>& part) const {
    return {part.data(), width};
  }
};

std::optional<LandPartsSampler> LandPartsSampler::make(const World& world) {
  const Surface surface = surface_of(world.spec());
  if (!surface.regions) return std::nullopt;
  return LandPartsSampler{std::make_unique<Scratch>(surface)};
}

LandPartsSampler::LandPartsSampler(std::unique_ptr<Scratch> scratch) : scratch_{std::move(scratch)} {}
LandPartsSampler::~LandPartsSampler() = default;
LandPartsSampler::LandPartsSampler(LandPartsSampler&&) noexcept = default;
LandPartsSampler& LandPartsSampler::operator=(LandPartsSampler&&) noexcept = default;

void LandPartsSampler::start(std::span<const std::int64_t> xs) {
  Scratch& s = *scratch_;
  s.rows.start(xs);
  s.width = xs.size();
  for (auto* const part : {&s.height, &s.terraces, &s.bed, &s.river, &s.flood_plain})
    part->resize(padded(s.width));
}

void LandPartsSampler::row(std::int64_t z) {
  Scratch& s = *scratch_;
  s.rows.parts_row(z,
                   {s.height.data(), s.terraces.data(), s.bed.data(), s.river.data(), s.flood_plain.data()});
}

std::span<const float> LandPartsSampler::height() const {
  return scratch_->row_of(scratch_->height);
}
std::span<const float> LandPartsSampler::terraces() const {
  return scratch_->row_of(scratch_->terraces);
}
std::span<const float> LandPartsSampler::bed() const {
  return scratch_->row_of(scratch_->bed);
}
std::span<const float> LandPartsSampler::river() const {
  return scratch_->row_of(scratch_->river);
}
std::span<const float> LandPartsSampler::flood_plain() const {
  return scratch_->row_of(scratch_->flood_plain);
}

namespace {

struct Displacement {
  double east = 0;  // columns
  double south = 0;
};

/// A displacement's wide and narrow noise at a column, as used for samples.
Displacement displacement_at(const SlowFields& fields, std::int64_t x, std::int64_t z) {
  const auto along = [&](const std::array<RotatedNoise, 2>& noise) {
    return static_cast<double>(fields.warp_reach[0] * rotated_fbm(noise[0], x, z) +
                               fields.warp_reach[1] * rotated_fbm(noise[1], x, z)) /
           256;
  };
  return {along(fields.warp_east), along(fields.warp_south)};
}

/// Distance along one axis to the nearest lattice point, or middle of a cell, in 2^-32 cells.
double to_nearest(std::uint64_t position, ShapingLattices::Spot spot) {
  constexpr std::uint64_t kHalf = std::uint64_t{1} << 31U;
  const std::uint64_t to_middle = kHalf - static_cast<std::uint32_t>(position);
  const std::uint64_t to = spot == ShapingLattices::Spot::middle
                               ? to_middle
                               : to_middle + (static_cast<std::int64_t>(to_middle) < 0 ? kHalf : 0U - kHalf);
  return static_cast<double>(static_cast<std::int64_t>(to));
}

}  // namespace

struct ShapingLattices::Lattices {
  struct One {
    RotatedLattice lattice;
    double displaced = 0;  // factor of the warp
  };
  std::shared_ptr<const Regions> regions;
  std::vector<std::string> names;
  std::vector<One> all;

  void add(std::string name, const RotatedNoise& noise, double displaced) {
    names.push_back(std::move(name));
    all.push_back({rotated_lattice(derived_seed(noise.seed, 0), noise.period, 0, noise.turn), displaced});
  }
};

std::optional<ShapingLattices> ShapingLattices::make(const World& world) {
  const Surface surface = surface_of(world.spec());
  if (!surface.regions) return std::nullopt;
  auto lattices = std::make_unique<Lattices>();
  lattices->regions = surface.regions;
  const SlowFields& slow = surface.regions->slow;
  const auto field = [&](const char* name, const SlowFields::Field& of) {
    lattices->add(name, of.noise, of.warped ? 1 : 0);
  };
  field("continents", slow.continents);
  field("ranges", slow.ranges);
  field("hilliness", slow.hilliness);
  field("mesas", slow.mesas);
  lattices->add("rivers", slow.rivers[0], 1);
  lattices->add("shape", surface.regions->shape, 0.5);
  return ShapingLattices{std::move(lattices)};
}

ShapingLattices::ShapingLattices(std::unique_ptr<const Lattices> lattices) : lattices_{std::move(lattices)} {}
ShapingLattices::~ShapingLattices() = default;
ShapingLattices::ShapingLattices(ShapingLattices&&) noexcept = default;
ShapingLattices& ShapingLattices::operator=(ShapingLattices&&) noexcept = default;

const std::vector<std::string>& ShapingLattices::names() const {
  return lattices_->names;
}

std::optional<BaseColumn> ShapingLattices::column(std::size_t noise, BaseColumn from, Spot spot) const {
  const Lattices::One& one = lattices_->all[noise];
  const auto du = static_cast<double>(one.lattice.du);
  const auto dv = static_cast<double>(one.lattice.dv);
  const double u = to_nearest(one.lattice.u(from.x, from.z), spot);
  const double v = to_nearest(one.lattice.v(from.x, from.z), spot);
  const double squares = du * du + dv * dv;
  const double target_x = (du * u - dv * v) / squares;  // columns relative to `from`
  const double target_z = (dv * u + du * v) / squares;
  double x = target_x;
  double z = target_z;
  const auto column = [&] { return BaseColumn{from.x + std::llround(x), from.z + std::llround(z)}; };
  if (one.displaced == 0) return column();
  constexpr int kSteps = 24;
  constexpr double kShare = 0.7;  // share of the error corrected per step, as the displacement changes too
  for (int step = 0; step < kSteps; ++step) {
    const BaseColumn at = column();
    const Displacement moved = displacement_at(lattices_->regions->slow, at.x, at.z);
    const double east = target_x - x - one.displaced * moved.east;
    const double south = target_z - z - one.displaced * moved.south;
    if (std::abs(east) < 1 && std::abs(south) < 1) return at;
    x += kShare * east;
    z += kShare * south;
  }
  return std::nullopt;
}

}  // namespace talus::terrain
