// What land of kind "regions" is made of, for programs that measure it: DESIGN.md, "Regions". Pure; the world
// need not outlive what is made of it.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <talus/terrain/heights.h>
#include <talus/terrain/world.h>

namespace talus::terrain {

/// The parts of heights at base columns, in terrain units over the sea. Keeps its memory from call to call.
/// For one thread at a time.
class LandPartsSampler {
 public:
  /// None where the surface is of another kind.
  [[nodiscard]] static std::optional<LandPartsSampler> make(const World& world);
  ~LandPartsSampler();
  LandPartsSampler(LandPartsSampler&&) noexcept;
  LandPartsSampler& operator=(LandPartsSampler&&) noexcept;

  /// From here on rows are over these ascending base columns.
  void start(std::span<const std::int64_t> xs);
  /// The columns (xs[i], z). Rows close to the one before cost least. What follows holds a number for each of
  /// them until the next call, and nothing before the first.
  void row(std::int64_t z);

  /// Before it is rounded, and talus and erosion move it. Within 7 units of the sea all parts of it are made
  /// smaller, down to 0.3 times, as beaches are flat; what terraces and beds say is before that.
  [[nodiscard]] std::span<const float> height() const;
  /// By how much terraces raise it.
  [[nodiscard]] std::span<const float> terraces() const;
  /// By how much a river's bed lies under its banks; 0 beside it.
  [[nodiscard]] std::span<const float> bed() const;
  /// In a bed, how much of a river there is: 1 of a whole one, less where one fades away in the hills.
  [[nodiscard]] std::span<const float> river() const;
  /// What rivers cut the land down to: 1.2 over the sea, and more in high land.
  [[nodiscard]] std::span<const float> flood_plain() const;

 private:
  struct Scratch;
  explicit LandPartsSampler(std::unique_ptr<Scratch> scratch);
  std::unique_ptr<Scratch> scratch_;
};

/// Where the noises that shape the land have the lattices of their first octaves: high ground should know
/// nothing of them. Immutable; any thread may ask.
class ShapingLattices {
 public:
  /// None where the surface is of another kind.
  [[nodiscard]] static std::optional<ShapingLattices> make(const World& world);
  ~ShapingLattices();
  ShapingLattices(ShapingLattices&&) noexcept;
  ShapingLattices& operator=(ShapingLattices&&) noexcept;

  [[nodiscard]] const std::vector<std::string>& names() const;

  enum class Spot : std::uint8_t { point, middle };  // of a cell
  /// The base column near `from` that the noise of names()[noise] reads at a lattice point, or in the middle
  /// of a cell: displaced as that noise is. None where the displacement leaves none. REQUIRES that `noise` is
  /// less than names().size().
  [[nodiscard]] std::optional<BaseColumn> column(std::size_t noise, BaseColumn from, Spot spot) const;

 private:
  struct Lattices;
  explicit ShapingLattices(std::unique_ptr<const Lattices> lattices);
  std::unique_ptr<const Lattices> lattices_;
};

}  // namespace talus::terrain
