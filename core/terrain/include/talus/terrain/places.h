// Properties of single columns: the ground's height, the look, and quantities such as temperature. Pure;
// thread-safe.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <talus/terrain/heights.h>
#include <talus/terrain/places_spec.h>
#include <talus/terrain/world.h>

namespace talus::terrain {

/// Names that PlaceSampler accepts in a world: all quantities except slope and cliff, and all fields.
[[nodiscard]] std::vector<std::string> place_names(const World& world);

/// Samples rows of columns. Reuses its memory; not thread-safe. The world must outlive it.
class PlaceSampler {
 public:
  /// Makes a sampler of the values `names`; nullopt if a name is not among place_names().
  [[nodiscard]] static std::optional<PlaceSampler> make(const World& world,
                                                        std::span<const std::string> names);
  ~PlaceSampler();
  PlaceSampler(PlaceSampler&&) noexcept;
  PlaceSampler& operator=(PlaceSampler&&) noexcept;

  /// The following rows are over these ascending base columns.
  void start(std::span<const std::int64_t> xs);
  /// Computes the columns (xs[i], z), valid until the next call. Cheapest for rows close to the previous one.
  void row(std::int64_t z);

  /// H in subvoxels, before talus and erosion.
  [[nodiscard]] std::span<const std::int32_t> heights_fx() const;
  /// Indices into World::look_names(); all 0 in a world without looks.
  [[nodiscard]] std::span<const std::uint8_t> looks() const;
  /// Values of names[i]; see places_spec.h for units.
  [[nodiscard]] std::span<const float> values(std::size_t i) const;

 private:
  struct Scratch;
  explicit PlaceSampler(std::unique_ptr<Scratch> scratch);
  std::unique_ptr<Scratch> scratch_;
};

/// Properties of any set of columns.
struct PlaceValues {
  std::vector<std::uint8_t> looks;  // one per column: index into World::look_names()
  std::vector<float> values;        // by column, then in the order of the names
};
/// REQUIRES that `names` is a subset of place_names(). Cheapest for adjacent columns of a row.
[[nodiscard]] PlaceValues places_at(const World& world, std::span<const BaseColumn> columns,
                                    std::span<const std::string> names);

}  // namespace talus::terrain
