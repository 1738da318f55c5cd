// sRGB (IEC 61966-2-1): amounts of light, in which colours may be mixed and lit, from 8-bit channels and
// back.
#pragma once

#include <cstdint>

namespace talus::pictures {

/// 0 to 1.
[[nodiscard]] float light_of(std::uint8_t channel);
/// The nearest channel; light beyond 0 to 1 is clamped. A table, because a power for each channel of each
/// pixel would cost more than what is drawn.
[[nodiscard]] std::uint8_t channel_of(float light);

}  // namespace talus::pictures
