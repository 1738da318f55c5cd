#include <talus/local/settle_rules.h>

#include <cstdint>
#include <map>

namespace talus::local {

edits::SettleRules settle_rules(const terrain::World& world) {
  static_assert(edits::SettleRule::kUnit == terrain::kSubvoxels);
  std::map<MaterialId, std::int32_t> rises;
  for (const terrain::LooseSpec& loose : world.loose()) {
    rises.emplace(loose.material, loose.c_fx);
    const auto* const shown = world.shown_by(loose.material);
    if (shown == nullptr) continue;
    for (const MaterialId id : shown->by_look) {
      const bool is_loose = world.materials()[to_integer(id)].kind == terrain::MaterialKind::eroded;
      if (is_loose) rises.emplace(id, loose.c_fx);
    }
  }
  edits::SettleRules rules;
  for (const auto& [material, rise] : rises) rules.push_back({material, rise});
  return rules;
}

}  // namespace talus::local
