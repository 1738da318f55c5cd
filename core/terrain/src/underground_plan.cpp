#include "underground_plan.h"

#include <sstream>

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

std::optional<SpecFault> check_bends(const WorldSpec& spec, const SpecLines& lines) {
  if (spec.folds) {
    if (auto fault = out_of_range(lines.folds, "folds", "wavelength", spec.folds->wavelength, spec.resolution,
                                  kMinPeriod, kMaxPeriod)) {
      return fault;
    }
  }
  if (spec.faults.size() > kMaxFaults) {
    return SpecFault{
        lines.faults[kMaxFaults], "faults",
        std::to_string(spec.faults.size()) + " sets of faults; at most " + std::to_string(kMaxFaults)};
  }
  for (std::size_t i = 0; i < spec.faults.size(); ++i) {
    const std::string table = "faults[" + std::to_string(i) + "]";
    const FaultSpec& faults = spec.faults[i];
    if (auto fault = out_of_range(lines.faults[i], table, "spacing", units_of(faults.spacing_q16),
                                  spec.resolution, kMinPeriod, kMaxPeriod)) {
      return fault;
    }
    if (auto fault = out_of_range(lines.faults[i], table, "waviness", units_of(faults.waviness_q16),
                                  spec.resolution, 0, kMaxWaviness)) {
      return fault;
    }
  }
  const double bent = (units_of(greatest_bend_q16(spec)) + spec.surface.amplitude) * spec.resolution;
  if (bent > kMaxHeight) {
    std::ostringstream what;
    what << "surface.amplitude, folds.amplitude and half of every throw, * resolution, are " << bent
         << " voxels in all; at most " << kMaxHeight;
    return spec.faults.empty() ? SpecFault{lines.folds, "folds.amplitude", what.str()}
                               : SpecFault{lines.faults.front(), "faults[0].throw", what.str()};
  }
  return std::nullopt;
}

std::optional<SpecFault> check_veins(const WorldSpec& spec, const SpecLines& lines) {
  if (spec.veins.size() > kMaxOres) {
    return SpecFault{lines.veins[kMaxOres], "veins",
                     std::to_string(spec.veins.size()) + " ores; at most " + std::to_string(kMaxOres)};
  }
  for (std::size_t i = 0; i < spec.veins.size(); ++i) {
    const OreSpec& ore = spec.veins[i];
    const int line = lines.veins[i];
    const std::string table = "veins[" + std::to_string(i) + "]";
    const auto check = [&](const std::string& key, std::int64_t units_q16, double least, double most) {
      return out_of_range(line, table, key, units_of(units_q16), spec.resolution, least, most);
    };
    if (auto fault = check("size", ore.size_q16, kMinOre, kMaxOre)) return fault;
    if (auto fault = check("high", ore.high_q16, 0, kMaxHeight)) return fault;
    if (ore.shape == OreShape::vein) {
      if (auto fault = check("thickness", ore.thickness_q16, 1, kMaxOre)) return fault;
      if (ore.thickness_q16 > ore.size_q16 / 4) {
        return SpecFault{line, table + ".thickness", "is more than a quarter of size; make it at most that"};
      }
    }
    if (ore.high_q16 - ore.low_q16 < ore.size_q16) {
      return SpecFault{line, table + ".high",
                       "less than size above low, so that no body fits; make it low + size or more"};
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<SpecFault> check_underground(const WorldSpec& spec, const SpecLines& lines) {
  if (auto fault = check_bends(spec, lines)) return fault;
  return check_veins(spec, lines);
}

}  // namespace talus::terrain
