#include "band_power.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>

namespace talus::tools {
namespace {

constexpr auto kSpectrumLine = static_cast<std::size_t>(kSpectrumSide);
constexpr double kLongestWave = kSpectrumSide / 16.0;  // waves per window
constexpr double kShortestWave = kSpectrumSide / 8.0;
constexpr double kSectorDegrees = 15;

using SpectrumSamples = std::vector<std::complex<double>>;

// Cooley-Tukey, in place: `line` has kSpectrumLine values, `stride` apart.
void transform_line(std::complex<double>* line, std::size_t stride) {
  for (std::size_t i = 1, j = 0; i < kSpectrumLine; ++i) {
    std::size_t bit = kSpectrumLine / 2;
    for (; (j & bit) != 0; bit /= 2) j ^= bit;
    j ^= bit;
    if (i < j) std::swap(line[i * stride], line[j * stride]);
  }
  static const SpectrumSamples roots = [] {
    SpectrumSamples all(kSpectrumLine / 2);
    for (std::size_t i = 0; i < all.size(); ++i) {
      all[i] = std::polar(1.0, -2 * std::numbers::pi * static_cast<double>(i) / kSpectrumSide);
    }
    return all;
  }();
  for (std::size_t length = 2; length <= kSpectrumLine; length *= 2) {
    for (std::size_t first = 0; first < kSpectrumLine; first += length) {
      for (std::size_t i = 0; i < length / 2; ++i) {
        auto& low = line[(first + i) * stride];
        auto& high = line[(first + i + length / 2) * stride];
        // Written out: the library's complex product checks for infinities.
        const std::complex<double> root = roots[i * (kSpectrumLine / length)];
        const std::complex<double> turned{high.real() * root.real() - high.imag() * root.imag(),
                                          high.real() * root.imag() + high.imag() * root.real()};
        high = low - turned;
        low += turned;
      }
    }
  }
}

void transform(SpectrumSamples& samples) {
  for (std::size_t z = 0; z < kSpectrumLine; ++z) transform_line(samples.data() + z * kSpectrumLine, 1);
  for (std::size_t x = 0; x < kSpectrumLine; ++x) transform_line(samples.data() + x, kSpectrumLine);
}

double from_middle(std::size_t i) {
  return static_cast<double>(i) - (kSpectrumSide - 1) / 2.0;
}

SpectrumSamples windowed(std::span<const double> heights) {
  double mean = 0;
  double along_x = 0;
  double along_z = 0;
  double squares = 0;
  for (std::size_t i = 0; i < heights.size(); ++i) {
    const double x = from_middle(i % kSpectrumLine);
    const double z = from_middle(i / kSpectrumLine);
    mean += heights[i];
    along_x += heights[i] * x;
    along_z += heights[i] * z;
    squares += x * x;
  }
  mean /= static_cast<double>(heights.size());
  SpectrumSamples samples(heights.size());
  for (std::size_t i = 0; i < heights.size(); ++i) {
    const double x = from_middle(i % kSpectrumLine);
    const double z = from_middle(i / kSpectrumLine);
    const double out = std::min(1.0, std::hypot(x, z) / (kSpectrumSide / 2.0));
    const double cosine = std::cos(out * std::numbers::pi / 2);
    const double weight = cosine * cosine * cosine * cosine;
    samples[i] = weight * (heights[i] - mean - (along_x * x + along_z * z) / squares);
  }
  return samples;
}

}  // namespace

std::optional<BandPower> band_power(std::span<const double> heights) {
  SpectrumSamples samples = windowed(heights);
  transform(samples);
  struct Mean {
    double sum = 0;
    int count = 0;
    void add(double value) { sum += value, ++count; }
    [[nodiscard]] double value() const { return sum / count; }
  };
  Mean axes;
  Mean diagonals;
  Mean all;
  // Half of the plane: the other half is its mirror image.
  for (int kz = 0; kz <= static_cast<int>(kShortestWave); ++kz) {
    for (int kx = -static_cast<int>(kShortestWave); kx <= static_cast<int>(kShortestWave); ++kx) {
      const double k = std::hypot(kx, kz);
      if (k < kLongestWave || k >= kShortestWave || (kz == 0 && kx < 0)) continue;
      const std::size_t x = static_cast<std::size_t>(kx + kSpectrumSide) % kSpectrumLine;
      const double power = std::norm(samples[static_cast<std::size_t>(kz) * kSpectrumLine + x]) * k * k * k;
      all.add(power);  // land has roughly equal values at every wavelength
      const double degrees = std::atan2(std::min(std::abs(kx), kz), std::max(std::abs(kx), kz)) * 180 /
                             std::numbers::pi;  // from the nearest axis, up to 45
      if (degrees <= kSectorDegrees) axes.add(power);
      if (degrees >= 45 - kSectorDegrees) diagonals.add(power);
    }
  }
  if (!(all.sum > 1e-9)) return std::nullopt;
  return BandPower{axes.value() / all.value(), diagonals.value() / all.value()};
}

BandRatio ratio_of(std::span<const BandPower> windows) {
  BandRatio band;
  band.windows = static_cast<int>(windows.size());
  if (windows.size() < 2) return band;
  double axes = 0;
  double diagonals = 0;
  for (const BandPower& window : windows) {
    axes += window.axes;
    diagonals += window.diagonals;
  }
  band.ratio = axes / diagonals;
  double squares = 0;
  for (const BandPower& window : windows) {
    const double left = window.axes - band.ratio * window.diagonals;
    squares += left * left;
  }
  const auto n = static_cast<double>(windows.size());
  band.error = std::sqrt(squares * n / (n - 1)) / diagonals;
  return band;
}

}  // namespace talus::tools
