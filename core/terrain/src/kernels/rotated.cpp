#include "rotated.h"

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

/// Of as many columns as Floats has lanes.
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

/// Where the columns from `i` on lie; `at(i)` gives as many positions as there are lanes of 64 bits.
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
HWY_INLINE hn::Vec<Floats> odd_number(hn::Vec<Words> bits) {
  const auto number = hn::ShiftRight<32 - kBits>(hn::BitCast(Integers{}, bits));
  return hn::ConvertTo(Floats{}, hn::Or(number, hn::Set(Integers{}, 1)));
}

HWY_INLINE Corner corner_of(hn::Vec<Words> u_hash, hn::Vec<Words> turned_v_hash) {
  const Floats f;
  const auto hash = mixed(hn::Xor(u_hash, turned_v_hash));
  const auto unit = hn::Set(f, kGradientUnit);
  const auto value = hn::Add(odd_number<5>(hn::ShiftLeft<22>(hash)), odd_number<5>(hn::ShiftLeft<27>(hash)));
  return {hn::Mul(odd_number<11>(hash), unit), hn::Mul(odd_number<11>(hn::ShiftLeft<11>(hash)), unit),
          hn::Mul(value, hn::Set(f, kValueUnit))};
}

HWY_INLINE hn::Vec<Floats> toward(const Corner& corner, hn::Vec<Floats> du, hn::Vec<Floats> dv) {
  return hn::Add(hn::Add(hn::Mul(corner.along_u, du), hn::Mul(corner.along_v, dv)), corner.value);
}

HWY_INLINE void add(Floats f, hn::Vec<Floats> more, float* sum) {
  hn::StoreU(hn::Add(hn::LoadU(f, sum), more), f, sum);
}

/// Adds one octave; u_at and v_at give the columns' positions, as place_of() wants them.
template <bool kSlopes, class UAt, class VAt>
HWY_INLINE void add_octave(const RotatedOctave& octave, const UAt& u_at, const VAt& v_at, std::size_t width,
                           const RotatedSums& out) {
  const Floats f;
  const Words w;
  const auto one = hn::Set(f, 1.0F);
  const auto step = hn::Set(w, kRotatedCellStep);
  const auto u_share = hn::Set(f, octave.weight * octave.lattice->u_a_column());
  const auto v_share = hn::Set(f, octave.weight * octave.lattice->v_a_column());
  const auto turned = [](auto hash)
                          HWY_ATTR { return hn::Or(hn::ShiftLeft<16>(hash), hn::ShiftRight<16>(hash)); };
  auto known_u = hn::Zero(w);
  auto known_v = hn::Zero(w);
  Corner c00{};
  Corner c10{};
  Corner c01{};
  Corner c11{};
  for (std::size_t i = 0; i < width; i += hn::Lanes(f)) {
    const Place u = place_of(u_at, i);
    const Place v = place_of(v_at, i);
    // Neighbouring columns mostly lie in the same cells, and hashing takes most of the time.
    const auto moved = hn::Or(hn::Xor(u.cell, known_u), hn::Xor(v.cell, known_v));
    if (i == 0 || !hn::AllTrue(w, hn::Eq(moved, hn::Zero(w)))) {
      known_u = u.cell;
      known_v = v.cell;
      const auto u_key = hn::Add(hn::Mul(u.cell, step), hn::Set(w, octave.lattice->u_salt));
      const auto v_key = hn::Add(hn::Mul(v.cell, step), hn::Set(w, octave.lattice->v_salt));
      const auto u_0 = mixed(u_key);
      const auto u_1 = mixed(hn::Add(u_key, step));
      const auto v_0 = turned(mixed(v_key));
      const auto v_1 = turned(mixed(hn::Add(v_key, step)));
      c00 = corner_of(u_0, v_0);
      c10 = corner_of(u_1, v_0);
      c01 = corner_of(u_0, v_1);
      c11 = corner_of(u_1, v_1);
    }
    const auto back_u = hn::Sub(u.inside, one);
    const auto back_v = hn::Sub(v.inside, one);
    const auto a00 = toward(c00, u.inside, v.inside);
    const auto a10 = toward(c10, back_u, v.inside);
    const auto a01 = toward(c01, u.inside, back_v);
    const auto a11 = toward(c11, back_u, back_v);
    const auto faded_u = faded(u.inside);
    const auto faded_v = faded(v.inside);
    const auto on_0 = lerp(a00, a10, faded_u);
    const auto on_1 = lerp(a01, a11, faded_u);
    add(f, hn::Mul(hn::Set(f, octave.weight), lerp(on_0, on_1, faded_v)), out.value + i);
    if constexpr (kSlopes) {
      const auto rise_u = faded_slope(u.inside);
      const auto along_0 =
          hn::Add(lerp(c00.along_u, c10.along_u, faded_u), hn::Mul(rise_u, hn::Sub(a10, a00)));
      const auto along_1 =
          hn::Add(lerp(c01.along_u, c11.along_u, faded_u), hn::Mul(rise_u, hn::Sub(a11, a01)));
      const auto across =
          lerp(lerp(c00.along_v, c10.along_v, faded_u), lerp(c01.along_v, c11.along_v, faded_u), faded_v);
      const auto along_u = lerp(along_0, along_1, faded_v);
      const auto along_v = hn::Add(across, hn::Mul(faded_slope(v.inside), hn::Sub(on_1, on_0)));
      add(f, hn::Sub(hn::Mul(along_u, u_share), hn::Mul(along_v, v_share)), out.east + i);
      add(f, hn::Add(hn::Mul(along_u, v_share), hn::Mul(along_v, u_share)), out.south + i);
    }
  }
}

template <bool kSlopes>
void add_undisplaced(const RotatedOctave& octave, std::size_t width, const RotatedSums& out) {
  const Positions p;
  add_octave<kSlopes>(
      octave,
      [&](std::size_t i) HWY_ATTR { return hn::Add(hn::LoadU(p, octave.u + i), hn::Set(p, octave.row_u)); },
      [&](std::size_t i) HWY_ATTR { return hn::Add(hn::LoadU(p, octave.v + i), hn::Set(p, octave.row_v)); },
      width, out);
}

template <bool kSlopes>
void add_displaced(const RotatedOctave& octave, const Displacements& displaced, std::size_t width,
                   const RotatedSums& out) {
  const Positions p;
  using Signed = hn::RebindToSigned<Positions>;
  const Signed s;
  const hn::Rebind<std::int32_t, Positions> half;
  const auto du = hn::Set(p, octave.lattice->du);
  const auto dv = hn::Set(p, octave.lattice->dv);
  const auto far = [&](const std::int32_t* distances, std::size_t i)
                       HWY_ATTR { return hn::BitCast(p, hn::PromoteTo(s, hn::LoadU(half, distances + i))); };
  // To columns from 2^-8 of them, rounded down.
  const auto moved = [&](auto sum)
                         HWY_ATTR { return hn::BitCast(p, hn::ShiftRight<8>(hn::BitCast(s, sum))); };
  add_octave<kSlopes>(
      octave,
      [&](std::size_t i) HWY_ATTR {
        const auto by = hn::Add(hn::Mul(du, far(displaced.east, i)), hn::Mul(dv, far(displaced.south, i)));
        return hn::Add(hn::Add(hn::LoadU(p, octave.u + i), hn::Set(p, octave.row_u)), moved(by));
      },
      [&](std::size_t i) HWY_ATTR {
        const auto by = hn::Sub(hn::Mul(du, far(displaced.south, i)), hn::Mul(dv, far(displaced.east, i)));
        return hn::Add(hn::Add(hn::LoadU(p, octave.v + i), hn::Set(p, octave.row_v)), moved(by));
      },
      width, out);
}

template <bool kSlopes>
void sum_of(const RotatedOctave* octaves, std::size_t count, const Displacements& displaced,
            std::size_t width, const RotatedSums& out) {
  const Floats f;
  for (std::size_t i = 0; i < width; i += hn::Lanes(f)) {
    hn::StoreU(hn::Zero(f), f, out.value + i);
    if constexpr (kSlopes) {
      hn::StoreU(hn::Zero(f), f, out.east + i);
      hn::StoreU(hn::Zero(f), f, out.south + i);
    }
  }
  for (const RotatedOctave* octave = octaves; octave != octaves + count; ++octave) {
    if (displaced.east == nullptr) {
      add_undisplaced<kSlopes>(*octave, width, out);
    } else {
      add_displaced<kSlopes>(*octave, displaced, width, out);
    }
  }
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
