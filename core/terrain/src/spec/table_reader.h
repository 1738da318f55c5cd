// One table of a world's TOML file, read key by key. Private to core/terrain.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <talus/terrain/world.h>
#include <talus/voxel/material_name.h>

#include "spec/spec_errors.h"

namespace talus::terrain {

// Ranges of keys, in terrain units. R >= 1, so they also bound the voxels in them.
inline constexpr double kMaxHeight = 32768;           // of anything above y = 0; also in voxels
inline constexpr double kMaxLength = 16777216;        // along x and z: 2^24; also in voxels
inline constexpr double kMinLength = 1e-6;            // for lengths that must not be 0
inline constexpr double kMinUnits_q16 = 1.0 / 65536;  // for integers of 2^-16 that must not be 0

/// Maximum bytes of any name.
inline constexpr std::size_t kMaxNameBytes = kMaxMaterialNameBytes;

struct Range {
  double min;
  double max;
};

/// The range of a length in voxels. `rounded`: it applies after rounding to whole voxels.
struct Voxels {
  int resolution;
  Range range;
  bool rounded = false;
};

/// A table of the TOML library. Only table_reader.cpp includes that library: it takes seconds to compile.
class TomlTable;

/// Reads and checks keys. The first error goes to the SpecErrors; reading continues with the smallest allowed
/// value, so callers need no error paths. The document and the errors must outlive the reader.
class TableReader {
 public:
  /// `name` is the table's name in messages, e.g. "faults[1]"; empty for the root.
  TableReader(const TomlTable& table, std::string name, SpecErrors& errors)
      : table_{&table}, name_{std::move(name)}, errors_{&errors} {}

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] bool has(std::string_view key) const;
  /// All keys, sorted by name.
  [[nodiscard]] std::vector<std::string> keys() const;
  /// The line on which the table begins.
  [[nodiscard]] int line() const;
  /// The line of a key; the table's line if the key is omitted.
  [[nodiscard]] int line(std::string_view key) const;

  /// Reports an error of a key where its value is, or where the table begins if the key is omitted.
  void fail(std::string_view key, const std::string& what);
  /// Rejects all keys except `known`.
  void only(const std::vector<std::string_view>& known);

  /// `note` follows the range in the error.
  double real(const std::string& key, Range range, std::string_view note = {});
  /// A length in terrain units that must also be within a range in voxels. The error shows one range.
  double length(const std::string& key, Range units, const Voxels& voxels);
  std::int64_t integer(const std::string& key, std::int64_t min, std::int64_t max);
  bool boolean(const std::string& key);
  /// Terrain units as integers of 2^-16, so that no sequence depends on binary fractions.
  std::int64_t units_q16(const std::string& key, Range range);
  /// length(), rounded to integers of 2^-16 before the check.
  std::int64_t length_q16(const std::string& key, Range units, const Voxels& voxels);

  /// `key = [[x, y], ...]`: 1 to `max_count` knots, x ascending, both in range. `otherwise` if omitted.
  Curve curve(const std::string& key, Range xs, Range ys, std::size_t max_count, const Curve& otherwise);
  /// `key = [a, b]`. `otherwise` if omitted.
  std::array<double, 2> pair(const std::string& key, Range range, const std::array<double, 2>& otherwise);

  /// `key = [a, b, ...]` with one of the counts; empty after an error.
  std::vector<double> numbers(const std::string& key, Range range, const std::vector<std::size_t>& counts);

  std::string text(const std::string& key, std::size_t max_bytes);
  /// `key = ["a", ...]`: 1 to `max_count` strings.
  std::vector<std::string> texts(const std::string& key, std::size_t max_bytes, std::size_t max_count);
  /// The index in `names` of the key's value.
  std::size_t choice(const std::string& key, std::initializer_list<std::string_view> names);
  /// Reads `name`, a material's name that must not be in `taken`, and adds it there.
  std::string material_name(std::set<std::string>& taken);
  /// Adds a name that is not a key of its own; errors go to `key`. The number of names is not limited.
  void take_name(const std::string& key, const std::string& name, std::set<std::string>& taken);
  /// Adds the name of a generated material, whose number is limited.
  void take_material_name(const std::string& key, const std::string& name, std::set<std::string>& taken);
  /// Reads "#rrggbb".
  Colour colour(const std::string& key = "colour");

  /// The table [key]; nullopt, with an error, if the key is not a table.
  std::optional<TableReader> table(const std::string& key);
  /// The table [key], or one without keys if the key is omitted.
  std::optional<TableReader> table_or_empty(const std::string& key);
  /// All tables [[key]]; at least one must exist.
  std::vector<TableReader> tables(const std::string& key);

 private:
  std::optional<double> number(const std::string& key);
  /// Checks `value` against both ranges and fails `key` if it is outside. `shown` is the value as written.
  bool check_length(const std::string& key, double shown, double value, Range units, const Voxels& voxels);

  const TomlTable* table_;
  std::string name_;
  SpecErrors* errors_;
};

/// A parsed TOML file.
class TomlDocument {
 public:
  /// nullopt if the text breaks a bound of toml_bounds.h or is not TOML; `errors` then has the reason.
  [[nodiscard]] static std::optional<TomlDocument> parse(std::string_view text, SpecErrors& errors);
  TomlDocument(TomlDocument&&) noexcept;
  TomlDocument& operator=(TomlDocument&&) noexcept;
  ~TomlDocument();

  [[nodiscard]] const TomlTable& root() const;

 private:
  struct Tree;
  explicit TomlDocument(std::unique_ptr<const Tree> parsed);
  std::unique_ptr<const Tree> parsed_;
};

}  // namespace talus::terrain
