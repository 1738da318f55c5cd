// Compares the power of a height field along the axes and along the diagonals, by wavelength.
#pragma once

#include <optional>
#include <span>
#include <vector>

namespace talus::tools {

inline constexpr int kSpectrumSide = 256;  // samples

/// Power of an octave band in one window of samples, divided by the mean of the whole band, so that windows
/// of mountains and of plains have equal weight.
struct BandPower {
  double axes = 0;       // mean over wave vectors up to 15 degrees from an axis
  double diagonals = 0;  // mean over wave vectors up to 15 degrees from a diagonal
};

/// Power of waves 8 to 16 samples long; nullopt if there is no such power, as in a plain. `heights` are
/// kSpectrumSide^2 samples. A fitted plane is subtracted and a circular window applied, which is isotropic.
[[nodiscard]] std::optional<BandPower> band_power(std::span<const double> heights);

struct BandRatio {
  double ratio = 0;  // power along axes : along diagonals
  double error = 0;  // standard error
  int windows = 0;
};
/// Mean over windows; all 0 if there are fewer than two.
[[nodiscard]] BandRatio ratio_of(std::span<const BandPower> windows);

}  // namespace talus::tools
