// protocol/openapi.json, held against a running talusd: every path with every parameter, and every status
// that it lists.
#include <algorithm>
#include <catch2/catch.hpp>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "http_client.h"
#include "scratch_directory.h"
#include "server_process.h"
#include "world_of_a_map.h"

using namespace talus;
using namespace talus::e2e;
using nlohmann::json;

namespace {

const json& document() {
  static const json kDocument = json::parse(read_whole(TALUS_SOURCE_DIR "/protocol/openapi.json"));
  return kDocument;
}

/// What a "$ref" of this file names, or the value itself.
const json& resolved(const json& value) {
  if (!value.contains("$ref")) return value;
  return document().at(json::json_pointer{value["$ref"].get<std::string>().substr(1)});
}

/// What is wrong with a value by its schema; empty: nothing. As much of JSON Schema as the file uses.
std::string fault_of(const json& value, const json& reference, const std::string& at = "body") {
  const json& schema = resolved(reference);
  const std::string type = schema.value("type", "");
  const bool fits = type == "object"    ? value.is_object()
                    : type == "array"   ? value.is_array()
                    : type == "integer" ? value.is_number_integer()
                    : type == "number"  ? value.is_number()
                    : type == "boolean" ? value.is_boolean()
                                        : value.is_string();
  if (!fits) return at + " is no " + type;
  if (schema.contains("enum") &&
      std::find(schema["enum"].begin(), schema["enum"].end(), value) == schema["enum"].end()) {
    return at + " is not one of the listed: " + value.dump();
  }
  if (schema.contains("minimum") && value < schema["minimum"]) return at + " is too small";
  if (schema.contains("pattern") &&
      !std::regex_search(value.get<std::string>(), std::regex{schema["pattern"].get<std::string>()})) {
    return at + " does not match: " + value.dump();
  }
  if (type == "array") {
    if (value.size() < schema.value("minItems", std::size_t{0})) return at + " is too short";
    if (value.size() > schema.value("maxItems", SIZE_MAX)) return at + " is too long";
    for (const json& item : value) {
      if (std::string fault = fault_of(item, schema.at("items"), at + "[]"); !fault.empty()) return fault;
    }
  }
  if (type != "object") return "";
  for (const json& key : schema.value("required", json::array())) {
    if (!value.contains(key.get<std::string>())) return at + " lacks " + key.get<std::string>();
  }
  for (const auto& [key, inner] : value.items()) {
    const json properties = schema.value("properties", json::object());
    const json others = schema.value("additionalProperties", json(true));
    if (!properties.contains(key) && !others.is_object()) return at + " has an unlisted " + key;
    const json& rule = properties.contains(key) ? properties[key] : others;
    if (std::string fault = fault_of(inner, rule, at + "." + key); !fault.empty()) return fault;
  }
  return "";
}

/// A request as the file's examples have it.
struct Example {
  std::string target;
  std::string fields;
  std::set<std::string> names;  // of the parameters in it
};

/// Of what the heights of a request are: a list or a grid, never both. None: a parameter of either.
std::optional<std::string> form_of(const json& parameter) {
  static const std::set<std::string> kOfGrid{"x", "z", "w", "h", "step"};
  const std::string name = parameter["name"];
  if (parameter["in"] != "query") return std::nullopt;
  if (name == "columns") return "list";
  return kOfGrid.contains(name) ? std::optional<std::string>{"grid"} : std::nullopt;
}

using Values = std::map<std::string, std::string>;  // by the parameter's name

/// With the parameters' examples, but for `values`. `form`: of form_of().
Example example_of(const std::string& path, const json& parameters, const std::optional<std::string>& form,
                   const Values& values) {
  Example example{path, "", {}};
  std::string query;
  for (const json& each : parameters) {
    const json& parameter = resolved(each);
    const auto its_form = form_of(parameter);
    if (its_form && its_form != form) continue;
    const std::string name = parameter["name"];
    const std::string value =
        values.contains(name) ? values.at(name) : parameter.at("example").get<std::string>();
    example.names.insert(name);
    if (parameter["in"] == "path") {
      const std::string mark = "{" + name + "}";
      REQUIRE(example.target.find(mark) != std::string::npos);
      example.target.replace(example.target.find(mark), mark.size(), value);
    } else if (parameter["in"] == "header") {
      example.fields += name + ": " + value + "\r\n";
    } else {
      REQUIRE(parameter["in"] == "query");
      query += (query.empty() ? "?" : "&") + name + "=" + value;
    }
  }
  REQUIRE(example.target.find('{') == std::string::npos);
  example.target += query;
  if (path == "/v1/stream") example.fields += "Connection: Upgrade\r\n";
  return example;
}

/// Requests in which every parameter of a path is, and each value of a query that the file lists.
std::vector<Example> examples_of(const std::string& path, const json& operation, const json& world) {
  const json parameters = operation.value("parameters", json::array());
  const Values of_world{{"fingerprint", world["fingerprint"]}, {"store", world["store_id"]}};
  std::set<std::optional<std::string>> forms;
  std::set<std::string> documented;
  for (const json& each : parameters) {
    documented.insert(resolved(each)["name"]);
    if (const auto form = form_of(resolved(each))) forms.insert(form);
  }
  if (forms.empty()) forms.insert(std::nullopt);
  std::vector<Example> examples;
  for (const auto& form : forms) examples.push_back(example_of(path, parameters, form, of_world));
  for (const json& each : parameters) {
    const json& parameter = resolved(each);
    if (parameter["in"] != "query") continue;
    // Without other choices: an array has heights alone.
    json alone = json::array();
    for (const json& other : parameters) {
      if (other == each || form_of(resolved(other)) || resolved(other)["in"] != "query")
        alone.push_back(other);
    }
    for (const json& value : parameter["schema"].value("enum", json::array())) {
      Values values = of_world;
      values[parameter["name"]] = value;
      examples.push_back(example_of(path, alone, *forms.begin(), values));
    }
  }
  std::set<std::string> walked;
  for (const Example& each : examples) walked.insert(each.names.begin(), each.names.end());
  CHECK(walked == documented);
  return examples;
}

/// Whether an answer is as the file says of its status.
void check_answer(const Answer& answer, const json& responses) {
  const std::string status = std::to_string(answer.status);
  INFO("answered by " << answer.head);
  REQUIRE(responses.contains(status));
  const json& response = resolved(responses[status]);
  const json headers = response.value("headers", json::object());
  for (const auto& [name, header] : headers.items()) {
    INFO("field " << name);
    if (answer.field(name).empty() && !resolved(header).value("required", true)) continue;
    REQUIRE_FALSE(answer.field(name).empty());
    CHECK(fault_of(answer.field(name), resolved(header)["schema"], name).empty());
  }
  if (!response.contains("content")) {
    CHECK(answer.body.empty());
    return;
  }
  const std::string type = answer.field("Content-Type");
  REQUIRE(response["content"].contains(type));
  CHECK_FALSE(answer.body.empty());
  if (type == "application/json")
    CHECK(fault_of(json::parse(answer.body), response["content"][type]["schema"]) == "");
}

/// Servers in which each status can be provoked, and how.
class Provoker {
 public:
  Provoker()
      : secret_{scratch_.write("secret", "a secret of more than sixteen bytes\n")},
        blocked_{scratch_.write("blocked", "127.0.0.1\n")} {}

  json world() {
    HttpClient client{open_.http_port()};
    return json::parse(client.get("/v1/world").body);
  }

  Answer ask(const std::string& status, const std::string& path, const Example& example) {
    const std::string& target = example.target;
    if (status == "200" || status == "101") return get(open_, target, example.fields);
    if (status == "304") {
      const std::string tag = get(open_, target, example.fields).field("ETag");
      return get(open_, target, "If-None-Match: " + tag + "\r\n");
    }
    if (status == "307") {
      const std::size_t mark = target.find('@');
      REQUIRE(mark != std::string::npos);
      return get(open_, target.substr(0, mark) + "@7", example.fields);
    }
    if (status == "400") {
      if (path == "/v1/stream")
        return get(open_, target,
                   "Connection: Upgrade\r\nUpgrade: websocket\r\nSec-WebSocket-Version: 13\r\n");
      return get(open_, target + (target.find('?') == std::string::npos ? "?" : "&") + "unknown=1");
    }
    if (status == "401") return get(with_secret_, target, example.fields);
    if (status == "403") {
      HttpClient client{with_block_.http_port()};
      return client.read();
    }
    if (status == "404") {
      return get(open_, "/v1/" + std::string(32, '0') + target.substr(36), example.fields);
    }
    if (status == "405") {
      HttpClient client{open_.http_port()};
      client.send("POST " + target + " HTTP/1.1\r\nHost: a\r\n\r\n");
      return client.read();
    }
    if (status == "426") return get(open_, target);
    if (status == "429") {
      Answer answer;
      // Where the machine stands still for a second, one more is allowed.
      for (int tries = 0; tries < 20 && answer.status != 429; ++tries) {
        HttpClient client{slow_.http_port()};
        for (int i = 0; i < 3; ++i) (void)client.get("/v1/world");
        answer = client.get(target, example.fields);
      }
      return answer;
    }
    REQUIRE(status == "503");
    while (true) {
      HttpClient first{full_.http_port()};
      if (!is_served(first)) continue;
      HttpClient second{full_.http_port()};
      return second.read();
    }
  }

 private:
  // A connection that the test has closed may have the place until the server has seen its end.
  static bool is_served(HttpClient& client) {
    try {
      return client.get("/v1/world").status == 200;
    } catch (const std::exception&) {
      return false;
    }
  }

  static Answer get(ServerProcess& server, const std::string& target, const std::string& fields = "") {
    HttpClient client{server.http_port()};
    return client.get(target, fields);
  }

  ScratchDirectory scratch_;
  std::string secret_;
  std::string blocked_;
  ServerProcess open_{{{"TALUS_WORLD", write_world_of_a_map(scratch_, 8)},
                       {"TALUS_PUBLISH", "public"},
                       {"TALUS_DATA", (scratch_ / "data").string()}},
                      kWithHttp};
  ServerProcess with_secret_{{kClassicWorld, {"TALUS_ACCESS_SECRET_FILE", secret_}}, kWithHttp};
  ServerProcess with_block_{{kClassicWorld, {"TALUS_ACCESS_BLOCKED_FILE", blocked_}}, kWithHttp};
  ServerProcess slow_{
      {kClassicWorld, {"TALUS_RATES_SESSION_REQUESTS", "1"}, {"TALUS_RATES_BURST_MS", "1000"}}, kWithHttp};
  ServerProcess full_{{kClassicWorld, {"TALUS_LIMITS_CONNECTIONS", "1"}}, kWithHttp};
};

}  // namespace

TEST_CASE("each path of openapi.json answers as it says, with each parameter, by each status that it lists") {
  Provoker provoker;
  const json world = provoker.world();
  REQUIRE(document()["paths"].size() == 17);
  for (const auto& [path, operations] : document()["paths"].items()) {
    REQUIRE(operations.size() == 1);  // HEAD is as GET
    const json& operation = operations.at("get");
    for (const Example& example : examples_of(path, operation, world)) {
      for (const auto& [status, response] : operation["responses"].items()) {
        INFO(path << ": " << status << ", asked for " << example.target);
        const Answer answer = provoker.ask(status, path, example);
        CHECK(std::to_string(answer.status) == status);
        check_answer(answer, operation["responses"]);
      }
    }
  }
}

TEST_CASE("openapi.json names what it refers to, and uses all that it names") {
  std::set<std::string> used;
  const std::function<void(const json&)> check_references = [&](const json& value) {
    if (value.is_object() && value.contains("$ref")) {
      const std::string name = value["$ref"];
      CHECK(document().contains(json::json_pointer{name.substr(1)}));
      used.insert(name);
    }
    if (value.is_structured()) {
      for (const json& inner : value) check_references(inner);
    }
  };
  check_references(document());
  for (const auto& [kind, components] : document()["components"].items()) {
    if (kind == "securitySchemes") continue;
    for (const auto& [name, component] : components.items()) {
      INFO(kind << '/' << name);
      CHECK(used.contains("#/components/" + kind + "/" + name));
    }
  }
}
