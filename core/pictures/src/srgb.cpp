#include <talus/pictures/srgb.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace talus::pictures {
namespace {

class Curve {
 public:
  Curve() {
    for (std::size_t i = 0; i < channels_.size(); ++i) {
      const float light = static_cast<float>(i) / static_cast<float>(channels_.size() - 1);
      const float channel =
          light <= 0.0031308F ? light * 12.92F : 1.055F * std::pow(light, 1 / 2.4F) - 0.055F;
      channels_[i] = static_cast<std::uint8_t>(channel * 255 + 0.5F);
    }
  }
  [[nodiscard]] std::uint8_t at(float light) const {
    const float place = std::clamp(light, 0.0F, 1.0F) * static_cast<float>(channels_.size() - 1);
    return channels_[static_cast<std::size_t>(place + 0.5F)];
  }

 private:
  std::array<std::uint8_t, 8192> channels_{};
};

}  // namespace

float light_of(std::uint8_t channel) {
  const float value = static_cast<float>(channel) / 255;
  return value <= 0.04045F ? value / 12.92F : std::pow((value + 0.055F) / 1.055F, 2.4F);
}

std::uint8_t channel_of(float light) {
  static const Curve curve;
  return curve.at(light);
}

}  // namespace talus::pictures
