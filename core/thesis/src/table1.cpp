#include "table1.h"

#include <array>
#include <chrono>
#include <cmath>
#include <functional>

#include <talus/terrain/generator.h>

#include "world_variant.h"

namespace talus::tools {
namespace {

struct ThesisRow {
  int side;
  Spread erosion;
  Spread slope;
};
// On an Intel Core i5-8400 at 2.80 GHz.
constexpr std::array<ThesisRow, 7> kThesis{{{50, {1.003, 0.295}, {0.186, 0.018}},
                                            {75, {3.093, 0.966}, {0.499, 0.048}},
                                            {100, {7.922, 2.456}, {1.015, 0.111}},
                                            {125, {16.87, 7.865}, {1.784, 0.198}},
                                            {150, {25.52, 8.941}, {2.868, 0.346}},
                                            {175, {42.41, 16.81}, {4.349, 0.554}},
                                            {200, {53.61, 18.37}, {6.213, 0.944}}}};

double seconds_of(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double growth(const std::vector<Table1Row>& rows, Spread Table1Row::*column) {
  double n = 0;
  double sum_x = 0;
  double sum_y = 0;
  double sum_xx = 0;
  double sum_xy = 0;
  for (const Table1Row& row : rows) {
    const double x = std::log(row.side);
    const double y = std::log((row.*column).mean);
    n += 1;
    sum_x += x;
    sum_y += y;
    sum_xx += x * x;
    sum_xy += x * y;
  }
  return (n * sum_xy - sum_x * sum_y) / (n * sum_xx - sum_x * sum_x);
}

}  // namespace

Expected<Table1> run_table1(const WorldText& text, int seeds, ProgressBar& progress) {
  Table1 table;
  table.seeds = seeds;
  std::uint64_t columns = 0;
  for (const ThesisRow& thesis : kThesis)
    columns += static_cast<std::uint64_t>(seeds * thesis.side * thesis.side);
  progress.expect(columns);
  for (const ThesisRow& thesis : kThesis) {
    Table1Row row;
    row.side = thesis.side;
    row.thesis_erosion = thesis.erosion;
    row.thesis_slope = thesis.slope;
    std::vector<double> slope;
    std::vector<double> erosion;
    for (int seed = 1; seed <= seeds; ++seed) {
      const auto world = world_variant(text, {.seed = seed, .resolution = thesis.side});
      if (!world) return tl::make_unexpected(world.error());
      const terrain::Region region{0, 0, thesis.side, thesis.side, Lod{}};
      // Each generator is new, as in a program that makes one terrain.
      terrain::Terrain made;
      slope.push_back(seconds_of([&] { terrain::Generator{*world}.generate(region, made); }));
      std::int64_t steps = 0;
      erosion.push_back(seconds_of([&] {
        steps = terrain::Generator{*world}.generate_to_rest(region, terrain::Neighbours::all, made);
      }));
      row.erosion_steps += static_cast<double>(steps) / seeds;
      progress.advance(static_cast<std::uint64_t>(thesis.side * thesis.side));
    }
    row.slope = spread_of(slope);
    row.erosion = spread_of(erosion);
    table.rows.push_back(row);
  }
  table.erosion_growth = growth(table.rows, &Table1Row::erosion);
  table.slope_growth = growth(table.rows, &Table1Row::slope);
  table.thesis_erosion_growth = growth(table.rows, &Table1Row::thesis_erosion);
  table.thesis_slope_growth = growth(table.rows, &Table1Row::thesis_slope);
  return table;
}

}  // namespace talus::tools
