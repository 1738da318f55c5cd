#include "preview.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>
#include <vector>

#include <talus/progress/progress_bar.h>
#include <talus/terrain/places.h>

#include "canvas.h"
#include "colour_scale.h"
#include "column_grid.h"
#include "map.h"
#include "map_light.h"
#include "option_values.h"
#include "preview_numbers.h"
#include "sampled_map.h"
#include "section.h"

namespace talus::tools {
namespace {

using terrain::Colour;

constexpr int kMargin = 56;
constexpr int kMapSide = 616;
constexpr int kMapGap = 32;
constexpr int kInside = 3 * kMapSide + 2 * kMapGap;
constexpr int kSheetWidth = kInside + 2 * kMargin;
constexpr int kRoom = 6000;  // rows, cut to what is used
constexpr int kTallestSection = 640;
constexpr int kSectionUnderground = 56;
constexpr int kTilesAcross = 9;
constexpr int kTileGap = 20;
constexpr int kTileSide = (kInside - (kTilesAcross - 1) * kTileGap) / kTilesAcross;
constexpr int kCards = 4;
constexpr int kCardGap = 48;
constexpr int kCardWidth = (kInside - (kCards - 1) * kCardGap) / kCards;
constexpr int kLine = 25;
constexpr int kMostLines = 16;

constexpr Colour kPaper{246, 243, 236};
constexpr Colour kInk{38, 42, 50};
constexpr Colour kPale{122, 122, 120};
constexpr Colour kRule{214, 208, 196};
constexpr Colour kBar{168, 160, 146};

constexpr pictures::TextStyle kHeading{30, 3.2F};
constexpr pictures::TextStyle kTitle{15, 2};
constexpr pictures::TextStyle kWords{11, 1.4F};
constexpr pictures::TextStyle kSmall{10, 1.25F};

template <typename... Values>
std::string words_of(const char* format, Values... values) {
  std::array<char, 256> text{};
  std::snprintf(text.data(), text.size(), format, values...);
  return text.data();
}

// 39,424: thousands apart.
std::string counted(std::int64_t number) {
  std::string digits = std::to_string(std::abs(number));
  for (std::size_t at = digits.size(); at > 3;) digits.insert(at -= 3, ",");
  return number < 0 ? "\u2212" + digits : digits;
}

std::string signed_number(double number) {
  return counted(std::lround(number));
}

// A quantity as the pictures of it need it.
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

// Those that shape the land first.
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
        far_{grid_around(x, z, 64, kMapSide, kMapSide)},
        canvas_{kSheetWidth, kRoom, kPaper} {}

  Expected<Image> draw(const std::string& name) {
    heading(name);
    maps();
    if (auto drawn = section(); !drawn) return tl::make_unexpected(drawn.error());
    tiles();
    cards();
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
    canvas_.text(kMargin, y_, fitted(name, kHeading, kInside - 700), kHeading, kInk);
    const terrain::WorldSpec& spec = world_.spec();
    std::string facts = "seed " + std::to_string(spec.seed) + "   \u00B7   " + name_of(spec.surface.kind) +
                        "   \u00B7   " + words_of("%d", spec.resolution) +
                        (spec.resolution == 1 ? " voxel a unit" : " voxels a unit");
    if (world_.sea_fx()) facts += "   \u00B7   sea at " + counted(*world_.sea_fx() / terrain::kSubvoxels);
    facts += "   \u00B7   centre " + counted(x_) + ", " + counted(z_);
    canvas_.text(kMargin + kInside, y_, facts, kWords, kPale, Align::right);
    y_ += 22;
    canvas_.fill({kMargin, y_, kInside, 2}, kInk);
  }

  // A title with a remark behind it, on a line of its own.
  void title(int x, int y, int width, const std::string& words, const std::string& remark) {
    canvas_.text(x, y, words, kTitle, kInk);
    const int used = static_cast<int>(text_width(words, kTitle)) + 16;
    canvas_.text(x + used, y, fitted(remark, kSmall, width - used), kSmall, kPale);
  }

  void maps() {
    y_ += 44;
    struct Map {
      const char* words;
      std::int64_t every;
      std::int64_t bar;  // base columns
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
      title(x, y_, kMapSide, map.words, counted(map.every * kMapSide) + " columns across");
      const Box box{x, y_ + 16, kMapSide, kMapSide};
      canvas_.picture(box.x, box.y, map.image);
      if (map.every > 1) mark(box);
      scale_bar(box, map.bar, map.every);
      canvas_.frame(box, kInk);
      x += kMapSide + kMapGap;
    }
    // Where the section runs: through the middle of the first map, and as far as it goes on the second.
    for (int i = 0; i < kMapSide; i += 12) {
      canvas_.fill({kMargin + i, y_ + 16 + kMapSide / 2, 6, 1}, {255, 255, 255}, 0.7F);
    }
    y_ += 16 + kMapSide;
  }

  // What the map before shows.
  void mark(const Box& box) {
    const int side = kMapSide / 8;
    const Box inner{box.x + (kMapSide - side) / 2, box.y + (kMapSide - side) / 2, side, side};
    canvas_.frame({inner.x - 1, inner.y - 1, side + 2, side + 2}, {20, 24, 30});
    canvas_.frame(inner, {255, 255, 255}, 2);
    canvas_.frame({inner.x + 2, inner.y + 2, side - 4, side - 4}, {20, 24, 30});
  }

  void scale_bar(const Box& box, std::int64_t columns, std::int64_t every) {
    const int length = static_cast<int>(columns / every);
    const int x = box.x + 16;
    const int y = box.y + box.height - 18;
    canvas_.fill({x - 2, y - 2, length + 4, 8}, {20, 24, 30}, 0.55F);
    canvas_.fill({x, y, length, 4}, {255, 255, 255});
    canvas_.text_on_picture(x + length + 10, y + 5, counted(columns), kSmall);
  }

  Expected<void> section() {
    const terrain::Region line{x_ - kInside / 2, z_, kInside, 1, Lod{}};
    ProgressBar progress{"preview: section", "columns"};
    auto cut = render_section(world_, line, {.threads = options_.threads}, progress);
    if (!cut) return tl::make_unexpected(cut.error());
    const auto heights = sample_columns(world_, {line.x, line.z, 1, kInside, 1}).heights_fx.values;
    const auto [lowest, highest] = std::minmax_element(heights.begin(), heights.end());
    // Row 0 is that many pixels over the picture's lower edge (section.h).
    constexpr int kUnderZero = 8;
    const int top_row = std::max(*highest, zero_fx()) / terrain::kSubvoxels + 40;
    const int low_row =
        std::max({-kUnderZero, std::min(*lowest, zero_fx()) / terrain::kSubvoxels - kSectionUnderground,
                  top_row - kTallestSection});
    const int first = std::max(0, cut->height - kUnderZero - top_row);
    const int rows = std::min(cut->height - first, top_row - low_row);
    Image shown{kInside, rows};
    for (int y = 0; y < rows; ++y) {
      for (int x = 0; x < kInside; ++x) shown.set(x, y, cut->at(x, first + y));
    }
    y_ += 48;
    title(
        kMargin, y_, kInside, "Section",
        words_of("west to east through the centre, one voxel a pixel, %s columns", counted(kInside).c_str()));
    const Box box{kMargin, y_ + 16, kInside, rows};
    canvas_.picture(box.x, box.y, shown);
    // Heights over the sea at the left edge.
    const int zero_row = zero_fx() / terrain::kSubvoxels;
    const int row_at_top = cut->height - kUnderZero - first;
    for (int height = -1000; height <= 2000; height += 50) {
      const int y = row_at_top - (zero_row + height);
      if (y < 14 || y > rows - 4) continue;
      canvas_.fill({box.x, box.y + y, 12, 1}, {255, 255, 255});
      canvas_.fill({box.x, box.y + y + 1, 12, 1}, {20, 24, 30}, 0.5F);
      canvas_.text_on_picture(box.x + 18, box.y + y + 5, signed_number(height), kSmall);
    }
    // Where the first map ends on both sides.
    for (const int x : {(kInside - kMapSide) / 2, (kInside + kMapSide) / 2}) {
      for (int y = 0; y < rows; y += 12) canvas_.fill({box.x + x, box.y + y, 1, 6}, {255, 255, 255}, 0.6F);
    }
    canvas_.frame(box, kInk);
    y_ += 16 + rows;
    layers();
    return {};
  }

  // The layers' colours and names from the bottom up, then loose material.
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
      swatch(x, y_, material.colour);
      canvas_.text(x + 20, y_, material.name, kSmall, kInk);
      x += width + 22;
    }
  }

  void swatch(int x, int y, Colour colour) {
    canvas_.fill({x, y - 12, 14, 14}, colour);
    canvas_.frame({x, y - 12, 14, 14}, kInk);
  }

  void tiles() {
    y_ += 52;
    const std::vector<std::string> names = names_in_order(world_);
    title(kMargin, y_, kInside, names.size() > 1 ? "Fields and quantities" : "Heights",
          "of the largest map, with its coasts");
    const std::int64_t every = (far_.every * kMapSide + kTileSide - 1) / kTileSide;
    const ColumnSamples samples =
        sample_columns(world_, grid_around(x_, z_, every, kTileSide, kTileSide), names);
    y_ += 16;
    for (std::size_t n = 0; n < names.size(); ++n) {
      const int across = static_cast<int>(n) % kTilesAcross;
      if (n > 0 && across == 0) y_ += kTileSide + 62;
      const int x = kMargin + across * (kTileSide + kTileGap);
      tile(x, y_, tile_of(names[n]), samples, samples.values[n]);
    }
    y_ += kTileSide + 46;
  }

  void tile(int x, int y, const Tile& what, const ColumnSamples& samples, const std::vector<float>& values) {
    const bool height = what.name == "height" || what.name == "base";
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    for (int k = 0; k < kTileSide; ++k) {
      for (int i = 0; i < kTileSide; ++i) {
        const float value = values[static_cast<std::size_t>(k * kTileSide + i)];
        canvas_.fill({x + i, y + k, 1, 1},
                     height ? colour_of_height(value, *low, *high)
                            : scale_of(what.name).at((value - what.low) / (what.high - what.low)));
        if (coast(samples.heights_fx, i, k)) canvas_.fill({x + i, y + k, 1, 1}, kInk, 0.55F);
      }
    }
    canvas_.frame({x, y, kTileSide, kTileSide}, kInk);
    canvas_.text(x, y + kTileSide + 20, fitted(what.name, kWords, kTileSide - 70), kWords, kInk);
    // The scale lies under the name, its ends at the numbers.
    const int bar = y + kTileSide + 28;
    for (int i = 0; i < kTileSide; ++i) {
      const float part = static_cast<float>(i) / static_cast<float>(kTileSide - 1);
      canvas_.fill({x + i, bar, 1, 6}, height ? colour_of_height(*low + part * (*high - *low), *low, *high)
                                              : scale_of(what.name).at(part));
    }
    const std::string ends =
        height ? signed_number(*low) + " to " + signed_number(*high)
               : words_of("%g to %g", static_cast<double>(what.low), static_cast<double>(what.high));
    canvas_.text(x + kTileSide, y + kTileSide + 20, ends, kSmall, kPale, Align::right);
  }

  [[nodiscard]] Colour colour_of_height(float value, float low, float high) const {
    if (value < 0 && world_.sea_fx()) return depths().at(1 - value / std::min(low, -1.0F));
    const float bottom = world_.sea_fx() ? 0 : low;
    return elevations().at(std::sqrt((value - bottom) / std::max(high - bottom, 1e-3F)));
  }

  // Land at the water.
  [[nodiscard]] bool coast(const terrain::Field& heights_fx, int i, int k) const {
    if (!world_.sea_fx() || heights_fx.at(i, k) < *world_.sea_fx()) return false;
    const auto wet = [&](int x, int z) {
      return x >= 0 && z >= 0 && x < heights_fx.width && z < heights_fx.depth &&
             heights_fx.at(x, z) < *world_.sea_fx();
    };
    return wet(i - 1, k) || wet(i + 1, k) || wet(i, k - 1) || wet(i, k + 1);
  }

  void cards() {
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
    const int first = y_;
    int lowest = y_;
    const auto card = [&](int index) {
      y_ = first;
      return kMargin + index * (kCardWidth + kCardGap);
    };
    const auto end = [&] { lowest = std::max(lowest, y_); };
    shares(card(0), "Looks", land.looks.empty() ? "this world has none" : "of land, 1 : 64", land.looks);
    end();
    shares(card(1), "On top", "materials seen from above, 1 : 8", tops);
    end();
    shape(card(2), land);
    end();
    costs(card(3), cost);
    end();
    y_ = lowest;
  }

  void shares(int x, const char* words, const char* remark, const std::vector<NamedShare>& all) {
    title(x, y_, kCardWidth, words, remark);
    y_ += 14;
    const double most = all.empty() ? 1 : all.front().share;
    double rest = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (i + 1 > kMostLines && all.size() > kMostLines) {
        rest += all[i].share;
        continue;
      }
      y_ += kLine;
      swatch(x, y_, all[i].colour);
      canvas_.text(x + 24, y_, fitted(all[i].name, kWords, 176), kWords, kInk);
      bar(x, all[i].share / most, all[i].colour);
      percent(x, all[i].share);
    }
    if (rest <= 0) return;
    y_ += kLine;
    canvas_.text(x + 24, y_, counted(static_cast<std::int64_t>(all.size()) - kMostLines) + " more", kWords,
                 kPale);
    percent(x, rest);
  }

  void bar(int x, double part, Colour colour) {
    constexpr int kLeft = 212;
    const int room = kCardWidth - kLeft - 76;
    const int length = std::max(2, static_cast<int>(std::lround(part * room)));
    canvas_.fill({x + kLeft, y_ - 11, length, 12}, colour);
    canvas_.frame({x + kLeft, y_ - 11, length, 12}, kInk);
  }
  void percent(int x, double share) {
    canvas_.text(x + kCardWidth, y_, words_of(share < 0.0995 ? "%.2f %%" : "%.1f %%", 100 * share), kWords,
                 kInk, Align::right);
  }
  void fact(int x, const std::string& words, const std::string& value) {
    y_ += kLine;
    canvas_.text(x, y_, words, kWords, kInk);
    canvas_.text(x + kCardWidth, y_, value, kWords, kInk, Align::right);
    canvas_.fill({x, y_ + 8, kCardWidth, 1}, kRule);
  }

  void shape(int x, const LandNumbers& land) {
    title(x, y_, kCardWidth, "Shape", world_.sea_fx() ? "heights over the sea, 1 : 64" : "heights, 1 : 64");
    // A bar a step of height; square roots, or the plains would hide the peaks.
    constexpr int kChart = 120;
    y_ += 22;
    const double most = *std::max_element(land.heights.begin(), land.heights.end());
    const auto steps = static_cast<int>(land.heights.size());
    const auto low = static_cast<float>(land.deepest.voxels);
    const auto high = static_cast<float>(land.highest.voxels);
    for (int i = 0; i < kCardWidth; ++i) {
      const double share = land.heights[static_cast<std::size_t>(i * steps / kCardWidth)];
      const int length = static_cast<int>(std::lround(std::sqrt(share / most) * kChart));
      const float height = low + (high - low) * static_cast<float>(i) / kCardWidth;
      canvas_.fill({x + i, y_ + kChart - length, 1, length}, colour_of_height(height, low, high));
    }
    canvas_.fill({x, y_ + kChart, kCardWidth, 1}, kInk);
    y_ += kChart + 18;
    canvas_.text(x, y_, signed_number(land.deepest.voxels), kSmall, kPale);
    canvas_.text(x + kCardWidth, y_, signed_number(land.highest.voxels), kSmall, kPale, Align::right);
    if (low < 0 && high > 0 && world_.sea_fx()) {
      const int sea = x + static_cast<int>(std::lround(-low / (high - low) * kCardWidth));
      if (sea > x + 50 && sea < x + kCardWidth - 50) canvas_.text(sea, y_, "0", kSmall, kPale, Align::middle);
    }
    y_ += 4;
    const auto at = [](const HeightAt& place) {
      return signed_number(place.voxels) + " at " + counted(place.x) + ", " + counted(place.z);
    };
    fact(x, "highest", at(land.highest));
    fact(x, "deepest", at(land.deepest));
    fact(x, "water", words_of("%.1f %%", 100 * land.water));
    constexpr std::array kNames{"land above 35\u00B0", "land above 45\u00B0", "land above 60\u00B0"};
    for (std::size_t d = 0; d < kNames.size(); ++d)
      fact(x, kNames[d], words_of("%.1f %%", 100 * land.steep[d]));
    y_ += kLine;
    canvas_.text(x, y_, "Slopes: every column of 64 squares of 96 \u00D7 96.", kSmall, kPale);
  }

  void costs(int x, const CostNumbers& cost) {
    title(x, y_, kCardWidth, "Cost", "16 squares of 128 \u00D7 128 columns, 1 : 8");
    y_ += 14;
    fact(x, "ground to stacks", words_of("%.1f ns a column", cost.ns_a_column));
    fact(x, "stacks to bytes", words_of("%.1f \u00B5s a chunk", cost.ns_a_chunk / 1000));
    fact(x, "encoded", words_of("%.0f bytes a chunk", cost.bytes_a_chunk));
    fact(x, "largest", counted(cost.most_bytes) + " bytes");
    fact(x, "chunks over 32 \u00D7 32 columns", words_of("%.2f", cost.chunks_a_column));
    y_ += kLine;
    canvas_.text(x, y_, "CPU time of one thread, measured on this machine", kSmall, kPale);
    y_ += 20;
    canvas_.text(x, y_, "as the sheet was drawn. Chunks that are not uniform.", kSmall, kPale);
    y_ += 36;
    title(x, y_, kCardWidth, "World", "");
    y_ += 14;
    const auto facts_of = [](std::size_t number) { return counted(static_cast<std::int64_t>(number)); };
    fact(x, "materials", facts_of(world_.materials().size()));
    fact(x, "layers of rock", facts_of(world_.strata().size()));
    fact(x, "features", facts_of(world_.features().size()));
    fact(x, "halo", counted(world_.halo()) + " columns");
    fact(x, "generator version", words_of("%d", to_integer(world_.generator_version())));
    const std::string hash = to_string(world_.fingerprint());
    fact(x, "fingerprint", hash.substr(0, 16));
  }

  const terrain::World& world_;
  std::int64_t x_;
  std::int64_t z_;
  PreviewOptions options_;
  terrain::Region near_;
  terrain::Region middle_;
  ColumnGrid far_;
  Canvas canvas_;
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
