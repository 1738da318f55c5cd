#include "world_variant.h"

#include <sstream>
#include <string>
#include <utility>

#include <talus/world_files/world_files.h>
#include <toml++/toml.h>

namespace talus::tools {
namespace {

// Describes the changes for errors: ": at resolution 400".
std::string told(const WorldChanges& changes) {
  std::string text;
  const auto add = [&](const char* name, const auto& change) {
    if (!change) return;
    std::ostringstream value;
    value << *change;
    text += (text.empty() ? ": at " : ", ") + (name + (" " + value.str()));
  };
  add("seed", changes.seed);
  add("resolution", changes.resolution);
  add("exponent", changes.exponent);
  add("roughness", changes.roughness);
  add("erosion_steps", changes.erosion_steps);
  return text;
}

}  // namespace

Expected<terrain::World> world_variant(const WorldText& text, const WorldChanges& changes) {
  // World::parse() reports errors of the text. Text that it accepts is TOML.
  if (auto unchanged = terrain::World::parse(text.toml, text.source, world_files::beside(text.source));
      !unchanged) {
    return failed(std::move(unchanged.error().message));
  }
  toml::table document = toml::parse(text.toml);
  if (changes.seed) document.insert_or_assign("seed", *changes.seed);
  if (changes.resolution) {
    document.insert_or_assign("resolution", std::int64_t{*changes.resolution});
  }
  if (changes.erosion_steps) {
    document.insert_or_assign("method", "erosion");
    document.insert_or_assign("erosion_steps", std::int64_t{*changes.erosion_steps});
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
  auto world = terrain::World::parse(changed.str(), "", world_files::beside(text.source));
  if (world) return std::move(*world);
  // The message begins with ":LINE: ", a line of generated text.
  const std::string& message = world.error().message;
  return failed(text.source + told(changes) + ": " + message.substr(message.find(": ") + 2));
}

}  // namespace talus::tools
