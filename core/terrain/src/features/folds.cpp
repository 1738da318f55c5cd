// [folds]: strata bent into folds (docs/DESIGN.md, "Folds and faults").
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <talus/terrain/fbm.h>
#include <talus/terrain/lattice_hash.h>
#include <talus/voxel/coords.h>

#include "feature.h"
#include "features/strike.h"
#include "noise/point_fbm.h"
#include "spec/canonical_form.h"
#include "spec/units.h"

namespace talus::terrain {
namespace {

// Folds are much longer than this step: they are computed at every eighth column along both axes and
// interpolated linearly.
constexpr std::int64_t kFoldStep = 8;
constexpr double kMinWavelength = 16;  // voxels: twice that step
constexpr std::uint64_t kFoldSeed = 0x464F4C4453000000U;

// The folds of a world in the numbers used to compute them.
struct FoldField {
  Fbm noise;
  Strike strike;
  std::int64_t shrink_q16 = 0;  // factor of distances along the strike
  float amplitude_fx = 0;       // maximum lift or drop of strata
};

class FoldDeformation final : public Deformation {
 public:
  explicit FoldDeformation(const FoldField& folds) : folds_{folds}, noise_{folds.noise} {}

  void add(std::span<const std::int64_t> xs, std::span<const std::int64_t> zs, Field& lift_fx) override;

 private:
  /// Columns along one axis relative to the lattice of folds: a column lies `past` eighths of the way from
  /// point `before` to point `after`.
  struct Lattice {
    struct Place {
      std::size_t before = 0;
      std::size_t after = 0;
      std::int32_t past = 0;
    };
    std::vector<std::int64_t> points;  // base columns, ascending
    std::vector<Place> places;         // one per column
    void compute(std::span<const std::int64_t> columns);
  };

  [[nodiscard]] std::int32_t fold_at(std::int64_t x, std::int64_t z);

  FoldField folds_;
  PointFbm noise_;
  Lattice east_;
  Lattice south_;
  Field coarse_;
  std::vector<std::int32_t> between_;  // a row at the lattice's points, in eighths of a subvoxel
};

void FoldDeformation::Lattice::compute(std::span<const std::int64_t> columns) {
  points.clear();
  places.clear();
  const auto index_of = [&](std::int64_t point) {
    if (points.size() > 1 && points[points.size() - 2] == point) return points.size() - 2;
    if (points.empty() || points.back() != point) points.push_back(point);
    return points.size() - 1;
  };
  for (const std::int64_t column : columns) {
    const std::int64_t past = floor_mod(column, kFoldStep);
    const std::size_t before = index_of(column - past);
    const std::size_t after = past == 0 ? before : index_of(column - past + kFoldStep);
    places.push_back({before, after, static_cast<std::int32_t>(past)});
  }
}

// Crests and troughs are rounded off where the noise is strong, so that the amplitude is never exceeded.
std::int32_t FoldDeformation::fold_at(std::int64_t x, std::int64_t z) {
  const std::int64_t across_fx = folds_.strike.across_q16(x, z) >> 8;
  const std::int64_t along_fx = ((folds_.strike.along_q16(x, z) >> 8) * folds_.shrink_q16) >> 16;
  const float s = std::clamp(2.0F * noise_.at(across_fx, along_fx), -1.0F, 1.0F);
  return static_cast<std::int32_t>(folds_.amplitude_fx * (s * (1.5F - 0.5F * (s * s))));
}

void FoldDeformation::add(std::span<const std::int64_t> xs, std::span<const std::int64_t> zs,
                          Field& lift_fx) {
  east_.compute(xs);
  south_.compute(zs);
  coarse_.reshape(static_cast<int>(east_.points.size()), static_cast<int>(south_.points.size()));
  for (int z = 0; z < coarse_.depth; ++z) {
    for (int x = 0; x < coarse_.width; ++x) {
      coarse_.at(x, z) =
          fold_at(east_.points[static_cast<std::size_t>(x)], south_.points[static_cast<std::size_t>(z)]);
    }
  }
  constexpr auto kStep = static_cast<std::int32_t>(kFoldStep);
  between_.resize(east_.points.size());
  for (int z = 0; z < lift_fx.depth; ++z) {
    const Lattice::Place& south = south_.places[static_cast<std::size_t>(z)];
    const auto before = coarse_.row(static_cast<int>(south.before));
    const auto after = coarse_.row(static_cast<int>(south.after));
    for (std::size_t i = 0; i < between_.size(); ++i) {
      between_[i] = before[i] * (kStep - south.past) + after[i] * south.past;
    }
    const auto row = lift_fx.row(z);
    for (std::size_t x = 0; x < row.size(); ++x) {
      const Lattice::Place& east = east_.places[x];
      row[x] += (between_[east.before] * (kStep - east.past) + between_[east.after] * east.past) >> 6;
    }
  }
}

class Folds final : public Feature {
 public:
  Folds(const FoldField& field, MaxLift max_lift) : field_{field}, max_lift_{std::move(max_lift)} {}

  [[nodiscard]] Stage stage() const override { return Stage::strata; }
  void write_canonical_form(TextWriter& form) const override {
    form << "folds amplitude_fx " << bits_of(field_.amplitude_fx) << " period " << field_.noise.period
         << " octaves " << field_.noise.octaves << " shrink_q16 " << field_.shrink_q16 << field_.strike
         << '\n';
  }
  [[nodiscard]] MaxLift max_lift() const override { return max_lift_; }
  [[nodiscard]] std::unique_ptr<Deformation> make_deformation(InstructionSet /*set*/) const override {
    return std::make_unique<FoldDeformation>(field_);
  }

 private:
  FoldField field_;
  MaxLift max_lift_;
};

std::unique_ptr<const Feature> read_folds(FeatureSection& section) {
  auto table = section.table();
  if (!table) return nullptr;
  table->only({"amplitude", "wavelength", "octaves", "strike", "stretch"});
  const WorldSpec& world = section.spec();
  const std::int64_t amplitude_q16 = table->units_q16("amplitude", {0, kMaxHeight});
  const double wavelength =
      table->length("wavelength", {kMinLength, kMaxLength}, {world.resolution, {kMinWavelength, kMaxLength}});
  const int octaves = table->has("octaves") ? static_cast<int>(table->integer("octaves", 1, 8)) : 2;
  const double strike = table->has("strike") ? table->real("strike", {-360, 360}) : 0;
  const double stretch = table->has("stretch") ? table->real("stretch", {1, 64}) : 4;

  FoldField field;
  field.noise = {derived_seed(world.seed, kFoldSeed),
                 std::max<std::int64_t>(2, rounded(wavelength * world.resolution)), octaves};
  field.strike = strike_of(strike);
  field.shrink_q16 = rounded(65536 / stretch);
  field.amplitude_fx = static_cast<float>(subvoxels_of(amplitude_q16, world.resolution));
  Feature::MaxLift lift{amplitude_q16, "folds.amplitude", "folds.amplitude", table->line("amplitude")};
  return std::make_unique<Folds>(field, std::move(lift));
}

}  // namespace

namespace features {

FeatureKind folds() {
  return {"folds", read_folds};
}

}  // namespace features
}  // namespace talus::terrain
