#include "about.h"

#include <array>
#include <cstddef>
#include <string_view>

#include <talus/local/edits.h>
#include <talus/terrain/extraction.h>
#include <talus/voxel/codec.h>
#include <talus/voxel/content_hash.h>

namespace talus::wasm {
namespace {

// Names of materials have no control characters.
std::string quoted(std::string_view text) {
  std::string json = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') json += '\\';
    json += c;
  }
  return json += '"';
}

template <class Listed>
void add(std::string& list, MaterialId id, const Listed& material) {
  constexpr std::array kKinds{"air", "water", "stratified", "eroded"};
  const terrain::Colour colour = material.colour;
  list += (list.empty() ? "" : ",") + std::string{"{\"id\":"} + std::to_string(to_integer(id)) +
          ",\"name\":" + quoted(material.name) + ",\"colour\":[" + std::to_string(colour.red) + ',' +
          std::to_string(colour.green) + ',' + std::to_string(colour.blue) + "],\"kind\":\"" +
          kKinds[static_cast<std::size_t>(material.kind)] + "\"}";
}

}  // namespace

std::string about(const terrain::World& world) {
  std::string materials;
  for (const terrain::Material& material : world.materials()) add(materials, material.id, material);
  std::string placeables;
  std::size_t index = 0;
  for (const terrain::Placeable& placeable : world.placeables()) {
    add(placeables, local::placeable_id(index++), placeable);
  }
  const HeightRange heights = terrain::height_range(world);
  return "{\"fingerprint\":\"" + to_string(world.fingerprint()) +
         "\",\"generatorVersion\":" + std::to_string(to_integer(world.generator_version())) +
         ",\"codecVersion\":" + std::to_string(kCodecVersion) +
         ",\"heightRange\":{\"low\":" + std::to_string(heights.low) +
         ",\"high\":" + std::to_string(heights.high) + "},\"materials\":[" + materials +
         "],\"placeables\":[" + placeables + "]}";
}

}  // namespace talus::wasm
