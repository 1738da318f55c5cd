// The surface "regions" at every column, one row at a time: interpolation between the samples of its slow
// fields, and the land composed from them and the shape's noise.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <talus/terrain/regions_spec.h>
#include <talus/vectors/instruction_set.h>

namespace talus::terrain {

class Equalizer;
struct RegionShape;
struct SlopedRow;
struct SlowFields;

/// A row of columns; all arrays are padded.
struct RegionRow {
  const float* base = nullptr;
  const float* belt = nullptr;
  const float* hills = nullptr;
  const float* mesa = nullptr;
  const float* terrace = nullptr;
  const float* river = nullptr;
  const float* tributary_a = nullptr;
  const float* tributary_b = nullptr;
  std::array<const float*, kShapeOctaves> shape{};  // the noise of each octave
};

/// A row of whole cells between samples, of 16 columns each. Slow rows are not stored but computed on demand.
struct RegionCells {
  RegionRow rows;                    // slow rows: c[0] of each cell's polynomial; other rows: the columns
  std::size_t plane = 0;             // elements from c[k] to c[k + 1]
  const float* fractions = nullptr;  // positions of a cell's columns between its samples, 0 to 1
};

/// A row with its derivatives: the rise of each value per column eastward and southward.
struct SlopedRegionRow {
  RegionRow value;
  RegionRow east;
  RegionRow south;
};

/// Further outputs of compose() for each column, unless null. Padded.
struct RegionDetails {
  float* height = nullptr;    // above the sea, before rounding
  float* terraces = nullptr;  // 0 to 1
  float* small = nullptr;     // noise of the small hills
  // Only from cells; see RegionRow.
  float* base = nullptr;
  float* belt = nullptr;
  float* mesa = nullptr;
};

/// The parts of heights, in terrain units above the sea. Padded.
struct LandParts {
  float* height = nullptr;       // before rounding
  float* terraces = nullptr;     // rise by terraces; near the shore the actual rise is slightly less
  float* bed = nullptr;          // depth of a river's bed below its banks; 0 outside of a bed
  float* river = nullptr;        // share of a river in its bed, 0 to 1
  float* flood_plain = nullptr;  // height to which a river cuts the land: 1.2, more in high land
};

/// A line of samples: the noises of the slow fields, not equalized. Padded.
struct SlowNoises {
  const float* continents = nullptr;
  const float* ranges = nullptr;
  const float* hilliness = nullptr;
  const float* temperature = nullptr;
  const float* moisture = nullptr;
};

/// The land that follows from them: see regions.h. Padded.
struct SlowLand {
  float* base = nullptr;
  float* belt = nullptr;
  float* hills = nullptr;
  float* mesa = nullptr;
  float* temperature = nullptr;
  float* moisture = nullptr;
};

/// Rise of a displacement per column eastward and southward. Padded.
struct Stretch {
  float* by_x = nullptr;
  float* by_z = nullptr;
};

/// Output row and its derivatives, which may be null. Padded.
struct SlopedOutput {
  float* value = nullptr;
  float* east = nullptr;
  float* south = nullptr;
};

/// Four lines of samples, padded, and their weights.
struct SampleLines {
  std::array<const float*, 4> line{};
  std::array<float, 4> share{};
};

/// Rows of samples on four lines, and the lines' weights.
struct SampleRows {
  std::array<const float* const*, 4> line{};
  std::array<float, 4> share{};
  std::size_t count = 0;    // number of rows
  std::size_t samples = 0;  // samples of each row
  std::size_t stride = 0;   // distance between output rows
};

/// Interpolation over groups of four samples: `columns` (1, 2, 4, 8 or 16) columns between the middle two.
struct Cells {
  std::size_t count = 0;  // 3 less than the number of samples
  std::size_t columns = 1;
  const float* fractions = nullptr;  // positions of the columns between samples, 0 to 1
  float* scratch = nullptr;          // 4 padded rows of samples
};

struct RegionKernels {
  /// Computes a displacement by two noises, each times its reach, in 2^-8 columns, rounded to even and at
  /// most 2^22, and its stretch. Like all kernels here, may write kPadding elements past the end.
  void (*displace)(const SlopedRow& wide, const SlopedRow& narrow, const std::array<float, 2>& reach,
                   std::size_t width, std::int32_t* out, const Stretch& stretch);
  /// Computes the signed distance, in terrain units, to the zero line of a displaced noise: the noise divided
  /// by its gradient. `saddle` keeps it finite and continuous where the gradient is 0, at saddles and
  /// summits.
  void (*distances)(const SlopedRow& noise, const Stretch& east, const Stretch& south, float saddle,
                    float units_a_column, std::size_t width, const SlopedOutput& out);
  void (*lay)(const SlowNoises& noises, const SlowFields& fields, std::size_t width, const SlowLand& land);
  /// lay() from noises with their derivatives; derivatives of temperature and moisture are omitted.
  void (*lay_sloped)(const SlowNoises& noises, const SlowNoises& east, const SlowNoises& south,
                     const SlowFields& fields, std::size_t width, const SlowLand& land,
                     const SlowLand& land_east, const SlowLand& land_south);
  /// Computes the derivatives of a noise that is displaced by `share` of a warp.
  void (*bend)(const SlopedRow& noise, const Stretch& east, const Stretch& south, float share,
               std::size_t width, float* out_east, float* out_south);
  /// Sums four lines.
  void (*blend)(const SampleLines& lines, std::size_t width, float* out);
  /// Sums four lines of `count` rows of samples and computes the polynomials between: of cell i of row k,
  /// c[n] is at planes[n * plane + k * stride + i]. `stride` is a multiple of 16 and at least `samples`;
  /// `plane` is kPadding more than all rows, and `planes` has five of them.
  void (*cubics)(const SampleRows& rows, std::size_t plane, float* planes);
  /// Interpolates by cubics: values at `cells.count * cells.columns` columns from the second sample on, and
  /// their rise per column eastward, which may be null. All padded.
  void (*spread)(const float* samples, const Cells& cells, float* out, float* rise);
  /// Computes H in subvoxels at `width` columns.
  void (*compose)(const RegionRow& row, const RegionShape& shape, std::size_t width, float highest_fx,
                  std::int32_t* heights_fx, const RegionDetails& details);
  /// compose() from cells.
  void (*compose_cells)(const RegionCells& cells, const RegionShape& shape, std::size_t width,
                        float highest_fx, std::int32_t* heights_fx, const RegionDetails& details);
  /// Composes columns of a coarse level: H with rivers widened to a half width of at least `widened`, the
  /// slope of level 0's H from its derivatives, and level 0's values of the details.
  void (*compose_sloped)(const SlopedRegionRow& row, const RegionShape& shape, float widened,
                         std::size_t width, float highest_fx, std::int32_t* heights_fx,
                         std::int32_t* slopes_fx, const RegionDetails& details);
  /// Computes the parts of compose()'s heights. For measurements; slower, but its speed does not matter.
  void (*part)(const RegionRow& row, const RegionShape& shape, std::size_t width, const LandParts& parts);
  /// Makes a noise uniform.
  void (*equalize)(const Equalizer& equalizer, const float* noise, std::size_t width, float* out);
  void (*equalize_sloped)(const Equalizer& equalizer, const SlopedRow& noise, std::size_t width,
                          const SlopedOutput& out);
};

[[nodiscard]] const RegionKernels& region_kernels(InstructionSet set);

}  // namespace talus::terrain
