// One table of a world's TOML file, read key by key.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <talus/terrain/world.h>
#include <toml++/toml.h>

#include "spec_reader.h"

namespace talus::terrain {

struct Range {
  double least;
  double most;
};

/// The first thing wrong is kept; reading goes on with harmless values, so that who reads on sees the keys
/// and not the error paths.
class TableReader {
 public:
  TableReader(std::string_view file, std::string name, const toml::table& table,
              std::optional<SpecError>& error)
      : file_{file}, name_{std::move(name)}, table_{table}, error_{error} {}

  [[nodiscard]] int line() const { return static_cast<int>(table_.source().begin.line); }
  [[nodiscard]] int line(std::string_view key) const {
    const toml::node* node = table_.get(key);
    return node == nullptr ? line() : line_of(*node);
  }

  void fail(int line, const std::string& key, const std::string& what) {
    if (error_) return;
    std::ostringstream message;
    message << file_ << ':' << line << ": " << (name_.empty() ? "" : name_ + ".") << key << ": " << what;
    error_ = error_of(message.str());
  }

  void only(const std::vector<std::string_view>& known) {
    for (const auto& [key, value] : table_) {
      if (std::find(known.begin(), known.end(), key.str()) != known.end()) continue;
      std::string list;
      for (const std::string_view name : known) list += (list.empty() ? "" : ", ") + std::string{name};
      fail(static_cast<int>(key.source().begin.line), std::string{key.str()},
           "unknown key; known here: " + list);
    }
  }

  [[nodiscard]] bool has(std::string_view key) const { return table_.contains(key); }

  double real(const std::string& key, Range range) {
    const toml::node* node = find(key, "a number");
    if (node == nullptr) return range.least;
    const auto value = node->is_number() ? node->value<double>() : std::nullopt;
    if (!value) return wrong_type(*node, key, "a number"), range.least;
    if (!(*value >= range.least && *value <= range.most)) {
      fail(line_of(*node), key,
           number(*value) + " is out of range; " + number(range.least) + " to " + number(range.most));
      return range.least;
    }
    return *value;
  }

  std::int64_t integer(const std::string& key, std::int64_t least, std::int64_t most) {
    const toml::node* node = find(key, "an integer");
    if (node == nullptr) return least;
    const auto value = node->is_integer() ? node->value<std::int64_t>() : std::nullopt;
    if (!value) return wrong_type(*node, key, "an integer"), least;
    if (*value < least || *value > most) {
      fail(line_of(*node), key,
           std::to_string(*value) + " is out of range; " + std::to_string(least) + " to " +
               std::to_string(most));
      return least;
    }
    return *value;
  }

  // Terrain units as integers of 2^-16, so that no sequence depends on binary fractions.
  std::int64_t units_q16(const std::string& key, Range range) {
    return static_cast<std::int64_t>(std::floor(real(key, range) * 65536.0 + 0.5));
  }

  std::string name(std::set<std::string>& taken) {
    const toml::node* node = find("name", "a string");
    if (node == nullptr) return {};
    const auto value = node->is_string() ? node->value<std::string>() : std::nullopt;
    if (!value) return wrong_type(*node, "name", "a string"), std::string{};
    if (value->empty() || value->size() > 64) {
      fail(line_of(*node), "name", "a name has 1 to 64 bytes, this has " + std::to_string(value->size()));
    } else if (std::any_of(value->begin(), value->end(),
                           [](char c) { return (c >= 0 && c < ' ') || c == '\x7F'; })) {
      fail(line_of(*node), "name", "a name is printed as it is, so it holds no control characters");
    } else if (*value == "air" || *value == "water") {
      fail(line_of(*node), "name", "'" + *value + "' is the world's own; choose another name");
    } else if (!taken.insert(*value).second) {
      fail(line_of(*node), "name", "'" + *value + "' names another material already; names are unique");
    }
    return *value;
  }

  Colour colour() {
    const toml::node* node = find("colour", "a string such as \"#8d8478\"");
    if (node == nullptr) return {};
    const auto text = node->is_string() ? node->value<std::string>() : std::nullopt;
    const bool shaped = text && text->size() == 7 && text->front() == '#' &&
                        text->find_first_not_of("0123456789abcdefABCDEF", 1) == std::string::npos;
    if (!shaped) return wrong_type(*node, "colour", "a string such as \"#8d8478\""), Colour{};
    const auto channel = [&](std::size_t at) {
      return static_cast<std::uint8_t>(std::stoi(text->substr(at, 2), nullptr, 16));
    };
    return {channel(1), channel(3), channel(5)};
  }

  std::string text(const std::string& key, std::size_t longest) {
    const toml::node* node = find(key, "a string");
    if (node == nullptr) return {};
    const auto value = node->is_string() ? node->value<std::string>() : std::nullopt;
    if (!value) return wrong_type(*node, key, "a string"), std::string{};
    if (value->empty() || value->size() > longest) {
      fail(line_of(*node), key,
           "1 to " + std::to_string(longest) + " bytes, this has " + std::to_string(value->size()));
    }
    return *value;
  }

  // The place in `names` of what the key says.
  std::size_t choice(const std::string& key, std::initializer_list<std::string_view> names) {
    const std::string chosen = text(key, 64);
    const auto found = std::find(names.begin(), names.end(), chosen);
    if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
    std::string list;
    for (const std::string_view name : names) list += (list.empty() ? "" : ", ") + std::string{name};
    fail(line(key), key, "'" + chosen + "' is none of: " + list);
    return 0;
  }

  const toml::table* table(const std::string& key) {
    const toml::node* node = find(key, "a table [" + key + "]");
    if (node == nullptr) return nullptr;
    if (!node->is_table()) wrong_type(*node, key, "a table [" + key + "]");
    return node->as_table();
  }

  // All tables of an array of tables, of which there must be at least one.
  std::vector<const toml::table*> tables(const std::string& key) {
    std::vector<const toml::table*> found;
    const toml::node* node = find(key, "at least one [[" + key + "]]");
    if (node == nullptr) return found;
    if (!node->is_array()) return wrong_type(*node, key, "tables [[" + key + "]]"), found;
    for (const toml::node& element : *node->as_array()) {
      if (!element.is_table()) return wrong_type(element, key, "tables [[" + key + "]]"), found;
      found.push_back(element.as_table());
    }
    if (found.empty()) fail(line_of(*node), key, "empty; at least one [[" + key + "]] is needed");
    return found;
  }

 private:
  static std::string number(double value) {
    std::ostringstream text;
    text << value;
    return text.str();
  }

  static int line_of(const toml::node& node) { return static_cast<int>(node.source().begin.line); }

  const toml::node* find(const std::string& key, const std::string& wanted) {
    const toml::node* node = table_.get(key);
    if (node == nullptr) fail(std::max(1, line()), key, "missing; " + wanted + " is needed");
    return node;
  }

  void wrong_type(const toml::node& node, const std::string& key, const std::string& wanted) {
    std::ostringstream kind;
    kind << node.type();
    fail(line_of(node), key, "is not right as it stands (" + kind.str() + "); " + wanted + " is needed");
  }

  std::string_view file_;
  std::string name_;
  const toml::table& table_;
  std::optional<SpecError>& error_;
};

}  // namespace talus::terrain
