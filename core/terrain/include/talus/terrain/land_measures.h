// The parts of a surface of kind "regions", for programs that measure it: DESIGN.md, "Regions". Pure; the
// world need not outlive the objects made from it.
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

/// Samples the parts of heights at base columns, in terrain units above the sea. Reuses its memory; not
/// thread-safe.
class LandPartsSampler {
 public:
  /// nullopt if the surface is of another kind.
  [[nodiscard]] static std::optional<LandPartsSampler> make(const World& world);
  ~LandPartsSampler();
  LandPartsSampler(LandPartsSampler&&) noexcept;
  LandPartsSampler& operator=(LandPartsSampler&&) noexcept;

  /// The following rows are over these ascending base columns.
  void start(std::span<const std::int64_t> xs);
  /// Computes the columns (xs[i], z). Cheapest for rows close to the previous one. The spans below hold one
  /// value per column until the next call; they are empty before the first.
  void row(std::int64_t z);

  /// The height before rounding, and before talus and erosion. Within 7 units of the sea all its parts are
  /// scaled down, to 0.3 at least, to make beaches flat; terraces() and bed() are not scaled.
  [[nodiscard]] std::span<const float> height() const;
  /// The rise caused by terraces.
  [[nodiscard]] std::span<const float> terraces() const;
  /// Depth of a river's bed below its banks; 0 outside of a bed.
  [[nodiscard]] std::span<const float> bed() const;
  /// Share of a river in its bed: 1 for a whole river, less if it fades away in the hills.
  [[nodiscard]] std::span<const float> river() const;
  /// The height down to which rivers cut the land: 1.2 above the sea, more in high land.
  [[nodiscard]] std::span<const float> flood_plain() const;

 private:
  struct Scratch;
  explicit LandPartsSampler(std::unique_ptr<Scratch> scratch);
  std::unique_ptr<Scratch> scratch_;
};

/// Lattice positions of the first octaves of the noises that shape the land, to test that high ground shows
/// no trace of them. Immutable; thread-safe.
class ShapingLattices {
 public:
  /// nullopt if the surface is of another kind.
  [[nodiscard]] static std::optional<ShapingLattices> make(const World& world);
  ~ShapingLattices();
  ShapingLattices(ShapingLattices&&) noexcept;
  ShapingLattices& operator=(ShapingLattices&&) noexcept;

  [[nodiscard]] const std::vector<std::string>& names() const;

  enum class Spot : std::uint8_t { point, middle };  // of a lattice cell
  /// Returns the base column near `from` at which the noise names()[noise], with its displacement, reads a
  /// lattice point or the middle of a cell. nullopt if the displacement leaves no such column.
  /// REQUIRES noise < names().size().
  [[nodiscard]] std::optional<BaseColumn> column(std::size_t noise, BaseColumn from, Spot spot) const;

 private:
  struct Lattices;
  explicit ShapingLattices(std::unique_ptr<const Lattices> lattices);
  std::unique_ptr<const Lattices> lattices_;
};

}  // namespace talus::terrain
