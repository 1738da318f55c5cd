#include <array>
#include <cmath>
#include <cstdio>
#include <sstream>
#include <utility>

#include <nlohmann/json.hpp>

#include "table1.h"

namespace talus::tools {
namespace {

using Json = nlohmann::ordered_json;

std::string formatted(const char* format, auto... values) {
  std::array<char, 256> text{};
  std::snprintf(text.data(), text.size(), format, values...);
  return text.data();
}

Json json_of(const Spread& seconds) {
  return {{"mean_s", seconds.mean}, {"deviation_s", seconds.deviation}};
}

// In the picture, a decade of seconds is kDecade pixels high, and sides 50 to 200 span kWidth pixels.
constexpr double kWidth = 560;
constexpr double kDecade = 62;
constexpr double kLeft = 70;
constexpr double kTop = 30;
constexpr double kMaxExponent = 2;   // 100 s
constexpr double kMinExponent = -5;  // 10 us

double x_of(int side) {
  return kLeft + kWidth * std::log(side / 50.0) / std::log(200 / 50.0);
}

double y_of(double seconds) {
  return kTop + kDecade * (kMaxExponent - std::log10(seconds));
}

struct Curve {
  const char* name;
  const char* colour;
  const char* dashes;
  Spread Table1Row::*column;
};
constexpr std::array<Curve, 4> kCurves{{{"erosion, thesis", "#c98a6b", "6 4", &Table1Row::thesis_erosion},
                                        {"slope, thesis", "#7f9dbb", "6 4", &Table1Row::thesis_slope},
                                        {"erosion, Talus", "#b4451f", "", &Table1Row::erosion},
                                        {"slope, Talus", "#1f5f9f", "", &Table1Row::slope}}};

void draw_axes(const Table1& table, std::ostringstream& svg) {
  for (int exponent = static_cast<int>(kMinExponent); exponent <= static_cast<int>(kMaxExponent);
       ++exponent) {
    const double y = y_of(std::pow(10.0, exponent));
    svg << formatted("<line x1='%.1f' y1='%.1f' x2='%.1f' y2='%.1f' stroke='#ddd'/>\n", kLeft, y,
                     kLeft + kWidth, y)
        << formatted("<text x='%.1f' y='%.1f' text-anchor='end'>%g s</text>\n", kLeft - 8, y + 4,
                     std::pow(10.0, exponent));
  }
  const double bottom = y_of(std::pow(10.0, kMinExponent));
  for (const Table1Row& row : table.rows) {
    svg << formatted("<text x='%.1f' y='%.1f' text-anchor='middle'>%d</text>\n", x_of(row.side), bottom + 20,
                     row.side);
  }
  svg << formatted("<text x='%.1f' y='%.1f' text-anchor='middle'>columns a side</text>\n", kLeft + kWidth / 2,
                   bottom + 40);
}

void draw_curve(const Table1& table, const Curve& curve, std::ostringstream& svg) {
  std::string points;
  for (const Table1Row& row : table.rows) {
    points += formatted("%.1f,%.1f ", x_of(row.side), y_of((row.*curve.column).mean));
  }
  svg << formatted("<polyline fill='none' stroke='%s' stroke-width='2' stroke-dasharray='%s' points='",
                   curve.colour, curve.dashes)
      << points << "'/>\n";
  for (const Table1Row& row : table.rows) {
    svg << formatted("<circle cx='%.1f' cy='%.1f' r='3' fill='%s'/>\n", x_of(row.side),
                     y_of((row.*curve.column).mean), curve.colour);
  }
  svg << formatted("<text x='%.1f' y='%.1f' fill='%s'>%s</text>\n", kLeft + kWidth + 10,
                   y_of((table.rows.back().*curve.column).mean) + 4, curve.colour, curve.name);
}

}  // namespace

std::string to_text(const Table1& table) {
  std::string text =
      formatted("seconds, mean and standard deviation of %d seeds, one thread\n\n", table.seeds);
  text +=
      "             erosion method                slope method                   erosion   thesis      "
      "thesis     faster than\n";
  text +=
      "  size       mean       sd    steps        mean       sd      /slope   erosion      slope       the "
      "thesis: erosion, slope\n";
  for (const Table1Row& row : table.rows) {
    text += formatted("  %3d^2 %10.4f %8.4f %8.0f  %10.6f %8.6f  %9.0fx  %7.3f    %7.3f      %9.0fx %9.0fx\n",
                      row.side, row.erosion.mean, row.erosion.deviation, row.erosion_steps, row.slope.mean,
                      row.slope.deviation, row.erosion.mean / row.slope.mean, row.thesis_erosion.mean,
                      row.thesis_slope.mean, row.thesis_erosion.mean / row.erosion.mean,
                      row.thesis_slope.mean / row.slope.mean);
  }
  text += formatted(
      "\ngrowth, seconds ~ side^p: erosion p = %.2f (thesis %.2f), slope p = %.2f (thesis %.2f)\n",
      table.erosion_growth, table.thesis_erosion_growth, table.slope_growth, table.thesis_slope_growth);
  return text;
}

std::string to_json(const Table1& table) {
  Json json;
  json["seeds"] = table.seeds;
  json["rows"] = Json::array();
  for (const Table1Row& row : table.rows) {
    json["rows"].push_back({{"side", row.side},
                            {"erosion", json_of(row.erosion)},
                            {"erosion_steps_mean", row.erosion_steps},
                            {"slope", json_of(row.slope)},
                            {"thesis_erosion", json_of(row.thesis_erosion)},
                            {"thesis_slope", json_of(row.thesis_slope)}});
  }
  json["growth"] = {{"erosion", table.erosion_growth},
                    {"slope", table.slope_growth},
                    {"thesis_erosion", table.thesis_erosion_growth},
                    {"thesis_slope", table.thesis_slope_growth}};
  return json.dump(2) + "\n";
}

std::string to_svg(const Table1& table) {
  std::ostringstream svg;
  svg << "<svg xmlns='http://www.w3.org/2000/svg' width='780' height='520' font-family='sans-serif' "
         "font-size='13' "
         "fill='#333'>\n<rect width='780' height='520' fill='#fff'/>\n";
  draw_axes(table, svg);
  for (const Curve& curve : kCurves) draw_curve(table, curve, svg);
  svg << "</svg>\n";
  return svg.str();
}

}  // namespace talus::tools
