// How land looks in pictures: what client_sample/look.json says, which the viewer reads too.
#pragma once

#include <cstdint>
#include <regex>
#include <string_view>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

#include <talus/client/world_info.h>

namespace talus::cli {

/// An sRGB colour, and how much linear light of it.
struct LightColour {
  std::uint32_t rgb = 0;
  float times = 0;
};

/// The light of one height of the sun.
struct LightKey {
  float at = 0;  // sine of the height
  LightColour sunlight, skylight, zenith, horizon, glow;
  float exposure = 0;
};

struct LookRule {
  std::string_view words;  // a regular expression of ECMAScript, for names of materials
  std::string_view look;
};

struct LookTint {
  std::string_view look;
  float grey = 0;  // share of the colour that becomes grey
  glm::vec3 times{1.0F};
};

/// The file's tables, in its order; written by look.cmake.
[[nodiscard]] const std::vector<LightKey>& light_keys();
[[nodiscard]] const std::vector<LookRule>& look_rules();
[[nodiscard]] const std::vector<LookTint>& look_tints();

/// Colours of materials under the sun.
class Looks {
 public:
  Looks();

  /// Linear light that a face of the material throws back of white.
  [[nodiscard]] glm::vec3 colour_of(const client::Material& material) const;

 private:
  std::vector<std::pair<std::regex, const LookTint*>> rules_;  // no tint: null
};

}  // namespace talus::cli
