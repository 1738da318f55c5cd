#include "palette.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <span>

#include <talus/pictures/png.h>

namespace talus::tools {
namespace {

constexpr std::size_t kColours = 256;
constexpr int kBits = 7;  // per channel, for distinguishing colours
constexpr std::uint32_t kUnused = std::numeric_limits<std::uint32_t>::max();

using Channels = std::array<std::int64_t, 3>;

// Pixels of one cell(), whose channels differ only in the lowest bits. Integer arithmetic only, so that
// palettes are the same on every machine.
struct Shade {
  Channels sum{};
  std::int64_t pixels = 0;
  std::uint8_t colour = 0;
  [[nodiscard]] std::int64_t mean(std::size_t channel) const { return sum[channel] / pixels; }
};

std::size_t cell(terrain::Colour colour) {
  constexpr int kDropped = 8 - kBits;
  return (static_cast<std::size_t>(colour.red >> kDropped) << (2 * kBits)) |
         (static_cast<std::size_t>(colour.green >> kDropped) << kBits) |
         static_cast<std::size_t>(colour.blue >> kDropped);
}

// Shades that will share one colour.
struct Box {
  std::span<Shade> shades;
  std::size_t axis = 0;     // axis of the greatest difference
  std::int64_t middle = 0;  // mean along this axis
  std::int64_t spread = 0;  // sum of squared deviations, weighted by pixels
};

Box box_of(std::span<Shade> shades) {
  Box box{shades};
  std::int64_t pixels = 0;
  Channels sum{};
  for (const Shade& shade : shades) {
    pixels += shade.pixels;
    for (std::size_t c = 0; c < 3; ++c) sum[c] += shade.sum[c];
  }
  for (std::size_t c = 0; c < 3; ++c) {
    const std::int64_t mean = sum[c] / pixels;
    std::int64_t spread = 0;
    for (const Shade& shade : shades) {
      const std::int64_t away = shade.mean(c) - mean;
      spread += away * away * shade.pixels;
    }
    if (c == 0 || spread > box.spread) {
      box.axis = c;
      box.middle = mean;
      box.spread = spread;
    }
  }
  return box;
}

// Halves the box with the greatest spread until there are as many boxes as colours.
std::vector<Box> cut_boxes(std::span<Shade> shades) {
  std::vector<Box> boxes{box_of(shades)};
  while (boxes.size() < kColours) {
    const auto widest = std::max_element(boxes.begin(), boxes.end(),
                                         [](const Box& a, const Box& b) { return a.spread < b.spread; });
    if (widest->spread == 0) break;
    const Box box = *widest;
    const auto upper = std::stable_partition(box.shades.begin(), box.shades.end(), [&](const Shade& shade) {
      return shade.mean(box.axis) <= box.middle;
    });
    const auto low = static_cast<std::size_t>(upper - box.shades.begin());
    // Means are rounded down: both parts contain shades, unless all means are equal.
    if (low == 0 || low == box.shades.size()) {
      widest->spread = 0;
      continue;
    }
    *widest = box_of(box.shades.first(low));
    boxes.push_back(box_of(box.shades.subspan(low)));
  }
  return boxes;
}

Channels mean_of(std::span<const Shade> shades) {
  Channels sum{};
  std::int64_t pixels = 0;
  for (const Shade& shade : shades) {
    pixels += shade.pixels;
    for (std::size_t c = 0; c < 3; ++c) sum[c] += shade.sum[c];
  }
  for (std::int64_t& channel : sum) channel = (channel + pixels / 2) / pixels;
  return sum;
}

std::uint8_t nearest(const std::vector<Channels>& colours, const Shade& shade) {
  std::size_t best = 0;
  std::int64_t least = std::numeric_limits<std::int64_t>::max();
  for (std::size_t i = 0; i < colours.size(); ++i) {
    std::int64_t distance = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const std::int64_t away = shade.mean(c) - colours[i][c];
      distance += away * away;
    }
    if (distance >= least) continue;
    least = distance;
    best = i;
  }
  return static_cast<std::uint8_t>(best);
}

}  // namespace

PalettedImage to_palette(const Image& image) {
  std::vector<std::uint32_t> shade_of(std::size_t{1} << (3 * kBits), kUnused);
  std::vector<Shade> shades;
  const auto each_pixel = [&](const auto& visit) {
    for (int y = 0; y < image.height; ++y) {
      for (int x = 0; x < image.width; ++x) visit(image.at(x, y));
    }
  };
  each_pixel([&](terrain::Colour colour) {
    std::uint32_t& shade = shade_of[cell(colour)];
    if (shade == kUnused) {
      shade = static_cast<std::uint32_t>(shades.size());
      shades.emplace_back();
    }
    Shade& counted = shades[shade];
    counted.sum[0] += colour.red;
    counted.sum[1] += colour.green;
    counted.sum[2] += colour.blue;
    ++counted.pixels;
  });

  std::vector<Shade> cut = shades;  // cutting changes the order
  std::vector<Channels> colours;
  for (const Box& box : cut_boxes(cut)) colours.push_back(mean_of(box.shades));
  for (Shade& shade : shades) shade.colour = nearest(colours, shade);

  PalettedImage paletted{image.width, image.height, {}, {}};
  for (const Channels& colour : colours) {
    paletted.palette.push_back({static_cast<std::uint8_t>(colour[0]), static_cast<std::uint8_t>(colour[1]),
                                static_cast<std::uint8_t>(colour[2])});
  }
  paletted.pixels.reserve(image.rgb.size() / 3);
  each_pixel(
      [&](terrain::Colour colour) { paletted.pixels.push_back(shades[shade_of[cell(colour)]].colour); });
  return paletted;
}

Expected<void> write(PngFile& file, const PalettedImage& image) {
  std::vector<std::uint8_t> palette;
  for (const terrain::Colour colour : image.palette) {
    palette.insert(palette.end(), {colour.red, colour.green, colour.blue});
  }
  return file.write(pictures::PngImage{
      .width = image.width, .height = image.height, .indices = image.pixels, .palette = palette});
}

}  // namespace talus::tools
