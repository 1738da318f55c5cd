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

/// What compose() also says of each column, where it is not null. Padded.
struct RegionDetails {
  float* height = nullptr;    // over the sea, before it is rounded
  float* terraces = nullptr;  // 0 to 1
  float* small = nullptr;     // small hills
};

/// A line of samples: the noises of the slow fields, not equalized. Padded.
struct SlowNoises {
  const float* continents = nullptr;
  const float* ranges = nullptr;
  const float* hilliness = nullptr;
  const float* mesas = nullptr;
  const float* temperature = nullptr;
  const float* moisture = nullptr;
};

/// And what they say: regions.h. Padded.
struct SlowLand {
  float* base = nullptr;
  float* belt = nullptr;
  float* hills = nullptr;
  float* mesa = nullptr;
  float* terrace = nullptr;
  float* temperature = nullptr;
  float* moisture = nullptr;
};

/// How a displacement grows a column eastward and southward. Padded.
struct Stretch {
  float* by_x = nullptr;
  float* by_z = nullptr;
};

struct RegionKernels {
  /// A displacement by two noises, each times its reach, in 2^-8 columns, rounded to even and at most 2^22;
  /// and its stretch. Writes up to kPadding further; so do the others.
  void (*displace)(const SlopedRow& wide, const SlopedRow& narrow, const std::array<float, 2>& reach,
                   std::size_t width, std::int32_t* out, const Stretch& stretch);
  /// The signed distance, in terrain units, from where a displaced noise is 0: that over its gradient.
  /// `saddle` keeps it finite and continuous where the gradient is 0, at saddles and summits.
  void (*distances)(const SlopedRow& noise, const Stretch& east, const Stretch& south, float saddle,
                    float units_a_column, std::size_t width, float* out);
  void (*lay)(const SlowNoises& noises, const SlowFields& fields, std::size_t width, const SlowLand& land);
  /// Straight lines between samples: out[c * columns + k] is so much of the way from samples[c] to
  /// samples[c + 1] as fractions[k] says, for c < cells and k < columns. `columns` of a cell: 1, 2, 4 or 8.
  void (*spread)(const float* samples, std::size_t cells, std::size_t columns, const float* fractions,
                 float* out);
  /// H in subvoxels at `width` columns.
  void (*compose)(const RegionRow& row, const RegionShape& shape, std::size_t width, float highest_fx,
                  std::int32_t* heights_fx, const RegionDetails& details);
  /// A noise made uniform.
  void (*equalize)(const Equalizer& equalizer, const float* noise, std::size_t width, float* out);
};

[[nodiscard]] const RegionKernels& region_kernels(InstructionSet set);

}  // namespace talus::terrain
