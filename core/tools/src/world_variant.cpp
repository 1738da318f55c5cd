#include "world_variant.h"

#include <sstream>
#include <string>
#include <utility>

#include <talus/height_files/height_files.h>
#include <toml++/toml.h>

namespace talus::tools {
namespace {

Expected<terrain::World> parse(const std::string& toml, const std::string& source) {
  auto world = terrain::World::parse(toml, source, height_files::beside(source));
  if (!world) return failed(std::move(world.error().message));
  return std::move(*world);
}

}  // namespace

Expected<terrain::World> world_variant(const WorldText& text, const WorldChanges& changes) {
  // Bounds and faults are the spec's own to find; what passes them is TOML.
  auto unchanged = parse(text.toml, text.source);
  if (!unchanged) return unchanged;
  toml::table document = toml::parse(text.toml);
  std::string source = text.source;
  if (changes.seed) document.insert_or_assign("seed", *changes.seed);
  if (changes.resolution) {
    document.insert_or_assign("resolution", std::int64_t{*changes.resolution});
    source += " at resolution " + std::to_string(*changes.resolution);
  }
  if (auto* surface = document["surface"].as_table(); surface != nullptr && changes.exponent) {
    surface->insert_or_assign("exponent", std::int64_t{*changes.exponent});
  }
  if (auto* materials = document["stratified"].as_array(); materials != nullptr && changes.roughness) {
    for (auto& material : *materials) {
      if (auto* table = material.as_table()) table->insert_or_assign("roughness", *changes.roughness);
    }
  }
  std::ostringstream changed;
  changed << document;
  return parse(changed.str(), source);
}

}  // namespace talus::tools
