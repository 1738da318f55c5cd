// [[faults]]: sets of faults that cut the strata into blocks (docs/DESIGN.md, "Folds and faults").
#include "features/faults.h"

#include <algorithm>

#include <talus/terrain/lattice_hash.h>
#include <talus/voxel/coords.h>

#include "noise/fbm_rows.h"
#include "spec/canonical_form.h"
#include "spec/units.h"

namespace talus::terrain {
namespace {

constexpr std::size_t kMaxSets = 8;
constexpr double kMinSpacing = 16;      // voxels
constexpr double kMaxWaviness = 16384;  // voxels
constexpr int kWanderOctaves = 3;
constexpr std::uint64_t kFaultSeed = 0x4641554C54000000U;
constexpr std::uint64_t kWanderSeed = 0x57414E4445520000U;

class FaultDeformation final : public Deformation {
 public:
  FaultDeformation(const std::vector<FaultField>& sets, InstructionSet set) : sets_{sets}, wander_{set} {}

  void add(std::span<const std::int64_t> xs, std::span<const std::int64_t> zs, Field& lift_fx) override {
    for (const FaultField& faults : sets_) add_set(faults, xs, zs, lift_fx);
  }

 private:
  void add_set(const FaultField& faults, std::span<const std::int64_t> xs, std::span<const std::int64_t> zs,
               Field& lift_fx);

  std::vector<FaultField> sets_;
  FbmRows wander_;
};

void FaultDeformation::add_set(const FaultField& faults, std::span<const std::int64_t> xs,
                               std::span<const std::int64_t> zs, Field& lift_fx) {
  const bool straight = faults.waviness_fx == 0;
  if (!straight) wander_.start(faults.wander, xs);
  // The block [start, end) of the previous column; most columns share it.
  std::int64_t start = 0;
  std::int64_t end = 0;
  std::int32_t block_lift_fx = 0;
  for (std::size_t z = 0; z < zs.size(); ++z) {
    const float* noise = straight ? nullptr : wander_.row(zs[z]);
    const auto row = lift_fx.row(static_cast<int>(z));
    for (std::size_t x = 0; x < xs.size(); ++x) {
      std::int64_t place = faults.strike.across_q16(xs[x], zs[z]);
      if (!straight)
        place += static_cast<std::int64_t>(static_cast<std::int32_t>(faults.waviness_fx * noise[x])) * 256;
      if (place < start || place >= end) {
        const std::int64_t index = floor_div(place, faults.spacing_q16);
        start = index * faults.spacing_q16;
        end = start + faults.spacing_q16;
        block_lift_fx = faults.lift_fx(index);
      }
      row[x] += block_lift_fx;
    }
  }
}

std::unique_ptr<const Feature> read_faults(FeatureSection& section) {
  auto tables = section.tables();
  if (tables.size() > kMaxSets) {
    tables[kMaxSets].fail("spacing", text_of(tables.size(), " sets of faults; at most ", kMaxSets));
  }
  const WorldSpec& world = section.spec();
  std::vector<FaultField> sets;
  Feature::MaxLift lift{0, "half of every throw", "", 0};
  std::int64_t largest_throw_q16 = -1;
  for (TableReader& table : tables) {
    table.only({"strike", "spacing", "throw", "waviness"});
    const double strike = table.real("strike", {-360, 360});
    const std::int64_t spacing_q16 = table.length_q16("spacing", {kMinUnits_q16, kMaxLength},
                                                      {world.resolution, {kMinSpacing, kMaxLength}});
    const std::int64_t throw_q16 = table.units_q16("throw", {0, kMaxHeight});
    const std::int64_t waviness_q16 =
        table.has("waviness")
            ? table.length_q16("waviness", {0, kMaxHeight}, {world.resolution, {0, kMaxWaviness}})
            : 0;

    const std::uint64_t set = sets.size();
    FaultField& field = sets.emplace_back();
    field.seed = derived_seed(world.seed, kFaultSeed + set);
    field.strike = strike_of(strike);
    field.spacing_q16 = spacing_q16 * world.resolution;
    field.throw_fx = subvoxels_of(throw_q16, world.resolution);
    field.wander = {derived_seed(world.seed, kWanderSeed + set),
                    std::max<std::int64_t>(2, field.spacing_q16 >> 16), kWanderOctaves};
    field.waviness_fx = static_cast<float>(subvoxels_of(waviness_q16, world.resolution));
    lift.q16 += (throw_q16 + 1) / 2;
    if (throw_q16 <= largest_throw_q16) continue;
    largest_throw_q16 = throw_q16;
    lift.key = table.name() + ".throw";
    lift.line = table.line("throw");
  }
  return std::make_unique<Faults>(std::move(sets), std::move(lift));
}

}  // namespace

std::int32_t FaultField::lift_fx(std::int64_t index) const {
  const std::uint64_t draw = derived_seed(seed, static_cast<std::uint64_t>(index)) >> 32;
  return static_cast<std::int32_t>(((static_cast<std::int64_t>(draw) * throw_fx) >> 32) - throw_fx / 2);
}

void Faults::write_canonical_form(TextWriter& form) const {
  for (const FaultField& faults : sets_) {
    form << "faults throw_fx " << faults.throw_fx << " spacing_q16 " << faults.spacing_q16 << " waviness_fx "
         << bits_of(faults.waviness_fx) << faults.strike << '\n';
  }
}

std::unique_ptr<Deformation> Faults::make_deformation(InstructionSet set) const {
  return std::make_unique<FaultDeformation>(sets_, set);
}

namespace features {

FeatureKind faults() {
  return {"faults", read_faults};
}

}  // namespace features
}  // namespace talus::terrain
