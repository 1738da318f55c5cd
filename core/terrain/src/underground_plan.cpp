#include "underground_plan.h"

#include <string>
#include <utility>

#include "bends.h"

namespace talus::terrain {
namespace {

constexpr double kMaxHeight = 32768;     // voxels
constexpr double kMaxPeriod = 16777216;  // voxels
constexpr double kMinPeriod = 16;        // voxels: twice the step at which folds are drawn
constexpr double kMaxWaviness = 16384;   // voxels
constexpr std::size_t kMaxFaults = 8;
constexpr std::size_t kMaxOres = 16;
// Four voxels: a chunk looks at no more than (32 / 4 + 2)^3 cubes of a kind.
constexpr double kMinOre = 4;
constexpr double kMaxOre = 1024;  // voxels

double units_of(std::int64_t q16) {
  return static_cast<double>(q16) / 65536;
}

// Refuses keys at the lines where they stand.
class KeyChecks {
 public:
  KeyChecks(const WorldSpec& spec, const SpecLines& lines) : resolution_{spec.resolution}, lines_{lines} {}

  [[nodiscard]] SpecFault fault(const std::string& key, std::string what) const {
    const auto line = lines_.underground.find(key);
    return {line == lines_.underground.end() ? 0 : line->second, key, std::move(what)};
  }
  // A length that must come to `least` to `most` voxels.
  [[nodiscard]] std::optional<SpecFault> length(const std::string& table, const std::string& key,
                                                double units, double least, double most) const {
    auto found = out_of_range(0, table, key, units, resolution_, least, most);
    if (found) found->line = fault(found->key, "").line;
    return found;
  }

 private:
  int resolution_;
  const SpecLines& lines_;
};

std::optional<SpecFault> check_bends(const WorldSpec& spec, const KeyChecks& keys) {
  if (spec.folds) {
    if (auto fault = keys.length("folds", "wavelength", spec.folds->wavelength, kMinPeriod, kMaxPeriod)) {
      return fault;
    }
  }
  if (spec.faults.size() > kMaxFaults) {
    return keys.fault("faults[" + std::to_string(kMaxFaults) + "].spacing",
                      text_of(spec.faults.size(), " sets of faults; at most ", kMaxFaults));
  }
  for (std::size_t i = 0; i < spec.faults.size(); ++i) {
    const std::string table = "faults[" + std::to_string(i) + "]";
    const FaultSpec& faults = spec.faults[i];
    if (auto fault = keys.length(table, "spacing", units_of(faults.spacing_q16), kMinPeriod, kMaxPeriod)) {
      return fault;
    }
    if (auto fault = keys.length(table, "waviness", units_of(faults.waviness_q16), 0, kMaxWaviness))
      return fault;
  }
  const double bent = (units_of(greatest_bend_q16(spec)) + spec.surface.amplitude) * spec.resolution;
  if (bent <= kMaxHeight) return std::nullopt;
  return keys.fault(spec.folds ? "folds.amplitude" : "faults[0].throw",
                    text_of("surface.amplitude, folds.amplitude and half of every throw, * resolution, are ",
                            bent, " voxels in all; at most ", kMaxHeight));
}

std::optional<SpecFault> check_veins(const WorldSpec& spec, const KeyChecks& keys) {
  if (spec.veins.size() > kMaxOres) {
    return keys.fault("veins[" + std::to_string(kMaxOres) + "].name",
                      text_of(spec.veins.size(), " ores; at most ", kMaxOres));
  }
  for (std::size_t i = 0; i < spec.veins.size(); ++i) {
    const OreSpec& ore = spec.veins[i];
    const std::string table = "veins[" + std::to_string(i) + "]";
    const auto check = [&](const char* key, std::int64_t units_q16, double least, double most) {
      return keys.length(table, key, units_of(units_q16), least, most);
    };
    if (auto fault = check("size", ore.size_q16, kMinOre, kMaxOre)) return fault;
    if (auto fault = check("high", ore.high_q16, 0, kMaxHeight)) return fault;
    if (ore.shape == OreShape::vein) {
      if (auto fault = check("thickness", ore.thickness_q16, 1, kMaxOre)) return fault;
      if (ore.thickness_q16 > ore.size_q16 / 4) {
        return keys.fault(table + ".thickness", "more than a quarter of size; make it at most that");
      }
    }
    if (ore.high_q16 - ore.low_q16 < ore.size_q16) {
      return keys.fault(table + ".high",
                        "less than size above low, so that no body fits; make it low + size or more");
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<SpecFault> check_underground(const WorldSpec& spec, const SpecLines& lines) {
  const KeyChecks keys{spec, lines};
  if (auto fault = check_bends(spec, keys)) return fault;
  return check_veins(spec, keys);
}

}  // namespace talus::terrain
