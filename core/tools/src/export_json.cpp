#include "export_json.h"

#include <nlohmann/json.hpp>

namespace talus::tools {
namespace {

using Json = nlohmann::ordered_json;

const char* kind_name(terrain::MaterialKind kind) {
  switch (kind) {
    case terrain::MaterialKind::air:
      return "air";
    case terrain::MaterialKind::water:
      return "water";
    case terrain::MaterialKind::stratified:
      return "stratified";
    case terrain::MaterialKind::eroded:
      return "eroded";
  }
  return "";
}

}  // namespace

std::string export_json(const terrain::World& world, const terrain::Region& region,
                        std::span<const MaterialId> layers) {
  Json json;
  json["fingerprint"] = to_string(world.fingerprint());
  json["resolution"] = world.spec().resolution;
  json["origin"] = {region.x, region.z};
  json["size"] = {region.width, region.depth};
  json["y0"] = 0;
  json["halo"] = world.halo();
  json["materials"] = Json::array();
  for (const terrain::Material& material : world.materials()) {
    json["materials"].push_back(
        {{"id", to_integer(material.id)}, {"name", material.name}, {"kind", kind_name(material.kind)}});
  }
  json["layers"] = Json::array();
  for (const MaterialId id : layers) json["layers"].push_back(to_integer(id));
  json["eroded"] = Json::array();
  for (const terrain::LooseSpec& loose : world.loose()) {
    json["eroded"].push_back({{"id", to_integer(loose.material)},
                              {"name", world.materials()[to_integer(loose.material)].name},
                              {"weight", loose.weight},
                              {"t_fx", loose.t_fx},
                              {"S_fx", loose.S_fx},
                              {"c_fx", loose.c_fx}});
  }
  return json.dump(2) + "\n";
}

}  // namespace talus::tools
