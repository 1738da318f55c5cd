#include "surface/scaled_heights.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "spec/spec_errors.h"

namespace talus::terrain {
namespace {

std::optional<std::string> wrong_shape(const HeightMap& map, std::size_t samples) {
  if (map.width < 2 || map.depth < 2 || map.width > kMaxHeightMapSide || map.depth > kMaxHeightMapSide) {
    return text_of("it has ", map.width, " x ", map.depth, " samples; 2 to ", kMaxHeightMapSide, " a side");
  }
  const std::size_t wanted = static_cast<std::size_t>(map.width) * static_cast<std::size_t>(map.depth);
  if (wanted > kMaxHeightMapSamples) {
    return text_of("it has ", wanted, " samples; at most ", kMaxHeightMapSamples);
  }
  if (samples != wanted) return text_of("it has ", samples, " samples where its shape needs ", wanted);
  return std::nullopt;
}

// Returns true for values by which programs such as GDAL mark places without data: as the least or greatest
// sample they would flatten all land.
bool marks_no_data(double sample) {
  constexpr double kBeyondHeights = 1e30;  // the limits of float and double, and what is printed for them
  constexpr std::array kMarks{-9999.0, -99999.0, -32767.0, -32768.0, -2147483648.0};
  return std::abs(sample) >= kBeyondHeights ||
         std::find(kMarks.begin(), kMarks.end(), sample) != kMarks.end();
}

// Keeps the factor of samples finite.
constexpr double kMinRange = 1e-290;

// Operations in double in one fixed order give the same integers on every machine.
template <class Sample>
void scale(const std::vector<Sample>& samples, double low, double high, std::int32_t highest_fx,
           Field& heights) {
  const double factor = highest_fx / (high - low);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double height = (static_cast<double>(samples[i]) - low) * factor;
    heights.values[i] =
        static_cast<std::int32_t>(std::clamp(height, 0.0, static_cast<double>(highest_fx)) + 0.5);
  }
}

}  // namespace

tl::expected<std::shared_ptr<const Field>, HeightsFault> scaled_heights(const HeightMap& map,
                                                                        std::int32_t highest_fx,
                                                                        std::optional<double>& low,
                                                                        std::optional<double>& high) {
  using Heights = tl::expected<std::shared_ptr<const Field>, HeightsFault>;
  return std::visit(
      [&](const auto& samples) -> Heights {
        using Sample = typename std::decay_t<decltype(samples)>::value_type;
        if (auto wrong = wrong_shape(map, samples.size()))
          return tl::unexpected(HeightsFault{"file", *std::move(wrong)});
        const auto wrong_sample = [&](std::size_t i, const std::string& why) {
          const auto width = static_cast<std::size_t>(map.width);
          return tl::unexpected(HeightsFault{"file", text_of("sample ", i % width, " of row ", i / width,
                                                             " is ", static_cast<double>(samples[i]), why)});
        };
        for (std::size_t i = 0; i < samples.size(); ++i) {
          if (std::isfinite(static_cast<double>(samples[i]))) continue;
          return wrong_sample(i, "; only numbers are heights");
        }
        constexpr bool kFullRange = std::is_unsigned_v<Sample>;
        const std::string key = high ? "high" : low ? "low" : "file";
        if constexpr (kFullRange) {
          if (!low) low = 0;
          if (!high) high = std::numeric_limits<Sample>::max();
        } else {
          const auto [least, greatest] = std::minmax_element(samples.begin(), samples.end());
          for (const auto& [given, extreme, name] :
               {std::tuple{&low, least, "low"}, std::tuple{&high, greatest, "high"}}) {
            if (*given) continue;
            *given = static_cast<double>(*extreme);
            if (!marks_no_data(**given)) continue;
            return wrong_sample(static_cast<std::size_t>(extreme - samples.begin()),
                                text_of(", which marks missing data; fill it, or give ", name));
          }
        }
        if (!(*low < *high)) {
          if (key == "file") {
            return tl::unexpected(
                HeightsFault{key, text_of("all samples are ", *low, "; give low and high")});
          }
          return tl::unexpected(
              HeightsFault{key, text_of("low is ", *low, " and high ", *high, "; low must be below high")});
        }
        if (*high - *low < kMinRange) {
          return tl::unexpected(
              HeightsFault{key, text_of("low is ", *low, " and high ", *high, "; high must be at least ",
                                        kMinRange, " above low")});
        }
        auto heights = std::make_shared<Field>(map.width, map.depth);
        scale(samples, *low, *high, highest_fx, *heights);
        return heights;
      },
      map.samples);
}

}  // namespace talus::terrain
