// Sine, cosine and tangent of degrees, from operations that IEEE 754 rounds correctly: the C library's
// functions differ from machine to machine, and a last bit could change a world's fingerprint. Private to
// core/terrain.
#pragma once

namespace talus::terrain {

/// The error is below 3e-15. REQUIRES: finite.
[[nodiscard]] double sine_of_degrees(double degrees);
/// The error is below 3e-15. REQUIRES: finite.
[[nodiscard]] double cosine_of_degrees(double degrees);
/// The error is below 1e-10 if the tangent is below 100. REQUIRES: finite, and not an odd multiple of 90.
[[nodiscard]] double tangent_of_degrees(double degrees);

}  // namespace talus::terrain
