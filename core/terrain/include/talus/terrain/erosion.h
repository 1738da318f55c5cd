// The erosion method (thesis 3.5): loose material moves down until it lies at its angle of repose, and the
// surface changes with it. Exact: uses only integers, and does not depend on the order of columns.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <talus/terrain/field.h>

namespace talus::terrain {

/// The neighbours to which material may move (thesis fig. 15). `all` is the method; the others halve the
/// comparisons and exist for comparison.
enum class Neighbours : std::uint8_t { all, von_neumann, diagonal };

/// Loose material on an immobile base. All fields have the same size and are in subvoxels.
struct LooseGround {
  Field base;
  std::vector<Field> thickness;  // one field per material, heaviest first: from the base up

  /// Returns the base plus all thicknesses.
  [[nodiscard]] Field surface() const;
};

/// Parameters of one loose material.
struct LooseRules {
  std::int32_t t_fx = 0;  // thickness set loose in each column
  std::int32_t c_fx = 0;  // the largest height difference between neighbours at rest; 4 or more (1 degree)
};

/// Maximum amount that leaves a column in one step: c / 8, but at least 1. With this bound the sum of squared
/// heights falls by at least the amount moved (docs/DESIGN.md, "Erosion method"), so a single material comes
/// to rest.
[[nodiscard]] constexpr std::int32_t erosion_step_fx(std::int32_t c_fx) {
  return std::max(1, c_fx / 8);
}

/// Turns the top of each stack into loose material and orders it (thesis fig. 10). `rules` are heaviest
/// first. If a column is too low for all materials, the lowest are missing. `most`, if not empty, gives each
/// material's thickness at each column instead of its rule's; an empty field in it means the rule's.
void set_loose(const Field& surface, std::span<const LooseRules> rules, std::span<const Field> most,
               LooseGround& ground);
inline void set_loose(const Field& surface, std::span<const LooseRules> rules, LooseGround& ground) {
  set_loose(surface, rules, {}, ground);
}

/// Moves material step by step. Reuses its memory; not thread-safe.
class Eroder {
 public:
  explicit Eroder(Neighbours neighbours = Neighbours::all);

  /// Does one step of every material; all columns read the state before the step. Nothing leaves the fields:
  /// material cannot move past their edges. After a step, columns less than two from an edge are affected;
  /// use `rest` for maps that end at the edges, and generate() in generator.h for land that does not. Returns
  /// true if anything moved.
  bool step(std::span<const LooseRules> rules, LooseGround& ground);
  /// A step in pieces: call see_surface() for every material from the heaviest, then step_material() for
  /// every material, in any order.
  void see_surface(std::size_t material, const LooseGround& ground);
  bool step_material(std::size_t material, const LooseRules& rules, LooseGround& ground);

  /// For a map that ends at its edges: brings the heaviest material to rest, then the next on top of it, and
  /// so on. Returns the total number of steps.
  std::int64_t rest(std::span<const LooseRules> rules, LooseGround& ground);

  /// One step of one material with a given `step_fx`; for the test of larger steps.
  bool move(const Field& surface, std::int32_t c_fx, std::int32_t step_fx, Field& thickness);

 private:
  struct Reach {
    int x = 0;
    int z = 0;
  };

  /// Writes the minimum over each column of row z and its eight neighbours into lowest_: a fast test, as most
  /// columns are at rest.
  void find_lowest_around(const Field& surface, int z);

  /// Adds to change_ the amounts that column (x, z) gives to its neighbours. Returns true if it gives any.
  bool give(const Field& surface, std::int32_t c_fx, std::int32_t max_given, int x, int z);

  std::vector<Reach> reaches_;
  std::vector<Field> surfaces_;
  Field change_;
  std::vector<std::int32_t> lowest_in_column_;
  std::vector<std::int32_t> lowest_;
};

}  // namespace talus::terrain
