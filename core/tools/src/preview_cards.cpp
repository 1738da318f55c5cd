#include "preview_cards.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "colour_scale.h"
#include "sheet_style.h"

namespace talus::tools {
namespace {

using namespace sheet;

constexpr int kCardGap = 48;
constexpr int kLine = 25;
constexpr std::size_t kMaxLines = 16;
constexpr double kMinShare = 0.0005;  // minimum share for a line

class PreviewCards {
 public:
  PreviewCards(Canvas& canvas, int y, const terrain::World& world)
      : canvas_{canvas}, world_{world}, sea_{world.sea_fx().has_value()}, y_{y} {}

  int draw(const LandNumbers& land, const std::vector<NamedShare>& tops, const CostNumbers& cost) {
    const int cards = land.looks.empty() ? 3 : 4;
    card_width_ = (kInside - (cards - 1) * kCardGap) / cards;
    const int first = y_;
    int lowest = y_;
    int x = kMargin;
    const auto next = [&] {
      lowest = std::max(lowest, y_);
      y_ = first;
      x += card_width_ + kCardGap;
    };
    if (!land.looks.empty()) {
      shares(x, "Looks", "of land, 1 : 64", land.looks);
      next();
    }
    shares(x, "On top", "materials seen from above, 1 : 8", tops);
    next();
    shape(x, land);
    next();
    costs(x, cost);
    return std::max(lowest, y_);
  }

 private:
  void shares(int x, const char* words, const char* remark, const std::vector<NamedShare>& all) {
    title(canvas_, x, y_, card_width_, words, remark);
    y_ += 14;
    const double most = all.empty() ? 1 : all.front().share;
    double rest = 0;
    std::int64_t more = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (i >= kMaxLines || all[i].share < kMinShare) {
        rest += all[i].share;
        ++more;
        continue;
      }
      y_ += kLine;
      swatch(canvas_, x, y_, all[i].colour);
      canvas_.text(x + 24, y_, fitted(all[i].name, kWords, 176), kWords, kInk);
      bar(x, all[i].share / most, all[i].colour);
      percent(x, all[i].share);
    }
    if (more == 0) return;
    y_ += kLine;
    canvas_.text(x + 24, y_, counted(more) + " more", kWords, kPale);
    percent(x, rest);
  }

  void bar(int x, double part, terrain::Colour colour) {
    constexpr int kLeft = 212;
    const int room = card_width_ - kLeft - 76;
    const int length = std::max(2, static_cast<int>(std::lround(part * room)));
    canvas_.fill({x + kLeft, y_ - 11, length, 12}, colour);
    canvas_.frame({x + kLeft, y_ - 11, length, 12}, kInk);
  }
  void percent(int x, double share) {
    canvas_.text(x + card_width_, y_, words_of(share < 0.0995 ? "%.2f %%" : "%.1f %%", 100 * share), kWords,
                 kInk, Align::right);
  }
  void fact(int x, const std::string& words, const std::string& value) {
    y_ += kLine;
    canvas_.text(x, y_, words, kWords, kInk);
    canvas_.text(x + card_width_, y_, value, kWords, kInk, Align::right);
    canvas_.fill({x, y_ + 8, card_width_, 1}, kRule);
  }

  void shape(int x, const LandNumbers& land) {
    title(canvas_, x, y_, card_width_, "Shape",
          world_.sea_fx() ? "heights over the sea, 1 : 64" : "heights, 1 : 64");
    // One bar per step of height, by square root, or the plains would hide the peaks.
    constexpr int kChart = 120;
    y_ += 22;
    const double most = *std::max_element(land.heights.begin(), land.heights.end());
    const auto steps = static_cast<int>(land.heights.size());
    const auto low = static_cast<float>(land.deepest.voxels);
    const auto high = static_cast<float>(land.highest.voxels);
    for (int i = 0; i < card_width_; ++i) {
      const double share = land.heights[static_cast<std::size_t>(i * steps / card_width_)];
      const int length = static_cast<int>(std::lround(std::sqrt(share / most) * kChart));
      const float height = low + (high - low) * static_cast<float>(i) / static_cast<float>(card_width_);
      canvas_.fill({x + i, y_ + kChart - length, 1, length}, colour_of_height(height, low, high, sea_));
    }
    canvas_.fill({x, y_ + kChart, card_width_, 1}, kInk);
    y_ += kChart + 18;
    canvas_.text(x, y_, rounded(land.deepest.voxels), kSmall, kPale);
    canvas_.text(x + card_width_, y_, rounded(land.highest.voxels), kSmall, kPale, Align::right);
    if (low < 0 && high > 0 && world_.sea_fx()) {
      const int sea =
          x + static_cast<int>(std::lround(-low / (high - low) * static_cast<float>(card_width_)));
      if (sea > x + 50 && sea < x + card_width_ - 50)
        canvas_.text(sea, y_, "0", kSmall, kPale, Align::middle);
    }
    y_ += 4;
    const auto at = [](const HeightAt& place) {
      return rounded(place.voxels) + " at " + counted(place.x) + ", " + counted(place.z);
    };
    fact(x, "highest", at(land.highest));
    fact(x, "highest possible", rounded(land.highest_possible));
    fact(x, "deepest", at(land.deepest));
    fact(x, "water", words_of("%.1f %%", 100 * land.water));
    constexpr std::array kNames{"land above 35\u00B0", "land above 45\u00B0", "land above 60\u00B0"};
    for (std::size_t d = 0; d < kNames.size(); ++d)
      fact(x, kNames[d], words_of("%.1f %%", 100 * land.steep[d]));
    y_ += kLine;
    canvas_.text(x, y_, "Bars: roots of shares of columns.", kSmall, kPale);
    y_ += 20;
    canvas_.text(x, y_, "Slopes: every column of 64 squares of 96 \u00D7 96.", kSmall, kPale);
  }

  void costs(int x, const CostNumbers& cost) {
    title(canvas_, x, y_, card_width_, "Cost", "16 squares of 128 \u00D7 128 columns, 1 : 8");
    y_ += 14;
    fact(x, "ground to stacks", words_of("%.1f ns a column", cost.ns_a_column));
    fact(x, "stacks to bytes", words_of("%.1f \u00B5s a mixed chunk", cost.ns_a_chunk / 1000));
    fact(x, "encoded", words_of("%.0f bytes a mixed chunk", cost.bytes_a_chunk));
    fact(x, "largest", counted(cost.max_bytes) + " bytes");
    fact(x, "mixed chunks over 32 \u00D7 32 columns", words_of("%.2f", cost.chunks_a_column));
    y_ += kLine;
    canvas_.text(x, y_, "CPU time of one thread, measured on this machine", kSmall, kPale);
    y_ += 20;
    canvas_.text(x, y_, "as the sheet was drawn. Mixed: not uniform.", kSmall, kPale);
    y_ += 36;
    title(canvas_, x, y_, card_width_, "World", "");
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

  Canvas& canvas_;
  const terrain::World& world_;
  bool sea_;
  int card_width_ = 0;
  int y_;
};

}  // namespace

int draw_preview_cards(Canvas& canvas, int y, const terrain::World& world, const LandNumbers& land,
                       const std::vector<NamedShare>& tops, const CostNumbers& cost) {
  return PreviewCards{canvas, y, world}.draw(land, tops, cost);
}

}  // namespace talus::tools
