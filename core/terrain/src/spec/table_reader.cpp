#include "spec/table_reader.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include <talus/toml/toml_bounds.h>
#include <talus/toml/toml_error.h>
#include <talus/voxel/material_name.h>
#include <toml++/toml.h>

#include "spec/units.h"

namespace talus::terrain {

// A TomlTable is never dereferenced: it is the address of a toml::table.
struct TomlDocument::Tree {
  toml::table root;
};

namespace {

const TomlTable& opaque(const toml::table& table) {
  return *reinterpret_cast<const TomlTable*>(&table);
}

const toml::table& table_of(const TomlTable* table) {
  return *reinterpret_cast<const toml::table*>(table);
}

int line_of(const toml::node& node) {
  return static_cast<int>(node.source().begin.line);
}

int column_of(const toml::node& node) {
  return static_cast<int>(node.source().begin.column);
}

constexpr std::size_t kMaxKeyShown = 120;   // bytes
constexpr std::size_t kMaxMaterials = 255;  // in addition to air and water

std::string qualified(const std::string& table, std::string_view key) {
  return (table.empty() ? "" : table + ".") + shortened(key, kMaxKeyShown);
}

std::string list_of(const auto& names) {
  std::string list;
  for (const std::string_view name : names) list += (list.empty() ? "" : ", ") + std::string{name};
  return list;
}

}  // namespace

bool TableReader::has(std::string_view key) const {
  return table_of(table_).contains(key);
}

int TableReader::line() const {
  return std::max(1, line_of(table_of(table_)));
}

int TableReader::line(std::string_view key) const {
  const toml::node* node = table_of(table_).get(key);
  return node == nullptr ? line() : line_of(*node);
}

void TableReader::fail(std::string_view key, const std::string& what) {
  const toml::node* node = table_of(table_).get(key);
  errors_->add(line(key), column_of(node == nullptr ? table_of(table_) : *node), qualified(name_, key), what);
}

void TableReader::only(const std::vector<std::string_view>& known) {
  for (const auto& [key, value] : table_of(table_)) {
    if (std::find(known.begin(), known.end(), key.str()) != known.end()) continue;
    const toml::source_position& at = key.source().begin;
    errors_->add(static_cast<int>(at.line), static_cast<int>(at.column), qualified(name_, key.str()),
                 "unknown key; known here: " + list_of(known));
  }
}

namespace {

constexpr std::size_t kMaxShown = 60;  // bytes of a value

constexpr double kBillion = 1e9;  // plain() writes larger numbers with an exponent

// A value and its type, as in "1.0 is a floating-point number".
std::string described(const toml::node& node) {
  if (const auto* text = node.as_string()) return "'" + shortened(text->get(), kMaxShown) + "' is a string";
  if (const auto* number = node.as_integer()) return text_of(number->get(), " is an integer");
  if (const auto* number = node.as_floating_point()) {
    const bool whole = std::abs(number->get()) < kBillion && number->get() == std::floor(number->get());
    return text_of(number->get(), whole ? ".0" : "", " is a floating-point number");
  }
  if (const auto* truth = node.as_boolean()) return truth->get() ? "true is a boolean" : "false is a boolean";
  if (node.is_array()) return "an array";
  return node.is_table() ? "a table" : "a date or time";
}

// Fails a missing key.
const toml::node* find(TableReader& reader, const toml::table& table, const std::string& key,
                       const std::string& wanted) {
  const toml::node* node = table.get(key);
  if (node == nullptr) reader.fail(key, "missing; " + wanted + " is needed");
  return node;
}

void wrong_type(TableReader& reader, const toml::node& node, const std::string& key,
                const std::string& wanted) {
  reader.fail(key, text_of(described(node), "; ", wanted, " is needed"));
}

}  // namespace

std::optional<double> TableReader::number(const std::string& key) {
  const toml::node* node = find(*this, table_of(table_), key, "a number");
  if (node == nullptr) return std::nullopt;
  const auto value = node->is_number() ? node->value<double>() : std::nullopt;
  if (!value) wrong_type(*this, *node, key, "a number");
  return value;
}

double TableReader::real(const std::string& key, Range range, std::string_view note) {
  const auto value = number(key);
  if (value && *value >= range.min && *value <= range.max) return *value;
  if (value) fail(key, text_of(*value, " is out of range; ", range.min, " to ", range.max, note));
  return range.min;
}

bool TableReader::check_length(const std::string& key, double shown, double value, Range units,
                               const Voxels& voxels) {
  const double product = value * voxels.resolution;
  const double came_to = voxels.rounded ? std::floor(product + 0.5) : product;
  const bool fits =
      shown >= units.min && shown <= units.max && came_to >= voxels.range.min && came_to <= voxels.range.max;
  if (fits) return true;
  const double least = voxels.range.min / voxels.resolution;
  const double most = std::min(units.max, voxels.range.max / voxels.resolution);
  const std::string in_voxels = least < units.min ? text_of("at most ", voxels.range.max)
                                                  : text_of(voxels.range.min, " to ", voxels.range.max);
  fail(key, text_of(shown, " is out of range; ", std::max(units.min, least), " to ", most, " (", in_voxels,
                    " voxels at resolution ", voxels.resolution, ")"));
  return false;
}

double TableReader::length(const std::string& key, Range units, const Voxels& voxels) {
  const auto value = number(key);
  return value && check_length(key, *value, *value, units, voxels) ? *value : units.min;
}

std::int64_t TableReader::length_q16(const std::string& key, Range units, const Voxels& voxels) {
  const auto value = number(key);
  if (!value) return rounded(units.min * 65536.0);
  const double bounded = *value >= units.min && *value <= units.max ? *value : units.min;
  const std::int64_t q16 = rounded(bounded * 65536.0);
  return check_length(key, *value, units_of(q16), units, voxels) ? q16 : rounded(units.min * 65536.0);
}

std::int64_t TableReader::integer(const std::string& key, std::int64_t min, std::int64_t max) {
  const toml::node* node = find(*this, table_of(table_), key, "an integer");
  if (node == nullptr) return min;
  const auto value = node->is_integer() ? node->value<std::int64_t>() : std::nullopt;
  if (!value) return wrong_type(*this, *node, key, "an integer"), min;
  if (*value < min || *value > max) {
    fail(key, text_of(*value, " is out of range; ", min, " to ", max));
    return min;
  }
  return *value;
}

std::int64_t TableReader::units_q16(const std::string& key, Range range) {
  return rounded(real(key, range) * 65536.0);
}

namespace {

// The numbers of an array; nullopt if it is not an array of `size` numbers.
std::optional<std::vector<double>> numbers_of(const toml::node& node, std::size_t size) {
  const toml::array* const array = node.as_array();
  if (array == nullptr || array->size() != size) return std::nullopt;
  std::vector<double> numbers;
  for (const toml::node& element : *array) {
    const auto number = element.is_number() ? element.value<double>() : std::nullopt;
    if (!number) return std::nullopt;
    numbers.push_back(*number);
  }
  return numbers;
}

bool within(double value, Range range) {
  return value >= range.min && value <= range.max;
}

}  // namespace

Curve TableReader::curve(const std::string& key, Range xs, Range ys, std::size_t max_count,
                         const Curve& otherwise) {
  const toml::node* const node = table_of(table_).get(key);
  if (node == nullptr) return otherwise;
  const std::string wanted = text_of("a list of 1 to ", max_count, " knots [x, y]");
  const toml::array* const array = node->as_array();
  if (array == nullptr) return wrong_type(*this, *node, key, wanted), otherwise;
  if (array->empty() || array->size() > max_count) {
    fail(key, text_of(array->size(), " knots; ", wanted, " is needed"));
    return otherwise;
  }
  Curve curve;
  for (const toml::node& element : *array) {
    const auto knot = numbers_of(element, 2);
    const std::size_t place = curve.size();
    const auto refuse = [&](const auto&... what) {
      errors_->add(line_of(element), column_of(element), text_of(qualified(name_, key), "[", place, "]"),
                   text_of(what...));
    };
    if (!knot) return refuse("is not a knot; ", wanted, " is needed"), otherwise;
    const double x = (*knot)[0];
    const double y = (*knot)[1];
    if (!within(x, xs)) {
      return refuse("x = ", x, " is out of range; ", xs.min, " to ", xs.max), otherwise;
    }
    if (!within(y, ys)) {
      return refuse("y = ", y, " is out of range; ", ys.min, " to ", ys.max), otherwise;
    }
    if (!curve.empty() && x - curve.back().x < 1e-3) {
      return refuse("x = ", x, " follows ", curve.back().x,
                    "; each is at least 0.001 more than the one before"),
             otherwise;
    }
    curve.push_back({x, y});
  }
  return curve;
}

std::array<double, 2> TableReader::pair(const std::string& key, Range range,
                                        const std::array<double, 2>& otherwise) {
  const toml::node* const node = table_of(table_).get(key);
  if (node == nullptr) return otherwise;
  const auto numbers = numbers_of(*node, 2);
  if (!numbers) return wrong_type(*this, *node, key, "a pair of numbers [a, b]"), otherwise;
  for (const double number : *numbers) {
    if (within(number, range)) continue;
    fail(key, text_of(number, " is out of range; ", range.min, " to ", range.max));
    return otherwise;
  }
  return {(*numbers)[0], (*numbers)[1]};
}

std::vector<double> TableReader::numbers(const std::string& key, Range range,
                                         const std::vector<std::size_t>& counts) {
  const toml::node* const node = find(*this, table_of(table_), key, "a list of numbers");
  if (node == nullptr) return {};
  for (const std::size_t count : counts) {
    const auto numbers = numbers_of(*node, count);
    if (!numbers) continue;
    for (const double number : *numbers) {
      if (within(number, range)) continue;
      return fail(key, text_of(number, " is out of range; ", range.min, " to ", range.max)),
             std::vector<double>{};
    }
    return {numbers->begin(), numbers->end()};
  }
  std::string wanted = "a list of";
  for (std::size_t i = 0; i < counts.size(); ++i) wanted += text_of(i == 0 ? " " : " or ", counts[i]);
  return wrong_type(*this, *node, key, wanted + " numbers"), std::vector<double>{};
}

std::vector<std::string> TableReader::texts(const std::string& key, std::size_t max_bytes,
                                            std::size_t max_count) {
  const toml::node* const node = find(*this, table_of(table_), key, "a list of strings");
  if (node == nullptr) return {};
  const toml::array* const list = node->as_array();
  const bool sized = list != nullptr && !list->empty() && list->size() <= max_count;
  if (!sized)
    return wrong_type(*this, *node, key, text_of("a list of 1 to ", max_count, " strings")),
           std::vector<std::string>{};
  std::vector<std::string> texts;
  for (const toml::node& each : *list) {
    const auto value = each.is_string() ? each.value<std::string>() : std::nullopt;
    if (!value || value->empty() || value->size() > max_bytes) {
      return fail(key, text_of("each must be a string of 1 to ", max_bytes, " bytes")),
             std::vector<std::string>{};
    }
    texts.push_back(*value);
  }
  return texts;
}

std::vector<std::string> TableReader::keys() const {
  std::vector<std::string> keys;
  for (const auto& [key, value] : table_of(table_)) keys.emplace_back(key.str());
  std::sort(keys.begin(), keys.end());
  return keys;
}

bool TableReader::boolean(const std::string& key) {
  const toml::node* const node = find(*this, table_of(table_), key, "true or false");
  if (node == nullptr) return false;
  const auto value = node->is_boolean() ? node->value<bool>() : std::nullopt;
  if (!value) return wrong_type(*this, *node, key, "true or false"), false;
  return *value;
}

std::string TableReader::text(const std::string& key, std::size_t max_bytes) {
  const toml::node* node = find(*this, table_of(table_), key, "a string");
  if (node == nullptr) return {};
  const auto value = node->is_string() ? node->value<std::string>() : std::nullopt;
  if (!value) return wrong_type(*this, *node, key, "a string"), std::string{};
  if (value->empty() || value->size() > max_bytes) {
    fail(key, text_of("1 to ", max_bytes, " bytes, this has ", value->size()));
  }
  return *value;
}

std::size_t TableReader::choice(const std::string& key, std::initializer_list<std::string_view> names) {
  const std::string chosen = text(key, 64);
  const auto found = std::find(names.begin(), names.end(), chosen);
  if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
  fail(key, "'" + shortened(chosen, kMaxShown) + "' is not one of: " + list_of(names));
  return 0;
}

void TableReader::take_name(const std::string& key, const std::string& name, std::set<std::string>& taken) {
  if (const auto fault = material_name_fault(name)) {
    fail(key, *fault);
  } else if (!taken.insert(name).second) {
    fail(key, "'" + name + "' names another material already; names are unique");
  }
}

void TableReader::take_material_name(const std::string& key, const std::string& name,
                                     std::set<std::string>& taken) {
  take_name(key, name, taken);
  if (taken.size() > kMaxMaterials) {
    fail(key, text_of("'", name, "' is one material too many: at most ", kMaxMaterials,
                      " besides air and water, including materials of looks, provinces, ores and objects"));
  }
}

std::string TableReader::material_name(std::set<std::string>& taken) {
  const toml::node* node = find(*this, table_of(table_), "name", "a string");
  if (node == nullptr) return {};
  const auto value = node->is_string() ? node->value<std::string>() : std::nullopt;
  if (!value) return wrong_type(*this, *node, "name", "a string"), std::string{};
  take_material_name("name", *value, taken);
  return *value;
}

Colour TableReader::colour(const std::string& key) {
  constexpr const char* kWanted = "\"#rrggbb\", as \"#8d8478\",";
  const toml::node* node = find(*this, table_of(table_), key, kWanted);
  if (node == nullptr) return {};
  const auto text = node->is_string() ? node->value<std::string>() : std::nullopt;
  const bool shaped = text && text->size() == 7 && text->front() == '#' &&
                      text->find_first_not_of("0123456789abcdefABCDEF", 1) == std::string::npos;
  if (!text) return wrong_type(*this, *node, key, kWanted), Colour{};
  if (!shaped) {
    fail(key, text_of("'", shortened(*text, kMaxShown), "' is not a colour; ", kWanted, " is needed"));
    return {};
  }
  const auto channel = [&](std::size_t at) {
    std::uint8_t value = 0;
    std::from_chars(text->data() + at, text->data() + at + 2, value, 16);
    return value;
  };
  return {channel(1), channel(3), channel(5)};
}

std::optional<TableReader> TableReader::table(const std::string& key) {
  const std::string wanted = "a table [" + key + "]";
  const toml::node* node = find(*this, table_of(table_), key, wanted);
  if (node == nullptr) return std::nullopt;
  if (!node->is_table()) return wrong_type(*this, *node, key, wanted), std::nullopt;
  return TableReader{opaque(*node->as_table()), qualified(name_, key), *errors_};
}

std::optional<TableReader> TableReader::table_or_empty(const std::string& key) {
  static const toml::table kNone;
  if (has(key)) return table(key);
  return TableReader{opaque(kNone), qualified(name_, key), *errors_};
}

std::vector<TableReader> TableReader::tables(const std::string& key) {
  std::vector<TableReader> found;
  const std::string wanted = "tables [[" + key + "]]";
  const toml::node* node = find(*this, table_of(table_), key, "at least one [[" + key + "]]");
  if (node == nullptr) return found;
  if (!node->is_array()) return wrong_type(*this, *node, key, wanted), found;
  for (const toml::node& element : *node->as_array()) {
    if (!element.is_table()) return wrong_type(*this, element, key, wanted), found;
    const std::string name = qualified(name_, key) + "[" + std::to_string(found.size()) + "]";
    found.emplace_back(opaque(*element.as_table()), name, *errors_);
  }
  if (found.empty()) fail(key, "empty; at least one [[" + key + "]] is needed");
  return found;
}

std::optional<TomlDocument> TomlDocument::parse(std::string_view text, SpecErrors& errors) {
  if (const auto fault = find_toml_fault(text)) {
    errors.add(fault->line, 0, "", fault->what);
    return std::nullopt;
  }
  const auto refuse = [&](const toml::parse_error& bad) {
    const auto line = static_cast<int>(bad.source().begin.line);
    const std::string key = toml_key_at_line(text, line);
    errors.add(line, static_cast<int>(bad.source().begin.column), shortened(key, kMaxKeyShown),
               "not TOML: " + toml_error_text(bad.description(), key));
    return std::nullopt;
  };
#if TOML_EXCEPTIONS
  try {
    return TomlDocument{std::make_unique<const Tree>(Tree{toml::parse(text)})};
  } catch (const toml::parse_error& bad) {
    return refuse(bad);
  }
#else
  toml::parse_result result = toml::parse(text);
  if (!result) return refuse(result.error());
  return TomlDocument{std::make_unique<const Tree>(Tree{std::move(result).table()})};
#endif
}

TomlDocument::TomlDocument(std::unique_ptr<const Tree> parsed) : parsed_{std::move(parsed)} {}
TomlDocument::TomlDocument(TomlDocument&&) noexcept = default;
TomlDocument& TomlDocument::operator=(TomlDocument&&) noexcept = default;
TomlDocument::~TomlDocument() = default;

const TomlTable& TomlDocument::root() const {
  return opaque(parsed_->root);
}

}  // namespace talus::terrain
