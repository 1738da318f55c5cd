// The surface "regions" at every column, a row at a time: between the samples of its slow fields, and the
// land that they and the shape make.
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

/// A row of columns; all padded.
struct RegionRow {
  const float* base = nullptr;
  const float* belt = nullptr;
  const float* hills = nullptr;
  const float* mesa = nullptr;
  const float* terrace = nullptr;
  const float* river = nullptr;
  const float* tributary_a = nullptr;
  const float* tributary_b = nullptr;
  std::array<const float*, kShapeOctaves> shape{};  // the noise of its octaves
};

/// A row of whole cells between samples, of 16 columns each, whose slow rows are not written but computed
/// where they are asked for.
struct RegionCells {
  RegionRow rows;                    // of slow rows c[0] of each cell's polynomial; of others the columns
  std::size_t plane = 0;             // numbers from each c[k] to c[k + 1]
  const float* fractions = nullptr;  // where a cell's columns lie, of the way from sample to sample
};

/// The same with its derivatives: how each rises a column eastward and southward.
struct SlopedRegionRow {
  RegionRow value;
  RegionRow east;
  RegionRow south;
};

/// What compose() also says of each column, where it is not null. Padded.
struct RegionDetails {
  float* height = nullptr;    // over the sea, before it is rounded
  float* terraces = nullptr;  // 0 to 1
  float* small = nullptr;     // small hills
  // Of cells alone, as RegionRow has them.
  float* base = nullptr;
  float* belt = nullptr;
  float* mesa = nullptr;
};

/// What heights are made of, in terrain units over the sea. Padded.
struct LandParts {
  float* height = nullptr;       // before it is rounded
  float* terraces = nullptr;     // by how much they raise it; at the shore a little less than that
  float* bed = nullptr;          // by how much a river's bed lies under its banks; 0 beside it
  float* river = nullptr;        // in a bed, how much of a river there is, 0 to 1
  float* flood_plain = nullptr;  // what a river cuts the land down to: 1.2, and more in high land
};

/// A line of samples: the noises of the slow fields, not equalized. Padded.
struct SlowNoises {
  const float* continents = nullptr;
  const float* ranges = nullptr;
  const float* hilliness = nullptr;
  const float* temperature = nullptr;
  const float* moisture = nullptr;
};

/// And what they say: regions.h. Padded.
struct SlowLand {
  float* base = nullptr;
  float* belt = nullptr;
  float* hills = nullptr;
  float* mesa = nullptr;
  float* temperature = nullptr;
  float* moisture = nullptr;
};

/// How a displacement grows a column eastward and southward. Padded.
struct Stretch {
  float* by_x = nullptr;
  float* by_z = nullptr;
};

/// A row that is written, and its derivatives, which may be null. Padded.
struct SlopedOut {
  float* value = nullptr;
  float* east = nullptr;
  float* south = nullptr;
};

/// Four lines of samples, padded, and how much of each is summed.
struct SampleLines {
  std::array<const float*, 4> line{};
  std::array<float, 4> share{};
};

/// Rows of samples on four lines, and how much of each line is summed.
struct SampleRows {
  std::array<const float* const*, 4> line{};
  std::array<float, 4> share{};
  std::size_t count = 0;    // rows
  std::size_t samples = 0;  // of each
  std::size_t stride = 0;   // of what is written
};

/// What lies between four samples in a row, each time: `columns` (1, 2, 4, 8 or 16) between the middle two.
struct Cells {
  std::size_t count = 0;  // 3 less than there are samples
  std::size_t columns = 1;
  const float* fractions = nullptr;  // where they lie, of the way from sample to sample
  float* scratch = nullptr;          // 4 padded rows of samples
};

struct RegionKernels {
  /// A displacement by two noises, each times its reach, in 2^-8 columns, rounded to even and at most 2^22;
  /// and its stretch. Writes up to kPadding further; so do the others.
  void (*displace)(const SlopedRow& wide, const SlopedRow& narrow, const std::array<float, 2>& reach,
                   std::size_t width, std::int32_t* out, const Stretch& stretch);
  /// The signed distance, in terrain units, from where a displaced noise is 0: that over its gradient.
  /// `saddle` keeps it finite and continuous where the gradient is 0, at saddles and summits.
  void (*distances)(const SlopedRow& noise, const Stretch& east, const Stretch& south, float saddle,
                    float units_a_column, std::size_t width, const SlopedOut& out);
  void (*lay)(const SlowNoises& noises, const SlowFields& fields, std::size_t width, const SlowLand& land);
  /// The same from noises and their derivatives; of temperature and moisture the derivatives are left out.
  void (*lay_sloped)(const SlowNoises& noises, const SlowNoises& east, const SlowNoises& south,
                     const SlowFields& fields, std::size_t width, const SlowLand& land,
                     const SlowLand& land_east, const SlowLand& land_south);
  /// The derivatives of a noise that is displaced by `share` of a warp.
  void (*bend)(const SlopedRow& noise, const Stretch& east, const Stretch& south, float share,
               std::size_t width, float* out_east, float* out_south);
  /// The sum of four lines.
  void (*blend)(const SampleLines& lines, std::size_t width, float* out);
  /// Four lines of `count` rows of samples summed, and the polynomials between: of cell i of row k, c[n] is
  /// at planes[n * plane + k * stride + i]. `stride` is a multiple of 16 and not less than `samples`;
  /// `plane` is kPadding more than all rows, and `planes` has five of them.
  void (*cubics)(const SampleRows& rows, std::size_t plane, float* planes);
  /// Cubics between samples: values at `cells.count * cells.columns` columns from the second sample on, and
  /// how they rise a column eastward, which may be null. All padded.
  void (*spread)(const float* samples, const Cells& cells, float* out, float* rise);
  /// H in subvoxels at `width` columns.
  void (*compose)(const RegionRow& row, const RegionShape& shape, std::size_t width, float highest_fx,
                  std::int32_t* heights_fx, const RegionDetails& details);
  /// The same from cells.
  void (*compose_cells)(const RegionCells& cells, const RegionShape& shape, std::size_t width,
                        float highest_fx, std::int32_t* heights_fx, const RegionDetails& details);
  /// At columns of a coarse level: H with rivers `widened` to that half width at least, the slope of H as
  /// level 0 has it, by its derivatives, and what level 0 has of the rest.
  void (*compose_sloped)(const SlopedRegionRow& row, const RegionShape& shape, float widened,
                         std::size_t width, float highest_fx, std::int32_t* heights_fx,
                         std::int32_t* slopes_fx, const RegionDetails& details);
  /// The parts of what compose() says. For measurements: slower than it, and of no weight in what it costs.
  void (*part)(const RegionRow& row, const RegionShape& shape, std::size_t width, const LandParts& parts);
  /// A noise made uniform.
  void (*equalize)(const Equalizer& equalizer, const float* noise, std::size_t width, float* out);
  void (*equalize_sloped)(const Equalizer& equalizer, const SlopedRow& noise, std::size_t width,
                          const SlopedOut& out);
};

[[nodiscard]] const RegionKernels& region_kernels(InstructionSet set);

}  // namespace talus::terrain
