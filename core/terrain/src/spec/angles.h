// Sine, cosine and tangent of degrees, from additions and multiplications alone: the C library's differ from
// machine to machine, and a last bit could change a world's fingerprint. Private to core/terrain.
#pragma once

namespace talus::terrain {

// Errors are below 2^-51 of the result's unit circle. Degrees may be any finite number.
[[nodiscard]] double sine_of_degrees(double degrees);
[[nodiscard]] double cosine_of_degrees(double degrees);
/// The error of the tangent is relative. REQUIRES: not an odd multiple of 90.
[[nodiscard]] double tangent_of_degrees(double degrees);

}  // namespace talus::terrain
