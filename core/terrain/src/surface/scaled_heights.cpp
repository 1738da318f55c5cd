#include "surface/scaled_heights.h"

#include <algorithm>
#include <cmath>
#include <limits>
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
        for (std::size_t i = 0; i < samples.size(); ++i) {
          if (std::isfinite(static_cast<double>(samples[i]))) continue;
          const std::size_t width = static_cast<std::size_t>(map.width);
          return tl::unexpected(
              HeightsFault{"file", text_of("sample ", i % width, " of row ", i / width, " is ", samples[i],
                                           "; only numbers are heights")});
        }
        const auto [least, greatest] = std::minmax_element(samples.begin(), samples.end());
        constexpr bool kWhole = std::is_same_v<Sample, std::uint16_t>;
        const std::string key = high ? "high" : low ? "low" : "file";
        if (!low) low = kWhole ? 0.0 : static_cast<double>(*least);
        if (!high) high = kWhole ? 65535.0 : static_cast<double>(*greatest);
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
