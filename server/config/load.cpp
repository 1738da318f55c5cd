#include "config/load.h"

#include <algorithm>
#include <system_error>

#include <fmt/format.h>
#include <toml++/toml.h>
#include <unistd.h>

#include <talus/files/read_file.h>
#include <talus/terrain/toml_bounds.h>
#include <talus/vectors/instruction_set.h>

#include "config/fields.h"
#include "config/nearest.h"
#include "log/escape.h"

namespace talus::server {
namespace {

using Done = tl::expected<void, std::string>;

std::vector<std::string_view> known_keys() {
  std::vector<std::string_view> keys;
  for (const Field& field : fields()) keys.push_back(field.key);
  return keys;
}

bool is_group(std::string_view path) {
  for (const Field& field : fields()) {
    if (field.key.size() > path.size() && field.key.substr(0, path.size()) == path &&
        field.key[path.size()] == '.') {
      return true;
    }
  }
  return false;
}

tl::unexpected<std::string> at_line(std::string_view file, const toml::source_region& where,
                                    std::string_view text) {
  return tl::make_unexpected(fmt::format("{}:{}: {}", file, where.begin.line, text));
}

Done set_from_node(const Field& field, Config& config, const toml::node& node) {
  const bool number = std::holds_alternative<NumberTarget>(field.target);
  if (number && node.is_integer()) return set_from_number(field, config, node.as_integer()->get());
  if (!number && node.is_string()) return set_from_text(field, config, node.as_string()->get());
  return tl::make_unexpected(fmt::format("the value is of the wrong type; give {}", expectation(field)));
}

Done apply_table(Config& config, const toml::table& table, std::string_view prefix, std::string_view file) {
  for (const auto& [key, node] : table) {
    const std::string path =
        prefix.empty() ? std::string{key.str()} : fmt::format("{}.{}", prefix, std::string_view{key.str()});
    const Field* field = find_field(path);
    if (field == nullptr && is_group(path) && node.is_table()) {
      if (Done done = apply_table(config, *node.as_table(), path, file); !done) return done;
    } else if (field == nullptr && is_group(path)) {
      return at_line(file, key.source(), fmt::format("{}: is a table; write [{}]", path, path));
    } else if (field == nullptr) {
      return at_line(
          file, key.source(),
          fmt::format("{}: no such key; did you mean {}?", escaped(path), nearest(path, known_keys())));
    } else if (Done done = set_from_node(*field, config, node); !done) {
      return at_line(file, key.source(), fmt::format("{}: {}", path, done.error()));
    }
  }
  return {};
}

}  // namespace

Environment process_environment() {
  Environment environment;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string_view text{*entry};
    const std::size_t equals = text.find('=');
    if (text.substr(0, 6) == "TALUS_" && equals != std::string_view::npos) {
      environment.emplace(text.substr(0, equals), text.substr(equals + 1));
    }
  }
  return environment;
}

Done apply_toml(Config& config, std::string_view toml, std::string_view file) {
  if (const auto fault = terrain::passes_toml_bounds(toml)) {
    return tl::make_unexpected(fmt::format("{}:{}: {}", file, fault->line, fault->what));
  }
  try {
    const toml::table table = toml::parse(toml, file);
    return apply_table(config, table, "", file);
  } catch (const toml::parse_error& error) {
    return at_line(file, error.source(), escaped(error.description(), 300));
  }
}

Done apply_file(Config& config, const std::filesystem::path& file) {
  const auto text = files::read_file(file, terrain::kMaxTomlBytes);
  if (!text) {
    return tl::make_unexpected(
        fmt::format("{}: cannot read the configuration: {}; give --config a readable TOML file",
                    file.string(), text.error().code.message()));
  }
  return apply_toml(config, *text, file.string());
}

Done apply_environment(Config& config, const Environment& environment) {
  for (const Field& field : fields()) {
    const std::string name = variable_name(field);
    const auto found = environment.find(name);
    if (found == environment.end()) continue;
    if (Done done = set_from_text(field, config, found->second); !done) {
      return tl::make_unexpected(fmt::format("{}: {}", name, done.error()));
    }
  }
  return {};
}

std::vector<std::string> unknown_variables(const Environment& environment) {
  std::vector<std::string> names;
  for (const Field& field : fields()) names.push_back(variable_name(field));
  const std::vector<std::string_view> known{names.begin(), names.end()};

  std::vector<std::string> lines;
  for (const auto& [name, value] : environment) {
    if (name == kInstructionSetVariable) continue;                      // read by core/vectors
    if (name == "TALUS_TOKEN" || name == "TALUS_TOKEN_FILE") continue;  // read by clients: a health check's
    if (std::find(known.begin(), known.end(), name) == known.end()) {
      lines.push_back(
          fmt::format("{}: no such setting, ignored; did you mean {}?", escaped(name), nearest(name, known)));
    }
  }
  return lines;
}

}  // namespace talus::server
