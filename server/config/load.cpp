#include "config/load.h"

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <toml++/toml.h>
#include <unistd.h>

#include <talus/files/secret_file.h>
#include <talus/mistyped/nearest.h>
#include <talus/toml/toml_bounds.h>
#include <talus/toml/toml_error.h>
#include <talus/vectors/instruction_set.h>

#include "config/fields.h"
#include "runtime/log/escape.h"

namespace talus::server {
namespace {

using Status = tl::expected<void, std::string>;

/// Keys and tables.
std::vector<std::string_view> known_names() {
  std::vector<std::string_view> names;
  for (const Field& field : fields()) {
    names.push_back(field.key);
    if (const auto dot = field.key.find('.'); dot != std::string_view::npos)
      names.push_back(field.key.substr(0, dot));
  }
  return names;
}

std::string hint(std::string_view name, std::span<const std::string_view> known) {
  const std::string_view near = meant(name, known);
  return near.empty() ? "" : fmt::format("; did you mean {}?", near);
}

/// Returns true if a setting stands in the table `path`.
bool is_table(std::string_view path) {
  const auto stands_there = [&](std::string_view key) {
    return key.size() > path.size() && key.starts_with(path) && key[path.size()] == '.';
  };
  return std::any_of(fields().begin(), fields().end(),
                     [&](const Field& field) { return stands_there(field.key); });
}

/// Joins a list of strings with commas; nullopt if it has other values.
std::optional<std::string> list_text(const toml::array& list) {
  std::string text;
  for (const toml::node& each : list) {
    const auto* const item = each.as_string();
    if (item == nullptr) return std::nullopt;
    text += fmt::format("{}{}", text.empty() ? "" : ",", item->get());
  }
  return text;
}

std::string_view described(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::string:
      return "a string";
    case toml::node_type::integer:
      return "an integer";
    case toml::node_type::floating_point:
      return "a floating-point number";
    case toml::node_type::boolean:
      return "a boolean";
    case toml::node_type::array:
      return "an array";
    case toml::node_type::table:
      return "a table";
    default:
      return "a date or time";
  }
}

Status set_from_node(const Field& field, Config& config, const toml::node& node) {
  if (is_number(field) && node.is_integer()) return set_from_number(field, config, node.as_integer()->get());
  const bool is_switch = std::holds_alternative<SwitchTarget>(field.target);
  if (is_switch && node.is_boolean()) {
    return set_from_text(field, config, node.as_boolean()->get() ? "true" : "false");
  }
  const bool is_list =
      std::holds_alternative<UrlsTarget>(field.target) || std::holds_alternative<WordsTarget>(field.target);
  if (is_list && node.is_array()) {
    if (const auto text = list_text(*node.as_array())) return set_from_text(field, config, *text);
  }
  const auto takes = [&](std::string_view text) {
    if (is_number(field)) return std::holds_alternative<OptionalNumberTarget>(field.target) && text == kAuto;
    return !is_switch;
  };
  if (node.is_string() && takes(node.as_string()->get())) {
    return set_from_text(field, config, node.as_string()->get());
  }
  return tl::make_unexpected(fmt::format("the value is {}; give {}", described(node), expectation(field)));
}

/// Applies one file to the settings.
class TomlFile {
 public:
  TomlFile(Settings& settings, std::string_view name, const toml::table& root)
      : settings_{settings}, name_{name}, root_{root} {}

  [[nodiscard]] Status apply() { return apply_table(root_, {}); }

 private:
  [[nodiscard]] std::string place(const toml::key& key) const {
    return fmt::format("{}:{}", name_, key.source().begin.line);
  }
  [[nodiscard]] Status fail(const toml::key& key, std::string_view text) const {
    return tl::make_unexpected(fmt::format("{}: {}", place(key), text));
  }

  Status apply_table(const toml::table& table, std::string_view prefix) {
    for (const auto& [key, node] : table) {
      const std::string path =
          prefix.empty() ? std::string{key.str()} : fmt::format("{}.{}", prefix, std::string_view{key.str()});
      if (Status done = apply_node(key, path, node); !done) return done;
    }
    return {};
  }

  Status apply_node(const toml::key& key, const std::string& path, const toml::node& node) {
    if (is_table(path)) {
      if (const auto* const inner = node.as_table()) return apply_table(*inner, path);
      return fail(key, fmt::format("{}: is a table; write [{}]", path, path));
    }
    const Field* const field = find_field(path);
    if (field == nullptr) {
      return fail(key, fmt::format("{}: no such key{}", escaped(path), hint(path, known_names())));
    }
    if (Status done = set_from_node(*field, settings_.config, node); !done) {
      return fail(key, fmt::format("{}: {}", path, done.error()));
    }
    settings_.origins.set(field->key, place(key));
    return {};
  }

  Settings& settings_;
  std::string_view name_;
  const toml::table& root_;
};

/// Text of the parser's error. The parser has escaped what it quotes, so backslashes stay.
std::string words_of(const std::string& description) {
  std::string_view rest = description;
  std::string words;
  for (;;) {
    const std::size_t backslash = std::min(rest.find('\\'), rest.size());
    words += escaped(rest.substr(0, backslash), backslash);
    if (backslash == rest.size()) return words;
    words += '\\';
    rest.remove_prefix(backslash + 1);
  }
}

std::string parse_error_line(std::string_view toml, std::string_view file, const toml::parse_error& error) {
  const auto line = static_cast<int>(error.source().begin.line);
  const std::string key = toml_key_at_line(toml, line);
  const std::string what = words_of(toml_error_text(error.description(), key));
  if (key.empty()) return fmt::format("{}:{}: {}", file, line, what);
  const Field* const field = find_field(key);
  return fmt::format("{}:{}: {}: {}{}", file, line, escaped(key), what,
                     field == nullptr ? "" : fmt::format("; give {}", expectation(*field)));
}

/// Warns of each variable that names no setting.
void warn_of_unknown(Settings& settings, const Environment& environment) {
  std::vector<std::string> names;
  for (const Field& field : fields()) names.push_back(variable_name(field.key));
  const std::vector<std::string_view> known{names.begin(), names.end()};

  for (const auto& [name, value] : environment) {
    if (name == kInstructionSetVariable) continue;  // read by core/vectors
    if (name == "TALUS_TOKEN" || name == "TALUS_TOKEN_FILE")
      continue;  // read by clients such as health checks
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    settings.warnings.push_back(
        fmt::format("{}: no such setting, ignored{}", escaped(name), hint(name, known)));
  }
}

Status set_from_variable(Settings& settings, std::string_view key, const std::string& variable,
                         std::string_view value) {
  if (Status done = set_from_text(*find_field(key), settings.config, value); !done) {
    return tl::make_unexpected(fmt::format("{}: {}", variable, done.error()));
  }
  settings.origins.set(key, variable);
  return {};
}

}  // namespace

Environment process_environment() {
  Environment environment;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string_view text{*entry};
    const std::size_t equals = text.find('=');
    if (text.starts_with("TALUS_") && equals != std::string_view::npos) {
      environment.emplace(text.substr(0, equals), text.substr(equals + 1));
    }
  }
  return environment;
}

Status apply_toml(Settings& settings, std::string_view toml, std::string_view file) {
  if (const auto fault = find_toml_fault(toml)) {
    return tl::make_unexpected(fmt::format("{}:{}: {}", file, fault->line, fault->what));
  }
  try {
    const toml::table table = toml::parse(toml, file);
    return TomlFile{settings, file, table}.apply();
  } catch (const toml::parse_error& error) {
    return tl::make_unexpected(parse_error_line(toml, file, error));
  }
}

Status apply_file(Settings& settings, const std::filesystem::path& file) {
  // Never blocks, even on a pipe.
  const auto read = files::SecretFile::read(file, kMaxTomlBytes);
  if (!read) {
    return tl::make_unexpected(fmt::format("{}: {}; give --config a TOML file that talusd may read",
                                           file.string(), read.error().reason));
  }
  return apply_toml(settings, read->text(), file.string());
}

Status apply_environment(Settings& settings, const Environment& environment) {
  for (const Field& field : fields()) {
    const std::string name = variable_name(field.key);
    const auto found = environment.find(name);
    if (found == environment.end()) continue;
    if (Status done = set_from_variable(settings, field.key, name, found->second); !done) return done;
  }
  warn_of_unknown(settings, environment);
  return {};
}

}  // namespace talus::server
