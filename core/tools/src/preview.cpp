#include "preview.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>
#include <vector>

#include <talus/progress/progress_bar.h>
#include <talus/terrain/places.h>
#include <talus/tools/option_values.h>

#include <talus/map/column_grid.h>
#include "canvas.h"
#include "colour_scale.h"
#include "map.h"
#include "preview_cards.h"
#include "preview_numbers.h"
#include "profile.h"
#include "sampled_map.h"
#include "section.h"
#include "sheet_style.h"

namespace talus::tools {
namespace {

using namespace sheet;

constexpr int kRoom = 6000;  // initial rows, cut to the used part
constexpr int kTallestSection = 640;
constexpr int kTallestProfile = 460;
constexpr int kUnderground = 56;  // rows below the lowest ground
constexpr int kWideUnderground = 40;
constexpr int kTilesAcross = 9;
constexpr int kTileGap = 20;
constexpr int kTileSide = (kInside - (kTilesAcross - 1) * kTileGap) / kTilesAcross;

// A quantity with the range of its colour scale.
struct Tile {
  std::string name;
  float low = -1;
  float high = 1;
};

Tile tile_of(const std::string& name) {
  if (name == "ranges" || name == "mesas" || name == "terraces") return {name, 0, 1};
  if (name == "temperature") return {name, -1, 1.2F};
  return {name, -1, 1};
}

// Quantities that shape the land come first.
std::vector<std::string> names_in_order(const terrain::World& world) {
  std::vector<std::string> names;
  std::vector<std::string> known = place_names(world);
  for (const char* const name : {"height", "continents", "base", "ranges", "hilliness", "mesas", "terraces",
                                 "temperature", "moisture"}) {
    const auto found = std::find(known.begin(), known.end(), name);
    if (found == known.end()) continue;
    names.push_back(name);
    known.erase(found);
  }
  names.insert(names.end(), known.begin(), known.end());
  return names;
}

const char* name_of(terrain::SurfaceKind kind) {
  switch (kind) {
    case terrain::SurfaceKind::perlin:
      return "perlin";
    case terrain::SurfaceKind::ridged:
      return "ridged";
    case terrain::SurfaceKind::warped:
      return "warped";
    case terrain::SurfaceKind::height_map:
      return "height map";
    case terrain::SurfaceKind::regions:
      return "regions";
  }
  return "";
}

class Sheet {
 public:
  Sheet(const terrain::World& world, std::int64_t x, std::int64_t z, const PreviewOptions& options)
      : world_{world},
        x_{x},
        z_{z},
        options_{options},
        near_{around(Lod{})},
        middle_{around(Lod::of(3))},
        far_{map::grid_around(x, z, 64, kMapSide, kMapSide)},
        canvas_{kWidth, kRoom, kPaper} {}

  Expected<Image> draw(const std::string& name) {
    heading(name);
    maps();
    if (auto drawn = sections(); !drawn) return tl::make_unexpected(drawn.error());
    tiles();
    numbers();
    canvas_.cut(y_ + kMargin);
    return canvas_.image();
  }

 private:
  [[nodiscard]] terrain::Region around(Lod lod) const {
    const int half = kMapSide / 2;
    return {(x_ >> lod.value()) - half, (z_ >> lod.value()) - half, kMapSide, kMapSide, lod};
  }
  [[nodiscard]] std::int32_t zero_fx() const { return world_.sea_fx().value_or(0); }

  void heading(const std::string& name) {
    y_ = kMargin + 30;
    std::string spoken = name;
    std::replace(spoken.begin(), spoken.end(), '_', ' ');
    canvas_.text(kMargin, y_, fitted(spoken, kHeading, kInside - 900), kHeading, kInk);
    const terrain::WorldSpec& spec = world_.spec();
    std::string facts = "seed " + std::to_string(spec.seed) + "   \u00B7   " + name_of(spec.surface.kind) +
                        "   \u00B7   " + words_of("%d", spec.resolution) +
                        (spec.resolution == 1 ? " voxel a unit" : " voxels a unit");
    if (world_.sea_fx()) facts += "   \u00B7   sea at " + counted(*world_.sea_fx() / terrain::kSubvoxels);
    facts += "   \u00B7   centre " + counted(x_) + ", " + counted(z_);
    canvas_.text(kMargin + kInside, y_, facts, kWords, kPale, Align::right);
    y_ += 26;
    canvas_.fill({kMargin, y_, kInside, 2}, kInk);
  }

  void maps() {
    y_ += 44;
    struct Map {
      const char* words;
      std::int64_t every;
      std::int64_t bar;  // length of the scale bar, base columns
      Image image;
    };
    std::vector<Map> all;
    {
      ProgressBar progress{"preview: every column", "columns"};
      all.push_back(
          {"Every column", 1, 100, render_map(world_, near_, {.threads = options_.threads}, progress)});
    }
    {
      ProgressBar progress{"preview: every 8th column", "columns"};
      all.push_back({"1 : 8", 8, 1000, render_map(world_, middle_, {.threads = options_.threads}, progress)});
    }
    {
      ProgressBar progress{"preview: every 64th column", "columns"};
      all.push_back(
          {"1 : 64", 64, 10000, render_sampled_map(world_, far_, {.threads = options_.threads}, progress)});
    }
    int x = kMargin;
    for (const Map& map : all) {
      title(canvas_, x, y_, kMapSide, map.words, counted(map.every * kMapSide) + " columns across");
      const Box box{x, y_ + 16, kMapSide, kMapSide};
      canvas_.picture(box.x, box.y, map.image);
      if (map.every > 1) mark(box);
      scale_bar(box, map.bar, map.every);
      canvas_.frame(box, kInk);
      x += kMapSide + kMapGap;
    }
    // Mark the course of the sections: through the middle of both maps.
    for (const int map_x : {kMargin, kMargin + kMapSide + kMapGap}) {
      for (int i = 0; i < kMapSide; i += 12) {
        canvas_.fill({map_x + i, y_ + 16 + kMapSide / 2, std::min(6, kMapSide - i), 1}, kWhite, 0.7F);
      }
    }
    y_ += 16 + kMapSide;
  }

  // Marks the extent of the previous map.
  void mark(const Box& box) {
    const int side = kMapSide / 8;
    const Box inner{box.x + (kMapSide - side) / 2, box.y + (kMapSide - side) / 2, side, side};
    canvas_.frame({inner.x - 1, inner.y - 1, side + 2, side + 2}, kNight);
    canvas_.frame(inner, kWhite, 2);
    canvas_.frame({inner.x + 2, inner.y + 2, side - 4, side - 4}, kNight);
  }

  void scale_bar(const Box& box, std::int64_t columns, std::int64_t every) {
    const int length = static_cast<int>(columns / every);
    const int x = box.x + 16;
    const int y = box.y + box.height - 18;
    const int words = static_cast<int>(text_width(counted(columns), kSmall));
    canvas_.fill({x - 8, y - 10, length + words + 26, 20}, kNight, 0.5F);
    canvas_.fill({x, y - 2, length, 4}, kWhite);
    canvas_.text(x + length + 10, y + 4, counted(columns), kSmall, kWhite);
  }

  // Rows of base voxels shown by a cut.
  [[nodiscard]] ProfileRows rows_of(const std::vector<std::int32_t>& heights_fx, int underground, int tallest,
                                    bool may_squeeze) const {
    const auto [lowest, highest] = std::minmax_element(heights_fx.begin(), heights_fx.end());
    const int top = std::max(*highest, zero_fx()) / terrain::kSubvoxels + 40;
    const int low = std::max(-8, std::min(*lowest, zero_fx()) / terrain::kSubvoxels - underground);
    const int step = may_squeeze ? (top - low + tallest - 1) / tallest : 1;
    const int rows = std::min(tallest, (top - low) / step);
    return {top - rows * step, rows, step};
  }

  Expected<void> sections() {
    const terrain::Region wide{(x_ >> 3) - kInside / 2, z_ >> 3, kInside, 1, Lod::of(3)};
    const auto wide_heights =
        map::sample_columns(world_, {wide.x * 8, wide.z * 8, 8, kInside, 1}).heights_fx.values;
    const ProfileRows wide_rows =
        rows_of({wide_heights.begin(), wide_heights.end()}, kWideUnderground, kTallestProfile, true);
    {
      ProgressBar progress{"preview: long section", "columns"};
      cut("Long section",
          words_of("west to east through the centre, %s columns, heights %s", counted(kInside * 8).c_str(),
                   wide_rows.step == 1 ? "8 times larger" : words_of("%d : 8", wide_rows.step).c_str()),
          render_profile(world_, wide, wide_rows, options_.threads, progress), wide_rows);
    }
    const terrain::Region line{x_ - kInside / 2, z_, kInside, 1, Lod{}};
    ProgressBar progress{"preview: section", "columns"};
    const auto whole = render_section(world_, line, {.threads = options_.threads}, progress);
    if (!whole) return tl::make_unexpected(whole.error());
    const auto heights = map::sample_columns(world_, {line.x, line.z, 1, kInside, 1}).heights_fx.values;
    ProfileRows rows = rows_of({heights.begin(), heights.end()}, kUnderground, kTallestSection, false);
    // Row 0 is this many pixels above the picture's lower edge (section.h).
    constexpr int kUnderZero = 8;
    const int first = std::max(0, whole->height - kUnderZero - (rows.low + rows.rows));
    rows.rows = std::min(rows.rows, whole->height - first);
    rows.low = whole->height - kUnderZero - first - rows.rows;
    Image shown{kInside, rows.rows};
    for (int y = 0; y < rows.rows; ++y) {
      for (int x = 0; x < kInside; ++x) shown.set(x, y, whole->at(x, first + y));
    }
    cut("Section", words_of("the middle of it, one voxel a pixel, %s columns", counted(kInside).c_str()),
        shown, rows);
    layers();
    return {};
  }

  void cut(const char* words, const std::string& remark, const Image& image, const ProfileRows& rows) {
    y_ += 48;
    title(canvas_, kMargin, y_, kInside, words, remark);
    const Box box{kMargin, y_ + 16, kInside, rows.rows};
    canvas_.picture(box.x, box.y, image);
    // Heights above the sea at the left edge.
    const int zero_row = zero_fx() / terrain::kSubvoxels;
    const int apart = rows.rows * rows.step > 500 ? 100 : 50;
    for (int height = -32 * apart; height <= 640 * apart; height += apart) {
      const int y = rows.rows - (zero_row + height - rows.low) / rows.step;
      if (y < 14 || y > rows.rows - 4) continue;
      canvas_.fill({box.x, box.y + y, 12, 1}, kWhite);
      canvas_.fill({box.x, box.y + y + 1, 12, 1}, kNight, 0.5F);
      canvas_.text_on_picture(box.x + 18, box.y + y + 5, rounded(height), kSmall);
    }
    // Mark both ends of the map of the same columns.
    for (const int x : {(kInside - kMapSide) / 2, (kInside + kMapSide) / 2}) {
      for (int y = 0; y < rows.rows; y += 12) {
        canvas_.fill({box.x + x, box.y + y, 1, std::min(6, rows.rows - y)}, kWhite, 0.6F);
      }
    }
    canvas_.frame(box, kInk);
    y_ += 16 + rows.rows;
  }

  // Colours and names of the layers from the bottom up, then loose material.
  void layers() {
    y_ += 26;
    int x = kMargin;
    for (const terrain::Material& material : world_.materials()) {
      const bool of_file = std::any_of(world_.spec().stratified.begin(), world_.spec().stratified.end(),
                                       [&](const auto& layer) { return layer.name == material.name; }) ||
                           std::any_of(world_.spec().eroded.begin(), world_.spec().eroded.end(),
                                       [&](const auto& layer) { return layer.name == material.name; });
      if (!of_file) continue;
      const int width = 22 + static_cast<int>(text_width(material.name, kSmall));
      if (x > kMargin && x + width > kMargin + kInside) {
        x = kMargin;
        y_ += 24;
      }
      swatch(canvas_, x, y_, material.colour);
      canvas_.text(x + 20, y_, material.name, kSmall, kInk);
      x += width + 22;
    }
  }

  void tiles() {
    const std::vector<std::string> names = names_in_order(world_);
    if (names.size() < 2) return;  // the maps show heights better
    y_ += 52;
    title(canvas_, kMargin, y_, kInside, "Fields and quantities", "of the largest map, with its coasts");
    const std::int64_t every = (far_.every * kMapSide + kTileSide - 1) / kTileSide;
    const map::ColumnSamples samples =
        map::sample_columns(world_, map::grid_around(x_, z_, every, kTileSide, kTileSide), names);
    y_ += 16;
    for (std::size_t n = 0; n < names.size(); ++n) {
      const int across = static_cast<int>(n) % kTilesAcross;
      if (n > 0 && across == 0) y_ += kTileSide + 62;
      const int x = kMargin + across * (kTileSide + kTileGap);
      tile(x, y_, tile_of(names[n]), samples, samples.values[n]);
    }
    y_ += kTileSide + 34;
  }

  void tile(int x, int y, const Tile& what, const map::ColumnSamples& samples,
            const std::vector<float>& values) {
    const bool sea = world_.sea_fx().has_value();
    const bool height = what.name == "height" || what.name == "base";
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    const float low = height ? *least : what.low;
    const float high = height ? *most : what.high;
    if (what.name == "height") top_ = high;
    const auto colour_of = [&](float value) {
      // Plains have no snow, as this is shown next to the heights.
      return height ? colour_of_height(value, low, std::max(high, top_ / 2), sea)
                    : scale_of(what.name).at((value - low) / (high - low));
    };
    for (int k = 0; k < kTileSide; ++k) {
      for (int i = 0; i < kTileSide; ++i) {
        canvas_.fill({x + i, y + k, 1, 1}, colour_of(values[static_cast<std::size_t>(k * kTileSide + i)]));
        if (coast(samples.heights_fx, i, k)) canvas_.fill({x + i, y + k, 1, 1}, kInk, 0.55F);
      }
    }
    canvas_.frame({x, y, kTileSide, kTileSide}, kInk);
    canvas_.text(x, y + kTileSide + 20, fitted(what.name, kWords, kTileSide - 70), kWords, kInk);
    // The scale is below the name, with the numbers at its ends.
    for (int i = 0; i < kTileSide; ++i) {
      const float part = static_cast<float>(i) / static_cast<float>(kTileSide - 1);
      canvas_.fill({x + i, y + kTileSide + 28, 1, 6}, colour_of(low + part * (high - low)));
    }
    const auto voxels = static_cast<float>(world_.spec().resolution);
    const std::string ends = height
                                 ? rounded(voxels * low) + " to " + rounded(voxels * high)
                                 : words_of("%g to %g", static_cast<double>(low), static_cast<double>(high));
    canvas_.text(x + kTileSide, y + kTileSide + 20, ends, kSmall, kPale, Align::right);
  }

  void numbers() {
    y_ += 44;
    canvas_.fill({kMargin, y_, kInside, 1}, kRule);
    y_ += 40;
    const LandNumbers land = [&] {
      ProgressBar progress{"preview: land", "columns"};
      return measure_land(world_, far_, options_.threads, progress);
    }();
    const std::vector<NamedShare> tops = [&] {
      ProgressBar progress{"preview: materials", "columns"};
      return materials_on_top(world_, middle_, options_.threads, progress);
    }();
    const CostNumbers cost = [&] {
      ProgressBar progress{"preview: cost", "squares"};
      return measure_cost(world_, {middle_.x * 8, middle_.z * 8, 8, kMapSide, kMapSide}, progress);
    }();
    y_ = draw_preview_cards(canvas_, y_, world_, land, tops, cost);
  }

  // True for land at the water.
  [[nodiscard]] bool coast(const terrain::Field& heights_fx, int i, int k) const {
    if (!world_.sea_fx() || heights_fx.at(i, k) < *world_.sea_fx()) return false;
    const auto wet = [&](int x, int z) {
      return x >= 0 && z >= 0 && x < heights_fx.width && z < heights_fx.depth &&
             heights_fx.at(x, z) < *world_.sea_fx();
    };
    return wet(i - 1, k) || wet(i + 1, k) || wet(i, k - 1) || wet(i, k + 1);
  }

  const terrain::World& world_;
  std::int64_t x_;
  std::int64_t z_;
  PreviewOptions options_;
  terrain::Region near_;
  terrain::Region middle_;
  map::ColumnGrid far_;
  Canvas canvas_;
  float top_ = 0;  // highest height, for the heights' tile
  int y_ = 0;
};

}  // namespace

Expected<Image> draw_preview(const terrain::World& world, const std::string& name, std::int64_t x,
                             std::int64_t z, const PreviewOptions& options) {
  constexpr std::int64_t kReach = 64 * kMapSide;
  if (auto inside = region_around("--center", {x, z}, {kReach, kReach}, Lod{}); !inside) {
    return tl::make_unexpected(inside.error());
  }
  return Sheet{world, x, z, options}.draw(name);
}

}  // namespace talus::tools
