// What there is at single columns: the ground's height, the look, and quantities such as temperature. Pure;
// any thread may call.
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

/// The names that PlaceSampler knows in a world: quantities but for slope and cliff, and all fields.
[[nodiscard]] std::vector<std::string> place_names(const World& world);

/// Keeps its memory from call to call. For one thread at a time; the world must outlive it.
class PlaceSampler {
 public:
  /// Values will be those of `names`; none of a sampler where a name is not one of place_names().
  [[nodiscard]] static std::optional<PlaceSampler> make(const World& world,
                                                        std::span<const std::string> names);
  ~PlaceSampler();
  PlaceSampler(PlaceSampler&&) noexcept;
  PlaceSampler& operator=(PlaceSampler&&) noexcept;

  /// From here on rows are over these ascending base columns.
  void start(std::span<const std::int64_t> xs);
  /// The columns (xs[i], z), valid until the next call. Rows close to the one before cost least.
  void row(std::int64_t z);

  /// H in subvoxels, before talus and erosion move it.
  [[nodiscard]] std::span<const std::int32_t> heights_fx() const;
  /// Numbers of World::look_names(); all 0 in a world without looks.
  [[nodiscard]] std::span<const std::uint8_t> looks() const;
  /// Of names[i]: places_spec.h says in which units.
  [[nodiscard]] std::span<const float> values(std::size_t i) const;

 private:
  struct Scratch;
  explicit PlaceSampler(std::unique_ptr<Scratch> scratch);
  std::unique_ptr<Scratch> scratch_;
};

/// What there is at columns anywhere.
struct PlacesFound {
  std::vector<std::uint8_t> looks;  // one a column: a number of World::look_names()
  std::vector<float> values;        // of each column those of all names, in their order
};
/// REQUIRES that place_names() has all of `names`. Columns of one row cost least beside each other.
[[nodiscard]] PlacesFound places_at(const World& world, std::span<const BaseColumn> columns,
                                    std::span<const std::string> names);

}  // namespace talus::terrain
