// sRGB (IEC 61966-2-1): converts 8-bit channels to linear light, in which colours can be mixed and lit, and
// back.
#pragma once

#include <cstdint>

namespace talus::pictures {

/// 0 to 1.
[[nodiscard]] float light_of(std::uint8_t channel);
/// The nearest channel value; light outside 0 to 1 is clamped. Uses a table: a power per channel of every
/// pixel would cost more than the drawing.
[[nodiscard]] std::uint8_t channel_of(float light);

}  // namespace talus::pictures
