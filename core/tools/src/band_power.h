// Whether a field of heights looks the same along the axes as along the diagonals, wavelength by wavelength.
#pragma once

#include <optional>
#include <span>
#include <vector>

namespace talus::tools {

inline constexpr int kSpectrumSide = 256;  // samples

/// Power of an octave band in one window of samples. Both are divided by the mean of the whole band, so that
/// windows of mountains and of plains count alike.
struct BandPower {
  double axes = 0;       // mean over wave vectors up to 15 degrees from an axis
  double diagonals = 0;  // up to 15 degrees from a diagonal
};

/// Of waves 8 to 16 samples long; none where there are none, as of a plain. `heights` are kSpectrumSide^2
/// samples. A plane is taken away and a round window laid on, which has no direction of its own.
[[nodiscard]] std::optional<BandPower> band_power(std::span<const double> heights);

struct BandRatio {
  double ratio = 0;  // power along axes : along diagonals
  double error = 0;  // standard
  int windows = 0;
};
/// Over windows; all 0 where there are less than two.
[[nodiscard]] BandRatio ratio_of(std::span<const BandPower> windows);

}  // namespace talus::tools
