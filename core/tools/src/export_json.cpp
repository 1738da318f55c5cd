#include "export_json.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <tuple>
#include <utility>

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

const char* type_name(files::NpyType type) {
  switch (type) {
    case files::NpyType::int32:
      return "int32";
    case files::NpyType::uint8:
      return "uint8";
    case files::NpyType::uint16:
      return "uint16";
    case files::NpyType::float32:
      return "float32";
    case files::NpyType::float64:
      return "float64";
  }
  return "";
}

Json ids_of(const std::vector<MaterialId>& materials) {
  Json ids = Json::array();
  for (const MaterialId id : materials) ids.push_back(to_integer(id));
  return ids;
}

Json told_materials(const terrain::World& world) {
  Json told = Json::array();
  for (const terrain::Material& material : world.materials()) {
    told.push_back(
        {{"id", to_integer(material.id)}, {"name", material.name}, {"kind", kind_name(material.kind)}});
  }
  return told;
}

Json told_eroded(const terrain::World& world, Lod lod) {
  Json told = Json::array();
  for (const terrain::LooseSpec& loose : world.loose()) {
    told.push_back({{"id", to_integer(loose.material)},
                    {"name", world.materials()[to_integer(loose.material)].name},
                    {"weight", loose.weight},
                    {"t_fx", loose.t_fx},
                    {"S_fx", loose.steepest_at(lod)},
                    {"c_fx", loose.c_fx}});
  }
  return told;
}

Json told_arrays(const ExportPlan& plan, std::size_t rows) {
  Json told = Json::object();
  for (const PlannedArray& array : plan.arrays) {
    told[array.file] = {{"dtype", type_name(array.type)},
                        {"shape", shape_of(plan, array, rows)},
                        {"axes", array.axis.empty() ? "[z][x]" : "[" + array.axis + "][z][x]"},
                        {"unit", array.unit},
                        {"meaning", array.meaning}};
  }
  return told;
}

}  // namespace

std::vector<std::size_t> shape_of(const ExportPlan& plan, const PlannedArray& array, std::size_t rows) {
  std::vector<std::size_t> shape;
  if (array.slices) shape.push_back(array.array == ExportArray::voxels ? rows : *array.slices);
  shape.push_back(static_cast<std::size_t>(plan.region.depth));
  shape.push_back(static_cast<std::size_t>(plan.region.width));
  return shape;
}

std::string export_json(const ExportPlan& plan, std::size_t rows) {
  const terrain::World& world = *plan.world;
  const int level = plan.region.lod.value();
  Json json;
  json["fingerprint"] = to_string(world.fingerprint());
  json["resolution"] = world.spec().resolution;
  json["level"] = level;
  json["origin"] = {plan.region.x, plan.region.z};
  json["size"] = {plan.region.width, plan.region.depth};
  json["y0"] = plan.y0;
  json["halo"] = world.halo();
  json["sea_fx"] = world.sea_fx() ? Json(*world.sea_fx() >> level) : Json();
  json["slope_of"] = plan.slope_of;
  json["materials"] = told_materials(world);
  if (plan.edits != nullptr) {
    for (const terrain::Material& material : plan.edits->materials()) {
      json["materials"].push_back(
          {{"id", to_integer(material.id)}, {"name", material.name}, {"kind", "placeable"}});
    }
    json["store"] = {{"id", to_string(plan.edits->store_id())}, {"revision", plan.edits->revision()}};
  }
  json["layers"] = ids_of(plan.layers);
  json["planes"] = ids_of(plan.planes);
  json["eroded"] = told_eroded(world, plan.region.lod);
  json["fields"] = {{"names", plan.fields}, {"scale", kFieldScale}};
  if (world.look_names().size() > 1) json["looks"] = world.look_names();
  json["arrays"] = told_arrays(plan, rows);
  return json.dump(2) + "\n";
}

std::string objects_json(const ExportPlan& plan, std::vector<terrain::PlacedObject> objects) {
  const auto place = [](const terrain::PlacedObject& object) {
    return std::tuple{object.kind, object.z, object.x, object.seen_z, object.seen_x};
  };
  std::sort(objects.begin(), objects.end(),
            [&](const auto& a, const auto& b) { return place(a) < place(b); });
  const std::vector<terrain::ObjectKindName> kinds = plan.world->object_kinds();
  Json json = Json::array();
  for (const terrain::PlacedObject& object : objects) {
    std::array<char, 17> hash{};
    std::snprintf(hash.data(), hash.size(), "%016llx", static_cast<unsigned long long>(object.hash));
    Json told{{"kind", kinds[object.kind].name},
              {"model", kinds[object.kind].model},
              {"variant", object.variant},
              {"x", object.x},
              {"y", object.y},
              {"z", object.z},
              {"turn", object.turn},
              {"hash", hash.data()}};
    if (plan.region.lod.value() > 2) told["seen"] = {object.seen_x, object.seen_z};
    json.push_back(std::move(told));
  }
  return json.dump(1) + "\n";
}

}  // namespace talus::tools
