#include "quality.h"

#include <array>
#include <cstdio>

#include <nlohmann/json.hpp>

namespace talus::tools {
namespace {

using QualityJson = nlohmann::ordered_json;

class Lines {
 public:
  template <typename... Values>
  void add(const char* format, Values... values) {
    if constexpr (sizeof...(values) == 0) {
      text_ += format;
    } else {
      std::array<char, 256> line{};
      std::snprintf(line.data(), line.size(), format, values...);
      text_ += line.data();
    }
    text_ += '\n';
  }
  [[nodiscard]] std::string take() { return std::move(text_); }

 private:
  std::string text_;
};

QualityJson json_of(const QualityPlace& place) {
  return {{"voxels", place.voxels}, {"x", place.x}, {"z", place.z}};
}

}  // namespace

std::string to_text(const Quality& quality) {
  const QualityOptions& options = quality.options;
  Lines lines;
  lines.add("Power of heights along the axes : along the diagonals; %d windows a band, +- standard error",
            options.spectra);
  for (const QualityBand& band : quality.bands) {
    lines.add("  waves of %4d to %4d columns  %6.3f +- %.3f", band.from, band.to, band.power.ratio,
              band.power.error);
  }
  lines.add("");
  lines.add("%d blocks of %d x %d columns", options.blocks, kBlockSide, kBlockSide);
  lines.add(
      "  water                        %5.1f %% +- %.1f; least %.1f, 10 %%: %.1f, median %.1f, 90 %%: %.1f, "
      "most %.1f",
      100 * quality.water_mean, 100 * quality.water_deviation, 100 * quality.water_percentiles[0],
      100 * quality.water_percentiles[1], 100 * quality.water_percentiles[2],
      100 * quality.water_percentiles[3], 100 * quality.water_percentiles[4]);
  lines.add("  most of a block is           blocks   share of all");
  for (const QualityKind& kind : quality.kinds) {
    lines.add("    %-26s %6d       %6.2f %%", kind.name.c_str(), kind.blocks, 100 * kind.share);
  }
  lines.add("");
  lines.add("%d windows of %d x %d columns, each column", options.windows, options.window_side,
            options.window_side);
  lines.add("  water                        %6.2f %% of columns", 100 * quality.window_water);
  lines.add("  in lone pieces (< 16 columns) %5.3f %% of water", 100 * quality.lone_water);
  lines.add("  inland, touching no edge     %6.2f %% of water", 100 * quality.inland_water);
  lines.add("  steeper than 35, 45, 60 deg. %6.2f %%, %.2f %%, %.2f %% of land", 100 * quality.steep[0],
            100 * quality.steep[1], 100 * quality.steep[2]);
  const auto add_place = [&](const char* name, const QualityPlace& place) {
    lines.add("  %-28s %6.1f voxels at %lld,%lld", name, place.voxels, static_cast<long long>(place.x),
              static_cast<long long>(place.z));
  };
  add_place("largest step to a neighbour", quality.largest_step);
  if (quality.regions) {
    add_place("largest without a terrace", quality.other_step);
    lines.add("  beds of rivers               %6.2f %% of columns; %.2f %% of those fade away in the hills",
              100 * quality.beds, 100 * quality.fading_beds);
    add_place("highest over its flood plain", quality.highest_bed);
    add_place("the same of a fading one", quality.highest_fading_bed);
    lines.add("");
    lines.add("Lattices of first octaves, %d places each: mean heights at their points and between",
              options.lattice_places);
    for (const QualityLattice& lattice : quality.lattices) {
      lines.add("  %-28s %6.1f, %6.1f voxels: %.3f +- %.3f standard deviations apart", lattice.noise.c_str(),
                lattice.at_points, lattice.at_middles, lattice.apart, lattice.error);
    }
  }
  lines.add("");
  lines.add("In all columns sampled");
  add_place("highest", quality.highest);
  add_place("deepest", quality.deepest);
  lines.add("");
  lines.add("Wanted in the default world");
  for (const QualityWish& wish : quality.wishes) {
    lines.add("  %-7s %s: %s", wish.met ? "met" : "NOT MET", wish.what.c_str(), wish.measured.c_str());
  }
  return lines.take();
}

std::string to_json(const Quality& quality) {
  QualityJson json{{"spectra", quality.options.spectra},
                   {"blocks", quality.options.blocks},
                   {"block_side", kBlockSide},
                   {"windows", quality.options.windows},
                   {"window_side", quality.options.window_side},
                   {"bands", QualityJson::array()}};
  for (const QualityBand& band : quality.bands) {
    json["bands"].push_back({{"from_columns", band.from},
                             {"to_columns", band.to},
                             {"axes_to_diagonals", band.power.ratio},
                             {"standard_error", band.power.error},
                             {"windows", band.power.windows}});
  }
  const auto& percentiles = quality.water_percentiles;
  json["water_of_blocks"] = {{"mean", quality.water_mean}, {"standard_deviation", quality.water_deviation},
                             {"least", percentiles[0]},    {"percentile_10", percentiles[1]},
                             {"median", percentiles[2]},   {"percentile_90", percentiles[3]},
                             {"most", percentiles[4]}};
  json["kinds"] = QualityJson::array();
  for (const QualityKind& kind : quality.kinds) {
    json["kinds"].push_back({{"name", kind.name},
                             {"ground", kind.ground},
                             {"blocks_it_covers_most_of", kind.blocks},
                             {"share", kind.share}});
  }
  json["kinds_that_cover_most_somewhere"] = quality.kinds_somewhere;
  json["water_of_windows"] = quality.window_water;
  json["lone_water_of_water"] = quality.lone_water;
  json["inland_water_of_water"] = quality.inland_water;
  json["land_steeper_than"] = QualityJson::array();
  for (std::size_t d = 0; d < kSlopeDegrees.size(); ++d) {
    json["land_steeper_than"].push_back({{"degrees", kSlopeDegrees[d]}, {"share", quality.steep[d]}});
  }
  json["largest_step"] = json_of(quality.largest_step);
  if (quality.regions) {
    json["largest_step_without_a_terrace"] = json_of(quality.other_step);
    json["beds_of_columns"] = quality.beds;
    json["fading_beds_of_beds"] = quality.fading_beds;
    json["highest_bed_over_its_flood_plain"] = json_of(quality.highest_bed);
    json["highest_fading_bed_over_its_flood_plain"] = json_of(quality.highest_fading_bed);
    json["lattice_places"] = quality.options.lattice_places;
    json["lattices"] = QualityJson::array();
    for (const QualityLattice& lattice : quality.lattices) {
      json["lattices"].push_back({{"noise", lattice.noise},
                                  {"height_at_points", lattice.at_points},
                                  {"height_at_middles", lattice.at_middles},
                                  {"standard_deviations_apart", lattice.apart},
                                  {"standard_error", lattice.error}});
    }
  }
  json["highest"] = json_of(quality.highest);
  json["deepest"] = json_of(quality.deepest);
  json["wanted"] = QualityJson::array();
  for (const QualityWish& wish : quality.wishes) {
    json["wanted"].push_back({{"what", wish.what}, {"measured", wish.measured}, {"met", wish.met}});
  }
  return json.dump(2) + "\n";
}

}  // namespace talus::tools
