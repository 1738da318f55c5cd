#include "look.h"

#include <algorithm>
#include <cctype>
#include <string>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "picture.h"

namespace talus::cli {

Looks::Looks() {
  const auto& tints = look_tints();
  for (const LookRule& rule : look_rules()) {
    const auto tint =
        std::find_if(tints.begin(), tints.end(), [&](const LookTint& one) { return one.look == rule.look; });
    rules_.emplace_back(std::regex{rule.words.begin(), rule.words.end()},
                        tint == tints.end() ? nullptr : &*tint);
  }
}

glm::vec3 Looks::colour_of(const client::Material& material) const {
  const glm::vec3 colour = to_light(material.colour);
  std::string name = material.name;
  for (char& letter : name) letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  const auto rule = std::find_if(rules_.begin(), rules_.end(),
                                 [&](const auto& one) { return std::regex_search(name, one.first); });
  if (rule == rules_.end() || rule->second == nullptr) return colour;
  const LookTint& tint = *rule->second;
  const glm::vec3 grey{glm::dot(colour, glm::vec3{0.32F, 0.6F, 0.08F})};
  return glm::mix(colour, grey, tint.grey) * tint.times;
}

}  // namespace talus::cli
