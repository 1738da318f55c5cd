#include "likeness.h"

#include <array>
#include <cmath>
#include <cstdio>

#include <talus/terrain/generator.h>
#include <nlohmann/json.hpp>

#include "world_variant.h"

namespace talus::tools {
namespace {

constexpr int kResolution = 100;
constexpr int kSide = 2 * kResolution;

terrain::Field sum_of(const std::vector<terrain::Field>& fields, int width, int depth) {
  terrain::Field sum{width, depth};
  for (const terrain::Field& field : fields) {
    for (std::size_t i = 0; i < sum.values.size(); ++i) sum.values[i] += field.values[i];
  }
  return sum;
}

double correlation(const terrain::Field& a, const terrain::Field& b) {
  const auto n = static_cast<double>(a.values.size());
  double mean_a = 0;
  double mean_b = 0;
  for (std::size_t i = 0; i < a.values.size(); ++i) {
    mean_a += a.values[i] / n;
    mean_b += b.values[i] / n;
  }
  double aa = 0;
  double bb = 0;
  double ab = 0;
  for (std::size_t i = 0; i < a.values.size(); ++i) {
    const double from_a = a.values[i] - mean_a;
    const double from_b = b.values[i] - mean_b;
    aa += from_a * from_a;
    bb += from_b * from_b;
    ab += from_a * from_b;
  }
  return aa > 0 && bb > 0 ? ab / std::sqrt(aa * bb) : 0;
}

// Values of one row, one per seed, from which its spreads are computed.
struct Seeds {
  std::vector<double> cover_slope;
  std::vector<double> cover_erosion;
  std::vector<double> overlap;
  std::vector<double> unrelated;
  std::vector<double> correlation;

  void add(const Alike& seed) {
    cover_slope.push_back(seed.cover_a);
    cover_erosion.push_back(seed.cover_b);
    overlap.push_back(seed.overlap);
    unrelated.push_back(seed.unrelated);
    correlation.push_back(seed.correlation);
  }
  [[nodiscard]] LikenessRow row(const std::string& name) const {
    return {name,
            spread_of(cover_slope),
            spread_of(cover_erosion),
            spread_of(overlap),
            spread_of(unrelated),
            spread_of(correlation)};
  }
};

std::string in_cell(const Spread& spread) {
  std::array<char, 64> cell{};
  std::snprintf(cell.data(), cell.size(), "  %6.3f +- %5.3f", spread.mean, spread.deviation);
  return cell.data();
}

nlohmann::ordered_json json_of(const Spread& spread) {
  return {{"mean", spread.mean}, {"deviation", spread.deviation}};
}

}  // namespace

Alike alike(const terrain::Field& a, const terrain::Field& b) {
  double with_a = 0;
  double with_b = 0;
  double with_both = 0;
  for (std::size_t i = 0; i < a.values.size(); ++i) {
    const bool in_a = a.values[i] > 0;
    const bool in_b = b.values[i] > 0;
    with_a += in_a ? 1 : 0;
    with_b += in_b ? 1 : 0;
    with_both += in_a && in_b ? 1 : 0;
  }
  const auto columns = static_cast<double>(a.values.size());
  Alike alike;
  alike.cover_a = with_a / columns;
  alike.cover_b = with_b / columns;
  const double either = with_a + with_b - with_both;
  const double by_chance = alike.cover_a * alike.cover_b;
  alike.overlap = either > 0 ? with_both / either : 1;
  alike.unrelated = either > 0 ? by_chance / (alike.cover_a + alike.cover_b - by_chance) : 1;
  alike.correlation = correlation(a, b);
  return alike;
}

Expected<Likeness> measure_likeness(const WorldText& text, int seeds, ProgressBar& progress) {
  progress.expect(static_cast<std::uint64_t>(seeds));
  std::vector<Seeds> rows;
  std::vector<std::string> names;
  for (int seed = 1; seed <= seeds; ++seed) {
    const auto world = world_variant(text, {.seed = seed, .resolution = kResolution});
    if (!world) return tl::make_unexpected(world.error());
    const terrain::Region region{0, 0, kSide, kSide, Lod{}};
    terrain::Terrain slope;
    terrain::Terrain erosion;
    terrain::Generator generator{*world};
    generator.generate(region, slope);
    generator.generate_to_rest(region, terrain::Neighbours::all, erosion);
    rows.resize(1 + world->loose().size());
    names.assign(1, "all");
    rows[0].add(alike(sum_of(slope.loose, kSide, kSide), sum_of(erosion.loose, kSide, kSide)));
    for (const std::size_t m : world->loose_bottom_up()) {
      rows[names.size()].add(alike(slope.loose[m], erosion.loose[m]));
      names.push_back(world->materials()[to_integer(world->loose()[m].material)].name);
    }
    progress.advance(1);
  }
  Likeness likeness{seeds, kSide, kResolution, {}};
  for (std::size_t i = 0; i < rows.size(); ++i) likeness.rows.push_back(rows[i].row(names[i]));
  return likeness;
}

std::string to_text(const Likeness& likeness) {
  std::array<char, 256> line{};
  std::snprintf(line.data(), line.size(),
                "loose layers of the slope method and of erosion to rest, %d x %d columns at %d voxels a "
                "terrain unit,\nmean +- standard deviation of %d seeds\n\n",
                likeness.side, likeness.side, likeness.resolution, likeness.seeds);
  std::string text = line.data();
  text +=
      "               cover: slope     cover: erosion    both / either    if independent     thickness, r\n";
  for (const LikenessRow& row : likeness.rows) {
    std::snprintf(line.data(), line.size(), "  %-10s", row.name.c_str());
    text += line.data() + in_cell(row.cover_slope) + in_cell(row.cover_erosion) + in_cell(row.overlap) +
            in_cell(row.unrelated) + in_cell(row.correlation) + "\n";
  }
  return text;
}

std::string to_json(const Likeness& likeness) {
  nlohmann::ordered_json json{{"seeds", likeness.seeds},
                              {"side", likeness.side},
                              {"resolution", likeness.resolution},
                              {"rows", nlohmann::ordered_json::array()}};
  for (const LikenessRow& row : likeness.rows) {
    json["rows"].push_back({{"material", row.name},
                            {"cover_slope", json_of(row.cover_slope)},
                            {"cover_erosion", json_of(row.cover_erosion)},
                            {"overlap", json_of(row.overlap)},
                            {"overlap_of_unrelated", json_of(row.unrelated)},
                            {"thickness_correlation", json_of(row.correlation)}});
  }
  return json.dump(2) + "\n";
}

}  // namespace talus::tools
