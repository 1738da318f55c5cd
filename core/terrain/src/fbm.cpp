#include <talus/terrain/fbm.h>

#include <algorithm>
#include <array>
#include <vector>

#include <talus/terrain/lattice_hash.h>
#include <talus/voxel/coords.h>

namespace talus::terrain {
namespace {

struct Gradient {
  float x;
  float z;
};

// 16 directions of length sqrt(2), so that the noise spans -1 to 1; turned by half a step, so that none
// lies along an axis or a diagonal, where the eye would find the lattice.
constexpr float kA = 1.38703985F;  // sqrt(2) * cos(11.25 degrees)
constexpr float kB = 1.17587560F;  // 33.75
constexpr float kC = 0.78569496F;  // 56.25
constexpr float kD = 0.27589938F;  // 78.75
constexpr std::array<Gradient, 16> kGradients{{{kA, kD},
                                               {kB, kC},
                                               {kC, kB},
                                               {kD, kA},
                                               {-kD, kA},
                                               {-kC, kB},
                                               {-kB, kC},
                                               {-kA, kD},
                                               {-kA, -kD},
                                               {-kB, -kC},
                                               {-kC, -kB},
                                               {-kD, -kA},
                                               {kD, -kA},
                                               {kC, -kB},
                                               {kB, -kC},
                                               {kA, -kD}}};

Gradient gradient_at(std::uint32_t x_hash, std::uint32_t z_hash) {
  return kGradients[corner_hash(x_hash, z_hash) >> 28];
}

// Perlin's quintic: first and second derivatives vanish at the lattice, so slopes have no creases.
float fade(float t) {
  return t * t * t * (t * (t * 6.0F - 15.0F) + 10.0F);
}

float lerp(float a, float b, float t) {
  return a + t * (b - a);
}

// Neighbouring samples along one axis that fall into the same lattice cell.
struct CellRun {
  std::size_t begin;
  std::size_t end;
  std::uint32_t hash;       // of the cell's lower corner
  std::uint32_t next_hash;  // of its upper corner
};

// Where the samples of one axis lie in the lattice of one octave.
struct AxisLattice {
  std::vector<CellRun> runs;
  std::vector<float> t;      // 0 to 1 within the cell
  std::vector<float> faded;  // fade(t)

  void locate(const Fbm& fbm, int octave, std::uint64_t octave_seed, Axis axis,
              std::span<const std::int64_t> coordinates) {
    runs.clear();
    t.resize(coordinates.size());
    faded.resize(coordinates.size());
    const std::uint64_t draw = derived_seed(octave_seed, static_cast<std::uint64_t>(axis)) >> 32;
    const auto offset = static_cast<std::int64_t>((draw * static_cast<std::uint64_t>(fbm.period)) >> 32);
    const float reciprocal = 1.0F / static_cast<float>(fbm.period);
    std::int64_t cell = 0;
    std::int64_t inside = 0;
    std::int64_t previous = 0;
    for (std::size_t i = 0; i < coordinates.size(); ++i) {
      const std::int64_t position = (coordinates[i] * (std::int64_t{1} << octave)) + offset;
      const bool first = i == 0;
      inside = first ? 0 : inside + (position - previous);
      if (first || inside >= 2 * fbm.period) {
        const std::int64_t old_cell = cell;
        cell = floor_div(position, fbm.period);
        inside = floor_mod(position, fbm.period);
        if (first || cell != old_cell) open_run(i, octave_seed, axis, cell);
      } else if (inside >= fbm.period) {  // stepping is cheaper than dividing
        inside -= fbm.period;
        ++cell;
        open_run(i, octave_seed, axis, cell);
      }
      previous = position;
      t[i] = static_cast<float>(inside) * reciprocal;
      faded[i] = fade(t[i]);
    }
    if (!runs.empty()) runs.back().end = coordinates.size();
  }

 private:
  void open_run(std::size_t begin, std::uint64_t octave_seed, Axis axis, std::int64_t cell) {
    if (!runs.empty()) runs.back().end = begin;
    runs.push_back(
        {begin, begin, axis_hash(octave_seed, axis, cell), axis_hash(octave_seed, axis, cell + 1)});
  }
};

// One row inside one cell. For fixed z the noise between two corners is a line in x on either side, so
// the interpolation along z is done once a cell: near(u) = a0 u + b0 around the lower corner, and
// far(u) = a1 (u - 1) + b1 around the upper one.
void add_row(const CellRun& run, const AxisLattice& along_x, std::uint32_t z_hash, std::uint32_t z_next_hash,
             float v, float faded_v, float weight, float* out) {
  const Gradient g00 = gradient_at(run.hash, z_hash);
  const Gradient g01 = gradient_at(run.hash, z_next_hash);
  const Gradient g10 = gradient_at(run.next_hash, z_hash);
  const Gradient g11 = gradient_at(run.next_hash, z_next_hash);
  const float a0 = lerp(g00.x, g01.x, faded_v);
  const float b0 = lerp(g00.z * v, g01.z * (v - 1.0F), faded_v);
  const float a1 = lerp(g10.x, g11.x, faded_v);
  const float b1 = lerp(g10.z * v, g11.z * (v - 1.0F), faded_v);
  const float* u = along_x.t.data();
  const float* faded_u = along_x.faded.data();
  for (std::size_t i = run.begin; i < run.end; ++i) {
    const float near = a0 * u[i] + b0;
    const float far = a1 * (u[i] - 1.0F) + b1;
    out[i] += weight * lerp(near, far, faded_u[i]);
  }
}

}  // namespace

void sample_fbm(const Fbm& fbm, std::span<const std::int64_t> xs, std::span<const std::int64_t> zs,
                std::span<float> out) {
  std::fill(out.begin(), out.end(), 0.0F);
  const double all_weights = 2.0 - 2.0 / static_cast<double>(std::int64_t{1} << fbm.octaves);
  AxisLattice along_x;
  AxisLattice along_z;
  for (int k = 0; k < fbm.octaves && fbm.has_octave(k); ++k) {
    const std::uint64_t octave_seed = derived_seed(fbm.seed, static_cast<std::uint64_t>(k));
    const auto weight = static_cast<float>(1.0 / (static_cast<double>(std::int64_t{1} << k) * all_weights));
    along_x.locate(fbm, k, octave_seed, Axis::x, xs);
    along_z.locate(fbm, k, octave_seed, Axis::z, zs);
    for (const CellRun& rows : along_z.runs) {
      for (std::size_t j = rows.begin; j < rows.end; ++j) {
        for (const CellRun& run : along_x.runs) {
          add_row(run, along_x, rows.hash, rows.next_hash, along_z.t[j], along_z.faded[j], weight,
                  out.data() + j * xs.size());
        }
      }
    }
  }
}

}  // namespace talus::terrain
