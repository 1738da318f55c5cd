// Places of a world at which its quality is measured, and the result of each.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <talus/terrain/field.h>
#include <talus/terrain/land_measures.h>
#include <talus/terrain/world.h>

#include <talus/map/column_grid.h>
#include "band_power.h"
#include "quality.h"
#include "water_pieces.h"

namespace talus::tools {

inline constexpr std::array kBandsFrom{16, 32, 64, 128, 256, 512};  // columns

/// Count of numbers, with the sums for mean and variance.
struct Moments {
  double count = 0;
  double sum = 0;
  double squares = 0;

  void add(double value);
  void add(const Moments& more);
  [[nodiscard]] double mean() const { return count == 0 ? 0 : sum / count; }
  [[nodiscard]] double variance() const;
};

/// Result of one place; the parts used depend on its kind.
struct PlaceResult {
  struct Extreme {
    std::int32_t fx = 0;
    std::int64_t x = 0;
    std::int64_t z = 0;
  };
  enum class Kind : std::uint8_t { spectrum, block, window, lattice };

  Kind kind = Kind::spectrum;
  std::size_t of = 0;  // spectrum: index of the band; lattice: index of the noise
  std::optional<BandPower> power;
  std::vector<std::int64_t> by_look;  // columns of land
  std::int64_t columns = 0;
  std::int64_t water = 0;
  WaterPieces pieces;
  Extreme step;
  Extreme other_step;             // not made by terraces
  Extreme bed{INT32_MIN};         // height of a complete river's bed above its flood plain
  Extreme fading_bed{INT32_MIN};  // the same for a river that fades out in the hills
  std::int64_t beds = 0;          // columns
  std::int64_t fading_beds = 0;
  std::array<std::int64_t, kSlopeDegrees.size()> steep{};
  Extreme highest{INT32_MIN};
  Extreme deepest{INT32_MAX};
  Moments at_points;  // heights in voxels
  Moments at_middles;
};

class QualityPlaces {
 public:
  /// Both must outlive this object.
  QualityPlaces(const terrain::World& world, const QualityOptions& options);

  [[nodiscard]] std::size_t count() const;
  [[nodiscard]] std::uint64_t columns() const;
  /// Thread-safe.
  [[nodiscard]] PlaceResult measure(std::size_t index) const;
  /// Noises whose lattices are measured; empty if the surface is not made of regions.
  [[nodiscard]] std::vector<std::string> lattices() const;

 private:
  [[nodiscard]] std::size_t spectra() const;
  [[nodiscard]] std::size_t batches() const;  // batches per lattice
  [[nodiscard]] bool is_wet(std::int32_t height_fx) const;
  [[nodiscard]] PlaceResult spectrum(std::size_t band, std::size_t index) const;
  [[nodiscard]] PlaceResult block(std::size_t index) const;
  [[nodiscard]] PlaceResult window(std::size_t index) const;
  [[nodiscard]] PlaceResult lattice(std::size_t noise, std::size_t batch) const;
  void measure_parts(const map::ColumnGrid& grid, PlaceResult& result) const;

  const terrain::World& world_;
  const QualityOptions& options_;
  std::optional<terrain::ShapingLattices> lattices_;
};

}  // namespace talus::tools
