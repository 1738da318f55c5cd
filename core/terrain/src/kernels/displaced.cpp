#include "displaced.h"

#include <cmath>

#include <talus/terrain/lattice_hash.h>
#include <talus/vectors/tables.h>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/displaced.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "kernels/gradients-inl.h"
#include "kernels/interpolate-inl.h"

HWY_BEFORE_NAMESPACE();
namespace talus::terrain::HWY_NAMESPACE {
namespace {

#if HWY_HAVE_FLOAT64
using Doubles = hn::ScalableTag<double>;
using Keys = hn::RebindToUnsigned<Doubles>;

// mix64 of lattice_hash.h.
HWY_INLINE hn::Vec<Keys> mixed(hn::Vec<Keys> key) {
  const Keys keys;
  key = hn::Mul(hn::Xor(key, hn::ShiftRight<30>(key)), hn::Set(keys, 0xBF58476D1CE4E5B9U));
  key = hn::Mul(hn::Xor(key, hn::ShiftRight<27>(key)), hn::Set(keys, 0x94D049BB133111EBU));
  return hn::Xor(key, hn::ShiftRight<31>(key));
}
#endif

// Rounds to the nearest integer, ties to even: the sum is so large that it has no fraction.
void round_displacements(const float* noise, float reach_fx, std::size_t width, float* displacements) {
  const Floats f;
  const auto no_fraction = hn::Set(f, 12582912.0F);  // 1.5 * 2^23
  for (std::size_t i = 0; i < width; i += hn::Lanes(f)) {
    const auto far = hn::Mul(hn::LoadU(f, noise + i), hn::Set(f, reach_fx));
    hn::StoreU(hn::Sub(hn::Add(far, no_fraction), no_fraction), f, displacements + i);
  }
}

// Positions of the columns along one axis of an octave. `inside` and `key` are undisplaced ones: of each
// column, or one for all.
#if HWY_HAVE_FLOAT64
template <bool kEach, class Tag>
HWY_INLINE hn::Vec<Tag> undisplaced(Tag tag, const hn::TFromD<Tag>* values, std::size_t i) {
  if constexpr (kEach) {
    return hn::LoadU(tag, values + i);
  } else {
    return hn::Set(tag, *values);
  }
}

template <bool kEach>
void locate(const double* inside, const std::uint64_t* key, double frequency, double period_fx,
            const float* displacements, std::size_t width, float* t, std::uint32_t* low_hash,
            std::uint32_t* high_hash) {
  const Doubles d;
  const Keys keys;
  const hn::Rebind<float, Doubles> f;
  const hn::Rebind<std::uint32_t, Doubles> w;
  // A double of this size holds an integer in its low bits.
  const auto no_fraction = hn::Set(d, 6755399441055744.0);  // 1.5 * 2^52
  const auto period = hn::Set(d, period_fx);
  const auto reciprocal = hn::Set(f, 1.0F / static_cast<float>(period_fx));
  const auto step = hn::Set(keys, kCellStep);
  auto known = hn::Zero(keys);
  auto low = hn::Zero(w);
  auto high = hn::Zero(w);
  for (std::size_t i = 0; i < width; i += hn::Lanes(d)) {
    // All numbers are integers below 2^39, so nothing here rounds, and no quotient rounds up to an integer.
    const auto displaced =
        hn::Add(undisplaced<kEach>(d, inside, i),
                hn::Mul(hn::PromoteTo(d, hn::LoadU(f, displacements + i)), hn::Set(d, frequency)));
    const auto cells = hn::Floor(hn::Div(displaced, period));
    const auto rest = hn::Sub(displaced, hn::Mul(cells, period));
    hn::StoreU(hn::Mul(hn::DemoteTo(f, rest), reciprocal), f, t + i);
    const auto count =
        hn::Sub(hn::BitCast(keys, hn::Add(cells, no_fraction)), hn::BitCast(keys, no_fraction));
    const auto here = hn::Add(undisplaced<kEach>(keys, key, i), hn::Mul(count, step));
    // Neighbouring columns mostly share their cells, and hashing takes most of the time.
    if (i == 0 || !hn::AllTrue(keys, hn::Eq(here, known))) {
      known = here;
      low = hn::TruncateTo(w, mixed(here));
      high = hn::TruncateTo(w, mixed(hn::Add(here, step)));
    }
    hn::StoreU(low, w, low_hash + i);
    hn::StoreU(high, w, high_hash + i);
  }
}
#else  // column by column, if the vectors have no doubles
template <bool kEach>
void locate(const double* inside, const std::uint64_t* key, double frequency, double period_fx,
            const float* displacements, std::size_t width, float* t, std::uint32_t* low_hash,
            std::uint32_t* high_hash) {
  const float reciprocal = 1.0F / static_cast<float>(period_fx);
  std::uint64_t known = 0;
  std::uint32_t low = 0;
  std::uint32_t high = 0;
  for (std::size_t i = 0; i < width; ++i) {
    const double displaced = inside[kEach ? i : 0] + double{displacements[i]} * frequency;
    const double cells = std::floor(displaced / period_fx);
    t[i] = static_cast<float>(displaced - cells * period_fx) * reciprocal;
    const auto count = static_cast<std::uint64_t>(static_cast<std::int64_t>(cells));
    const std::uint64_t here = key[kEach ? i : 0] + count * kCellStep;
    if (i == 0 || here != known) {
      known = here;
      low = static_cast<std::uint32_t>(mix64(here));
      high = static_cast<std::uint32_t>(mix64(here + kCellStep));
    }
    low_hash[i] = low;
    high_hash[i] = high;
  }
}
#endif

void add_octave(const DisplacedScratch& at, float weight, std::size_t width, float* out) {
  const Floats f;
  const Words w;
  const auto one = hn::Set(f, 1.0F);
  const auto turned = [](auto hash)
                          HWY_ATTR { return hn::Or(hn::ShiftLeft<16>(hash), hn::ShiftRight<16>(hash)); };
  const auto toward = [](const Gradient& corner, auto dx, auto dz)
                          HWY_ATTR { return hn::Add(hn::Mul(corner.x, dx), hn::Mul(corner.z, dz)); };
  struct Sides {
    hn::Vec<Words> west;
    hn::Vec<Words> east;
    hn::Vec<Words> north;
    hn::Vec<Words> south;
  };
  Sides known{};
  Gradient north_west{};
  Gradient north_east{};
  Gradient south_west{};
  Gradient south_east{};
  for (std::size_t i = 0; i < width; i += hn::Lanes(f)) {
    const auto u = hn::LoadU(f, at.u.data() + i);
    const auto v = hn::LoadU(f, at.v.data() + i);
    const Sides sides{hn::LoadU(w, at.west_hash.data() + i), hn::LoadU(w, at.east_hash.data() + i),
                      hn::LoadU(w, at.north_hash.data() + i), hn::LoadU(w, at.south_hash.data() + i)};
    const auto moved = hn::Or(hn::Or(hn::Xor(sides.west, known.west), hn::Xor(sides.east, known.east)),
                              hn::Or(hn::Xor(sides.north, known.north), hn::Xor(sides.south, known.south)));
    if (i == 0 || !hn::AllTrue(w, hn::Eq(moved, hn::Zero(w)))) {
      known = sides;
      north_west = gradient_at(sides.west, turned(sides.north));
      north_east = gradient_at(sides.east, turned(sides.north));
      south_west = gradient_at(sides.west, turned(sides.south));
      south_east = gradient_at(sides.east, turned(sides.south));
    }
    const auto back_u = hn::Sub(u, one);
    const auto back_v = hn::Sub(v, one);
    const auto faded_u = faded(u);
    const auto on_north = lerp(toward(north_west, u, v), toward(north_east, back_u, v), faded_u);
    const auto on_south = lerp(toward(south_west, u, back_v), toward(south_east, back_u, back_v), faded_u);
    const auto noise = hn::Mul(hn::Set(f, weight), lerp(on_north, on_south, faded(v)));
    hn::StoreU(hn::Add(hn::LoadU(f, out + i), noise), f, out + i);
  }
}

void sum(const DisplacedOctave* octaves, std::size_t count, double period_fx, const float* east,
         const float* south, float reach_fx, std::size_t width, DisplacedScratch& scratch, float* out) {
  const Floats f;
  round_displacements(east, reach_fx, width, scratch.east.data());
  round_displacements(south, reach_fx, width, scratch.south.data());
  for (std::size_t i = 0; i < width; i += hn::Lanes(f)) hn::StoreU(hn::Zero(f), f, out + i);
  for (const DisplacedOctave* octave = octaves; octave != octaves + count; ++octave) {
    locate<true>(octave->x_inside.data(), octave->x_key.data(), octave->frequency, period_fx,
                 scratch.east.data(), width, scratch.u.data(), scratch.west_hash.data(),
                 scratch.east_hash.data());
    locate<false>(&octave->z_inside, &octave->z_key, octave->frequency, period_fx, scratch.south.data(),
                  width, scratch.v.data(), scratch.north_hash.data(), scratch.south_hash.data());
    add_octave(scratch, octave->weight, width, out);
  }
}

}  // namespace

constexpr DisplacedKernels kDisplaced{sum};

}  // namespace talus::terrain::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace talus::terrain {

const DisplacedKernels& displaced_kernels(InstructionSet set) {
  static constexpr const DisplacedKernels* kTables[] = TALUS_TABLES(kDisplaced);
  return *kTables[static_cast<std::size_t>(set)];
}

}  // namespace talus::terrain
#endif
