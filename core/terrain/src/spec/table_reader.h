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

// Ranges of single keys, in terrain units. R >= 1, so they hold the voxels within them too.
inline constexpr double kMaxHeight = 32768;           // of anything above y = 0; in voxels also
inline constexpr double kMaxLength = 16777216;        // along x and z: 2^24; in voxels also
inline constexpr double kMinLength = 1e-6;            // of what may not be 0
inline constexpr double kMinUnits_q16 = 1.0 / 65536;  // of what becomes an integer of 2^-16 and may not be 0

/// Bytes of a name, of a material or of anything else.
inline constexpr std::size_t kMaxNameBytes = kMaxMaterialNameBytes;

struct Range {
  double min;
  double max;
};

/// What a length must come to in voxels. `rounded`: after rounding to whole ones.
struct Voxels {
  int resolution;
  Range range;
  bool rounded = false;
};

/// A table of the TOML library. Only table_reader.cpp includes that library: it takes seconds to compile.
class TomlTable;

/// Reads keys and checks each. The first fault goes to the SpecErrors; reading goes on with the least value
/// allowed, so callers need no error paths. The document and the errors must outlive the reader.
class TableReader {
 public:
  /// `name` is the table's in messages, "faults[1]"; empty for the root.
  TableReader(const TomlTable& table, std::string name, SpecErrors& errors)
      : table_{&table}, name_{std::move(name)}, errors_{&errors} {}

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] bool has(std::string_view key) const;
  /// All, by name.
  [[nodiscard]] std::vector<std::string> keys() const;
  /// Where the table begins.
  [[nodiscard]] int line() const;
  /// Where a key stands; where it is left out, the table's line.
  [[nodiscard]] int line(std::string_view key) const;

  /// Refuses a key at line(key).
  void fail(std::string_view key, const std::string& what);
  /// Refuses all keys but these.
  void only(const std::vector<std::string_view>& known);

  /// `note` stands behind the range in the error.
  double real(const std::string& key, Range range, std::string_view note = {});
  /// Terrain units that must also come to a range in voxels. The error tells the one range that holds both.
  double length(const std::string& key, Range units, const Voxels& voxels);
  std::int64_t integer(const std::string& key, std::int64_t min, std::int64_t max);
  bool boolean(const std::string& key);
  /// Terrain units as integers of 2^-16, so that no sequence depends on binary fractions.
  std::int64_t units_q16(const std::string& key, Range range);
  /// length() of the rounded units.
  std::int64_t length_q16(const std::string& key, Range units, const Voxels& voxels);

  /// `key = [[x, y], ...]`: 1 to `most` knots, x ascending, both in range. Left out: `otherwise`.
  Curve curve(const std::string& key, Range xs, Range ys, std::size_t most, const Curve& otherwise);
  /// `key = [a, b]`. Left out: `otherwise`.
  std::array<double, 2> pair(const std::string& key, Range range, const std::array<double, 2>& otherwise);

  /// `key = [a, b, ...]` of one of these counts; empty after a fault.
  std::vector<double> numbers(const std::string& key, Range range, const std::vector<std::size_t>& counts);

  std::string text(const std::string& key, std::size_t max_bytes);
  /// `key = ["a", ...]`: 1 to `most` strings.
  std::vector<std::string> texts(const std::string& key, std::size_t max_bytes, std::size_t most);
  /// The index in `names` of the key's value.
  std::size_t choice(const std::string& key, std::initializer_list<std::string_view> names);
  /// `name`: a material's, which none of `taken` may be; it joins them.
  std::string material_name(std::set<std::string>& taken);
  /// The same of a name that is not in the file by itself; faults go to `key`. Any number may be taken.
  void take_name(const std::string& key, const std::string& name, std::set<std::string>& taken);
  /// The same of a material that is generated, of which there are few.
  void take_material_name(const std::string& key, const std::string& name, std::set<std::string>& taken);
  /// `colour`, or that key: "#rrggbb".
  Colour colour(const std::string& key = "colour");

  /// The table [key]; none where the key is no table, which is an error.
  std::optional<TableReader> table(const std::string& key);
  /// The same, and one without keys where there is none.
  std::optional<TableReader> table_or_empty(const std::string& key);
  /// All tables [[key]], of which there must be at least one.
  std::vector<TableReader> tables(const std::string& key);

 private:
  std::optional<double> number(const std::string& key);
  /// Whether `value` is within both; fails `key` where it is not. `shown` is the value as it stands.
  bool check_length(const std::string& key, double shown, double value, Range units, const Voxels& voxels);

  const TomlTable* table_;
  std::string name_;
  SpecErrors* errors_;
};

/// A parsed TOML file.
class TomlDocument {
 public:
  /// None where the text breaks a bound of toml_bounds.h or is not TOML; `errors` says why.
  [[nodiscard]] static std::optional<TomlDocument> parse(std::string_view text, SpecErrors& errors);
  TomlDocument(TomlDocument&&) noexcept;
  TomlDocument& operator=(TomlDocument&&) noexcept;
  ~TomlDocument();

  [[nodiscard]] const TomlTable& root() const;

 private:
  struct Parsed;
  explicit TomlDocument(std::unique_ptr<const Parsed> parsed);
  std::unique_ptr<const Parsed> parsed_;
};

}  // namespace talus::terrain
