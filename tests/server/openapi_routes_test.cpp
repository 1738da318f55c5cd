// protocol/openapi.json against the router: its paths, parameters and bounds are the code's, and none is
// missing. The statuses, fields and bodies of answers are in tests/e2e/openapi_test.cpp.
#include <algorithm>
#include <catch2/catch.hpp>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <variant>

#include <talus/protocol/message.h>
#include <talus/voxel/codec.h>

#include "web/routes.h"

using namespace talus;
using namespace talus::server::web;
using nlohmann::json;

namespace {

const json& document() {
  static const json kDocument = json::parse(std::ifstream{TALUS_SOURCE_DIR "/protocol/openapi.json"});
  return kDocument;
}

/// Kind of the route, edge of a square (0: not a square), and true for land with edits and named files.
using Form = std::tuple<std::size_t, std::int32_t, bool>;

Form form_of(const Route& route) {
  if (const auto* chunk = std::get_if<ChunkRoute>(&route))
    return {route.index(), 0, chunk->edition.has_value()};
  if (const auto* file = std::get_if<FileRoute>(&route)) return {route.index(), 0, !file->name.empty()};
  const auto* columns = std::get_if<ColumnsRoute>(&route);
  if (columns == nullptr) return {route.index(), 0, false};
  return {route.index(), columns->square ? columns->edge : 0, columns->edition.has_value()};
}

/// The forms that the router's types can express.
std::set<Form> forms_in_code() {
  std::set<Form> forms;
  for (std::size_t kind = 0; kind < std::variant_size_v<Route>; ++kind) forms.insert({kind, 0, false});
  forms.insert({Route{ChunkRoute{}}.index(), 0, true});
  forms.insert({Route{FileRoute{}}.index(), 0, true});
  const std::size_t columns = Route{ColumnsRoute{}}.index();
  for (const bool edited : {false, true}) {
    forms.insert({columns, 0, edited});
    for (std::int32_t edge = 1; edge <= kMaxSquareEdge; edge *= 2) forms.insert({columns, edge, edited});
  }
  return forms;
}

/// Returns the parameters of an operation in the path or in the query, by name.
std::map<std::string, json> parameters_in(const json& operation, std::string_view place) {
  std::map<std::string, json> found;
  for (const json& each : operation.value("parameters", json::array())) {
    const json& parameter = document().at(json::json_pointer{each["$ref"].get<std::string>().substr(1)});
    if (parameter["in"] == place) found.emplace(parameter["name"], parameter);
  }
  return found;
}

/// Replaces each {name} by the parameter's example, or by `value` for the parameter `name`.
std::string filled(std::string path, const std::map<std::string, json>& parameters,
                   std::string_view name = {}, const std::string& value = {}) {
  for (const auto& [key, parameter] : parameters) {
    const std::string mark = "{" + key + "}";
    const std::size_t at = path.find(mark);
    REQUIRE(at != std::string::npos);
    path.replace(at, mark.size(), key == name ? value : parameter["example"].get<std::string>());
  }
  REQUIRE(path.find('{') == std::string::npos);
  return path;
}

const std::map<std::string, json>& heights_keys() {
  static const auto kKeys = parameters_in(document()["paths"]["/v1/heights"]["get"], "query");
  return kKeys;
}

/// A valid query with `name` set to `value`.
std::string query_with(const std::string& name, const std::string& value) {
  const bool grid = std::set<std::string>{"x", "z", "w", "h", "step"}.contains(name);
  std::string query;
  for (const std::string key : {"x", "z", "w", "h"}) {
    if (grid && key != name) query += key + "=1&";
  }
  if (!grid && name != "columns") query += "columns=1,2&";
  return query + name + "=" + value;
}

bool accepts(const std::string& path, const std::optional<std::string>& query) {
  return find_route(path, query, 100).has_value();
}

/// Calls `check(value, valid)` with values at and beyond the bounds of a parameter's schema.
template <typename Check>
void check_bounds(const json& schema, const Check& check) {
  for (const json& word : schema.value("enum", json::array())) check(word.get<std::string>(), true);
  if (schema.contains("enum")) check("other", false);
  if (schema["type"] == "integer") {
    const std::int64_t minimum = schema["minimum"];
    check(std::to_string(minimum), true);
    check(std::to_string(minimum - 1), false);
    if (schema.contains("maximum")) {
      const std::int64_t maximum = schema["maximum"];
      check(std::to_string(maximum), true);
      check(std::to_string(maximum + 1), false);
    }
  }
  if (schema.value("pattern", "").ends_with("[1-9][0-9]*)$")) {
    check("07", false);
    check("-0", false);
    check("7x", false);
  }
}

}  // namespace

TEST_CASE("openapi.json lists every form of path that the router knows, and no other") {
  std::set<Form> forms;
  for (const auto& [path, operations] : document()["paths"].items()) {
    INFO(path);
    const auto parameters = parameters_in(operations["get"], "path");
    const auto query = path == "/v1/heights" ? std::optional<std::string>{"columns=1,2"} : std::nullopt;
    const auto route = find_route(filled(path, parameters), query, 100);
    REQUIRE(route);
    CHECK(forms.insert(form_of(*route)).second);
    for (const auto& [name, parameter] : parameters) {
      // The fingerprint, the store and the codec are compared with the world's, after routing.
      if (name == "fingerprint" || name == "store") continue;
      if (name == "codec") {
        CHECK(parameter["schema"]["enum"] == json{std::to_string(kCodecVersion)});
        continue;
      }
      const std::string key = name;
      check_bounds(parameter["schema"], [&](const std::string& value, bool valid) {
        INFO(key << " = " << value);
        CHECK(accepts(filled(path, parameters, key, value), query) == valid);
      });
    }
  }
  CHECK(forms == forms_in_code());
}

TEST_CASE("openapi.json lists every key of the query of heights, with its bounds") {
  std::set<std::string> names;
  for (const auto& [name, parameter] : heights_keys()) {
    names.insert(name);
    const std::string key = name;
    CHECK(accepts("/v1/heights", query_with(key, parameter["example"])));
    check_bounds(parameter["schema"], [&](const std::string& value, bool valid) {
      INFO(key << " = " << value);
      CHECK(accepts("/v1/heights", query_with(key, value)) == valid);
    });
  }
  CHECK(names == std::set<std::string>(kHeightsKeys.begin(), kHeightsKeys.end()));
  CHECK(heights_keys().at("step")["schema"]["maximum"] == kMaxHeightsStep);
}

TEST_CASE("openapi.json lists every error code") {
  std::set<std::string> names;
  for (const wire::ErrorCode code : wire::EnumValuesErrorCode()) {
    if (code != wire::ErrorCode::none) names.insert(wire::EnumNameErrorCode(code));
  }
  const json& schema = document()["components"]["schemas"]["Error"]["properties"]["error"];
  CHECK(schema["properties"]["code"]["enum"].get<std::set<std::string>>() == names);
}
