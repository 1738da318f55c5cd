#include "rotated.h"

#include <algorithm>

#include <talus/vectors/tables.h>

#include "noise/rotated_lattice.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/rotated.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "kernels/hash-inl.h"
#include "kernels/interpolate-inl.h"

HWY_BEFORE_NAMESPACE();
namespace talus::terrain::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Floats = hn::ScalableTag<float>;
using Words = hn::RebindToUnsigned<Floats>;
using Integers = hn::RebindToSigned<Floats>;
using Positions = hn::ScalableTag<std::uint64_t>;

/// Positions of one vector of columns.
struct Place {
  hn::Vec<Words> cell;
  hn::Vec<Floats> inside;  // 0 to 1
};

struct Corner {
  hn::Vec<Floats> along_u;
  hn::Vec<Floats> along_v;
  hn::Vec<Floats> value;
};

HWY_INLINE hn::Vec<Floats> inside_of(hn::Vec<Words> low) {
  const Floats f;
  return hn::Mul(hn::ConvertTo(f, hn::BitCast(Integers{}, hn::ShiftRight<8>(low))),
                 hn::Set(f, 1.0F / 16777216.0F));
}

/// Positions of the columns from `i` on; `at(i)` gives one vector of 64-bit positions.
template <class At>
HWY_INLINE Place place_of(const At& at, std::size_t i) {
  const Words w;
#if HWY_TARGET == HWY_SCALAR
  const std::uint64_t position = hn::GetLane(at(i));
  return {hn::Set(w, static_cast<std::uint32_t>(position >> 32)),
          inside_of(hn::Set(w, static_cast<std::uint32_t>(position)))};
#else
  const auto first = hn::BitCast(w, at(i));
  const auto second = hn::BitCast(w, at(i + hn::Lanes(Positions{})));
  return {hn::ConcatOdd(w, second, first), inside_of(hn::ConcatEven(w, second, first))};
#endif
}

template <int kBits>
HWY_INLINE hn::Vec<Integers> odd_integer(hn::Vec<Words> bits) {
  const auto number = hn::ShiftRight<32 - kBits>(hn::BitCast(Integers{}, bits));
  return hn::Or(number, hn::Set(Integers{}, 1));
}
template <int kBits>
HWY_INLINE hn::Vec<Floats> odd_number(hn::Vec<Words> bits) {
  return hn::ConvertTo(Floats{}, odd_integer<kBits>(bits));
}

HWY_INLINE Corner corner_of(hn::Vec<Words> u_hash, hn::Vec<Words> turned_v_hash) {
  const Floats f;
  const auto hash = mixed(hn::Xor(u_hash, turned_v_hash));
  const auto unit = hn::Set(f, kGradientUnit);
  const auto value = hn::ConvertTo(
      f, hn::Add(odd_integer<5>(hn::ShiftLeft<22>(hash)), odd_integer<5>(hn::ShiftLeft<27>(hash))));
  return {hn::Mul(odd_number<11>(hash), unit), hn::Mul(odd_number<11>(hn::ShiftLeft<11>(hash)), unit),
          hn::Mul(value, hn::Set(f, kValueUnit))};
}

HWY_INLINE hn::Vec<Floats> toward(const Corner& corner, hn::Vec<Floats> du, hn::Vec<Floats> dv) {
  return hn::Add(hn::Add(hn::Mul(corner.along_u, du), hn::Mul(corner.along_v, dv)), corner.value);
}

/// The corners of the columns' cells.
struct Corners {
  Corner c00, c10, c01, c11;
};

HWY_INLINE Corners corners_of(const RotatedLattice& lattice, hn::Vec<Words> u_cell, hn::Vec<Words> v_cell) {
  const Words w;
  const auto step = hn::Set(w, kRotatedCellStep);
  const auto turned = [](auto hash)
                          HWY_ATTR { return hn::Or(hn::ShiftLeft<16>(hash), hn::ShiftRight<16>(hash)); };
  const auto u_key = hn::Add(hn::Mul(u_cell, step), hn::Set(w, lattice.u_salt));
  const auto v_key = hn::Add(hn::Mul(v_cell, step), hn::Set(w, lattice.v_salt));
  const auto u_0 = mixed(u_key);
  const auto u_1 = mixed(hn::Add(u_key, step));
  const auto v_0 = turned(mixed(v_key));
  const auto v_1 = turned(mixed(hn::Add(v_key, step)));
  return {corner_of(u_0, v_0), corner_of(u_1, v_0), corner_of(u_0, v_1), corner_of(u_1, v_1)};
}

/// `kFirst`: true for the first summand. It is still added to 0, which turns -0 into 0.
template <bool kFirst>
HWY_INLINE void add(Floats f, hn::Vec<Floats> more, float* sum) {
  const auto before = kFirst ? hn::Zero(f) : hn::LoadU(f, sum);
  hn::StoreU(hn::Add(before, more), f, sum);
}

/// Adds the octave's noise at positions `u` and `v` in the columns' cells.
template <bool kSlopes, bool kFirst>
HWY_INLINE void add_noise(const RotatedOctave& octave, const Corners& c, hn::Vec<Floats> u, hn::Vec<Floats> v,
                          const RotatedSums& out, std::size_t i) {
  const Floats f;
  const auto one = hn::Set(f, 1.0F);
  const auto back_u = hn::Sub(u, one);
  const auto back_v = hn::Sub(v, one);
  const auto a00 = toward(c.c00, u, v);
  const auto a10 = toward(c.c10, back_u, v);
  const auto a01 = toward(c.c01, u, back_v);
  const auto a11 = toward(c.c11, back_u, back_v);
  const auto faded_u = faded(u);
  const auto faded_v = faded(v);
  const auto on_0 = lerp(a00, a10, faded_u);
  const auto on_1 = lerp(a01, a11, faded_u);
  add<kFirst>(f, hn::Mul(hn::Set(f, octave.weight), lerp(on_0, on_1, faded_v)), out.value + i);
  if constexpr (kSlopes) {
    const auto u_share = hn::Set(f, octave.weight * octave.lattice->u_a_column());
    const auto v_share = hn::Set(f, octave.weight * octave.lattice->v_a_column());
    const auto rise_u = faded_slope(u);
    const auto along_0 =
        hn::Add(lerp(c.c00.along_u, c.c10.along_u, faded_u), hn::Mul(rise_u, hn::Sub(a10, a00)));
    const auto along_1 =
        hn::Add(lerp(c.c01.along_u, c.c11.along_u, faded_u), hn::Mul(rise_u, hn::Sub(a11, a01)));
    const auto across = lerp(lerp(c.c00.along_v, c.c10.along_v, faded_u),
                             lerp(c.c01.along_v, c.c11.along_v, faded_u), faded_v);
    const auto along_u = lerp(along_0, along_1, faded_v);
    const auto along_v = hn::Add(across, hn::Mul(faded_slope(v), hn::Sub(on_1, on_0)));
    add<kFirst>(f, hn::Sub(hn::Mul(along_u, u_share), hn::Mul(along_v, v_share)), out.east + i);
    add<kFirst>(f, hn::Add(hn::Mul(along_u, v_share), hn::Mul(along_v, u_share)), out.south + i);
  }
}

/// Adds one octave; u_at and v_at give the columns' positions as for place_of().
template <bool kSlopes, bool kFirst, class UAt, class VAt>
HWY_INLINE void add_octave(const RotatedOctave& octave, const UAt& u_at, const VAt& v_at, std::size_t width,
                           const RotatedSums& out) {
  const Floats f;
  const Words w;
  auto known_u = hn::Zero(w);
  auto known_v = hn::Zero(w);
  Corners corners{};
  for (std::size_t i = 0; i < width; i += hn::Lanes(f)) {
    const Place u = place_of(u_at, i);
    const Place v = place_of(v_at, i);
    // Neighbouring columns mostly lie in the same cells, and hashing takes most of the time.
    const auto moved = hn::Or(hn::Xor(u.cell, known_u), hn::Xor(v.cell, known_v));
    if (i == 0 || !hn::AllTrue(w, hn::Eq(moved, hn::Zero(w)))) {
      known_u = u.cell;
      known_v = v.cell;
      corners = corners_of(*octave.lattice, u.cell, v.cell);
    }
    add_noise<kSlopes, kFirst>(octave, corners, u.inside, v.inside, out, i);
  }
}

constexpr std::size_t kBlock = 256;  // columns whose runs are found at once
// Maximum number of runs if columns are at most a quarter of a cell apart along u and v.
constexpr std::size_t kMaxRuns = kBlock / 2 + kMaxLanes;
constexpr std::uint64_t kMaxStepInRuns = std::uint64_t{1} << 30;

std::uint32_t cell_of(std::uint64_t position) {
  return static_cast<std::uint32_t>(position >> 32);
}

/// The cells crossed by evenly spaced columns from west to east, with u rising and v falling. A run's index
/// is the number of lattice lines crossed: if a column crosses two lines, the cell between holds no column.
struct Runs {
  std::uint32_t u[kMaxRuns];
  std::uint32_t v[kMaxRuns];
  float corners[12][kMaxRuns + kMaxLanes];

  /// REQUIRES that columns are at most kMaxStepInRuns apart, and crossed < kMaxRuns.
  void find(const RotatedOctave& octave, std::uint64_t first_u, std::uint64_t first_v, std::size_t crossed) {
    const auto du = static_cast<std::int64_t>(octave.step_u);
    const auto dv = static_cast<std::int64_t>(octave.step_v);
    const auto to_next_u = (std::int64_t{1} << 32) - static_cast<std::uint32_t>(first_u);
    const auto to_next_v = static_cast<std::int64_t>(static_cast<std::uint32_t>(first_v));
    // Selects the next line: of u if negative. A column on a line of u is past it, on a line of v it is not.
    std::int64_t order = to_next_u * dv - to_next_v * du - 1;
    std::uint32_t u_cell = cell_of(first_u);
    std::uint32_t v_cell = cell_of(first_v);
    for (std::size_t k = 0;; ++k) {
      u[k] = u_cell;
      v[k] = v_cell;
      if (k == crossed) return;
      const std::int64_t crosses_u = order >> 63;  // all bits or 0
      u_cell -= static_cast<std::uint32_t>(crosses_u);
      v_cell -= static_cast<std::uint32_t>(crosses_u + 1);
      order += ((dv & crosses_u) - (du & ~crosses_u)) * (std::int64_t{1} << 32);
    }
  }

  void hash(const RotatedLattice& lattice, std::size_t count) {
    const Floats f;
    const Words w;
    for (std::size_t k = 0; k < count; k += hn::Lanes(f)) {
      const Corners c = corners_of(lattice, hn::LoadU(w, u + k), hn::LoadU(w, v + k));
      std::size_t row = 0;
      for (const Corner* corner : {&c.c00, &c.c10, &c.c01, &c.c11}) {
        hn::StoreU(corner->along_u, f, corners[row++] + k);
        hn::StoreU(corner->along_v, f, corners[row++] + k);
        hn::StoreU(corner->value, f, corners[row++] + k);
      }
    }
  }

  HWY_INLINE Corners at(std::size_t first, hn::Vec<Words> crossed) const {
    const Floats f;
    const auto lanes = hn::IndicesFromVec(f, hn::BitCast(Integers{}, crossed));
    const auto look_up = [&](std::size_t row) HWY_ATTR {
      return hn::TableLookupLanes(hn::LoadU(f, corners[row] + first), lanes);
    };
    const auto corner = [&](std::size_t row) HWY_ATTR {
      return Corner{look_up(row), look_up(row + 1), look_up(row + 2)};
    };
    return {corner(0), corner(3), corner(6), corner(9)};
  }
};

/// add_octave() for evenly spaced columns: hashes each cell once per row.
template <bool kSlopes, bool kFirst>
void add_in_runs(const RotatedOctave& octave, std::size_t width, const RotatedSums& out) {
  const Floats f;
  const Words w;
  const std::size_t lanes = hn::Lanes(f);
  const LaneSteps& steps = *octave.lane_steps;
  // Copied to registers, because stores might alias them.
  const std::uint64_t vector_u = lanes * octave.step_u;
  const std::uint64_t vector_v = lanes * octave.step_v;
  const auto u_low = hn::LoadU(w, steps.u_low.data());
  const auto v_low = hn::LoadU(w, steps.v_low.data());
  const auto cells = hn::Add(hn::LoadU(w, steps.u_cells.data()), hn::LoadU(w, steps.v_cells.data()));
  std::uint64_t u = octave.u[0] + octave.row_u;
  std::uint64_t v = octave.v[0] + octave.row_v;
  Runs runs;
  for (std::size_t block = 0; block < width; block += kBlock) {
    const std::size_t end = std::min(width, block + kBlock);
    const std::uint64_t steps_on = (end - block - 1 + lanes) / lanes * lanes - 1;
    const std::uint32_t first_u = cell_of(u);
    const std::uint32_t first_v = cell_of(v);
    const std::size_t crossed =
        (cell_of(u + steps_on * octave.step_u) - first_u) + (first_v - cell_of(v - steps_on * octave.step_v));
    runs.find(octave, u, v, crossed);
    runs.hash(*octave.lattice, crossed + 1);
    for (std::size_t i = block; i < end; i += lanes) {
      const auto first_u_low = hn::Set(w, static_cast<std::uint32_t>(u));
      const auto first_v_low = hn::Set(w, static_cast<std::uint32_t>(v));
      const auto here_u = hn::Add(first_u_low, u_low);
      const auto here_v = hn::Sub(first_v_low, v_low);
      auto crossed_here = hn::Sub(cells, hn::VecFromMask(w, hn::Lt(here_u, u_low)));
      crossed_here = hn::Sub(crossed_here, hn::VecFromMask(w, hn::Lt(first_v_low, v_low)));
      const std::size_t first = (cell_of(u) - first_u) + (first_v - cell_of(v));
      add_noise<kSlopes, kFirst>(octave, runs.at(first, crossed_here), inside_of(here_u), inside_of(here_v),
                                 out, i);
      u += vector_u;
      v -= vector_v;
    }
  }
}

template <bool kSlopes, bool kFirst>
void add_undisplaced(const RotatedOctave& octave, std::size_t width, const RotatedSums& out) {
  const bool even = octave.lane_steps != nullptr;
  if (even && octave.step_u <= kMaxStepInRuns && octave.step_v <= kMaxStepInRuns) {
    return add_in_runs<kSlopes, kFirst>(octave, width, out);
  }
  const Positions p;
  add_octave<kSlopes, kFirst>(
      octave,
      [&](std::size_t i) HWY_ATTR { return hn::Add(hn::LoadU(p, octave.u + i), hn::Set(p, octave.row_u)); },
      [&](std::size_t i) HWY_ATTR { return hn::Add(hn::LoadU(p, octave.v + i), hn::Set(p, octave.row_v)); },
      width, out);
}

template <bool kSlopes, bool kFirst>
void add_displaced(const RotatedOctave& octave, const Displacements& displaced, std::size_t width,
                   const RotatedSums& out) {
  const Positions p;
  using Signed = hn::RebindToSigned<Positions>;
  const Signed s;
  const hn::Rebind<std::int32_t, Positions> half;
  const auto du = hn::Set(p, octave.lattice->du);
  const auto dv = hn::Set(p, octave.lattice->dv);
  // Both factors have 31 bits and a sign: P >= 2^(k+1) bounds du and dv.
  const auto product = [&](auto step, const std::int32_t* distances, std::size_t i) HWY_ATTR {
    const auto far = hn::PromoteTo(s, hn::LoadU(half, distances + i));
#if HWY_TARGET == HWY_SCALAR || HWY_TARGET == HWY_WASM  // whose MulEven in Highway 1.0.3 drops the signs
    return hn::Mul(step, hn::BitCast(p, far));
#else
    return hn::BitCast(p, hn::MulEven(hn::BitCast(Integers{}, step), hn::BitCast(Integers{}, far)));
#endif
  };
  // From 2^-8 columns to columns, rounded down.
  const auto moved = [&](auto sum)
                         HWY_ATTR { return hn::BitCast(p, hn::ShiftRight<8>(hn::BitCast(s, sum))); };
  add_octave<kSlopes, kFirst>(
      octave,
      [&](std::size_t i) HWY_ATTR {
        const auto by = hn::Add(product(du, displaced.east, i), product(dv, displaced.south, i));
        return hn::Add(hn::Add(hn::LoadU(p, octave.u + i), hn::Set(p, octave.row_u)), moved(by));
      },
      [&](std::size_t i) HWY_ATTR {
        const auto by = hn::Sub(product(du, displaced.south, i), product(dv, displaced.east, i));
        return hn::Add(hn::Add(hn::LoadU(p, octave.v + i), hn::Set(p, octave.row_v)), moved(by));
      },
      width, out);
}

template <bool kSlopes, bool kFirst>
void add_one(const RotatedOctave& octave, const Displacements& displaced, std::size_t width,
             const RotatedSums& out) {
  if (displaced.east == nullptr) {
    add_undisplaced<kSlopes, kFirst>(octave, width, out);
  } else {
    add_displaced<kSlopes, kFirst>(octave, displaced, width, out);
  }
}

template <bool kSlopes>
void sum_of(const RotatedOctave* octaves, std::size_t count, const Displacements& displaced,
            std::size_t width, const RotatedSums& out) {
  add_one<kSlopes, true>(octaves[0], displaced, width, out);
  for (std::size_t k = 1; k < count; ++k) add_one<kSlopes, false>(octaves[k], displaced, width, out);
}

void sum(const RotatedOctave* octaves, std::size_t count, const Displacements& displaced, std::size_t width,
         const RotatedSums& out) {
  if (out.east == nullptr) {
    sum_of<false>(octaves, count, displaced, width, out);
  } else {
    sum_of<true>(octaves, count, displaced, width, out);
  }
}

}  // namespace

constexpr RotatedKernels kRotated{sum};

}  // namespace talus::terrain::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace talus::terrain {

const RotatedKernels& rotated_kernels(InstructionSet set) {
  static constexpr const RotatedKernels* kTables[] = TALUS_TABLES(kRotated);
  return *kTables[static_cast<std::size_t>(set)];
}

}  // namespace talus::terrain
#endif
