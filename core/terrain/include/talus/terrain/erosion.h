// The erosion method (thesis 3.5): loose material moves down until it lies at its angle of repose, and the
// surface changes with it. Exact: integers throughout, no dependence on the order in which columns are looked
// at.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <talus/terrain/field.h>

namespace talus::terrain {

/// To which of the columns around it material may move (thesis fig. 15). `all` is the method; the others
/// halve the comparisons and are here to be compared.
enum class Neighbours : std::uint8_t { all, von_neumann, diagonal };

/// Loose material on what does not move. Fields of one size, in subvoxels.
struct LooseGround {
  Field base;
  std::vector<Field> thickness;  // of each material, heaviest first: they lie in this order from the base up

  /// The surface: the base and everything on it.
  [[nodiscard]] Field surface() const;
};

/// What one loose material needs to know of itself.
struct LooseRules {
  std::int32_t t_fx = 0;  // how much of it is set loose in each column
  std::int32_t c_fx =
      0;  // the largest difference of heights between neighbours at rest; 4 or more (1 degree)
};

/// The most that leaves a column in one step: c / 8, and at least 1. With it the sum of squared heights falls
/// by at least what has moved (docs/DESIGN.md, "Erosion method"), so that a material alone comes to rest.
[[nodiscard]] constexpr std::int32_t erosion_step_fx(std::int32_t c_fx) {
  return std::max(1, c_fx / 8);
}

/// Turns the top of each stack into loose material and orders it (thesis fig. 10). `rules` heaviest first. A
/// column too low for all of it lacks the lowest. `most`, where it is not empty: the thickness of each
/// material at each column instead of its rule's; an empty field stands for that.
void set_loose(const Field& surface, std::span<const LooseRules> rules, std::span<const Field> most,
               LooseGround& ground);
inline void set_loose(const Field& surface, std::span<const LooseRules> rules, LooseGround& ground) {
  set_loose(surface, rules, {}, ground);
}

/// Moves material step by step. Keeps its memory; for one thread at a time.
class Eroder {
 public:
  explicit Eroder(Neighbours neighbours = Neighbours::all);

  /// One step of every material, all columns at once from the state before it. Nothing leaves the fields:
  /// beyond their edges lies nothing to move to. After a step, columns less than two from an edge are
  /// affected; see `rest` for maps that end there, and generate() in generator.h for land that does not. True
  /// where something moved.
  bool step(std::span<const LooseRules> rules, LooseGround& ground);
  /// A step in pieces: see_surface() of every material from the heaviest, then step_material() of every one,
  /// in any order.
  void see_surface(std::size_t material, const LooseGround& ground);
  bool step_material(std::size_t material, const LooseRules& rules, LooseGround& ground);

  /// A map that ends at its edges: the heaviest material to rest, then the next upon it, and so on. How many
  /// steps it took in all.
  std::int64_t rest(std::span<const LooseRules> rules, LooseGround& ground);

  /// With a step of the caller's, for the test of what a larger one does.
  bool move(const Field& surface, std::int32_t c_fx, std::int32_t step_fx, Field& thickness);

 private:
  struct Reach {
    int x = 0;
    int z = 0;
  };

  /// Of each column of row z and its eight neighbours, into lowest_: most columns lie still, and this finds
  /// them fast.
  void find_lowest_around(const Field& surface, int z);

  /// What column (x, z) gives to its neighbours, into change_. True where it gives anything.
  bool give(const Field& surface, std::int32_t c_fx, std::int32_t max_given, int x, int z);

  std::vector<Reach> reaches_;
  std::vector<Field> surfaces_;
  Field change_;
  std::vector<std::int32_t> lowest_in_column_;
  std::vector<std::int32_t> lowest_;
};

}  // namespace talus::terrain
