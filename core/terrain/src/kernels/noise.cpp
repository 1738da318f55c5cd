#include "noise.h"

#include <talus/vectors/tables.h>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/noise.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <talus/vectors/vectors-inl.h>

#include "kernels/gradients-inl.h"
#include "kernels/octaves-inl.h"

HWY_BEFORE_NAMESPACE();
namespace talus::terrain::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using talus::HWY_NAMESPACE::over_row;
using talus::HWY_NAMESPACE::round_to_even;

using Ints = hn::RebindToSigned<Floats>;

void place_columns(std::int32_t inside, std::int32_t apart, std::size_t count, float reciprocal, float* t) {
  const Floats f;
  const Ints ints;
  for (std::size_t i = 0; i < count; i += hn::Lanes(f)) {
    const auto from_first = hn::Mul(hn::Iota(ints, static_cast<std::int32_t>(i)), hn::Set(ints, apart));
    const auto parts = hn::ConvertTo(f, hn::Add(hn::Set(ints, inside), from_first));
    hn::StoreU(hn::Mul(parts, hn::Set(f, reciprocal)), f, t + i);
  }
}

// The same as fade() of lattice_place.h.
void fade_columns(const float* t, std::size_t width, float* faded) {
  const Floats f;
  for (std::size_t i = 0; i < width; i += hn::Lanes(f)) {
    const auto at = hn::LoadU(f, t + i);
    const auto high = hn::Sub(hn::Mul(at, hn::Set(f, 6.0F)), hn::Set(f, 15.0F));
    const auto curve = hn::Add(hn::Mul(at, high), hn::Set(f, 10.0F));
    hn::StoreU(hn::Mul(hn::Mul(hn::Mul(at, at), at), curve), f, faded + i);
  }
}

void draw_gradients(const std::uint32_t* hashes, std::size_t count, std::uint32_t z_hash, float* xs,
                    float* zs) {
  const Floats f;
  const Words w;
  for (std::size_t i = 0; i < count; i += hn::Lanes(f)) {
    const Gradient gradient = gradient_at(hn::LoadU(w, hashes + i), hn::Set(w, z_hash));
    hn::StoreU(gradient.x, f, xs + i);
    hn::StoreU(gradient.z, f, zs + i);
  }
}

void draw_line(const LatticeColumns& columns, std::uint32_t z_hash, float weight, float* gradients,
               LatticeLine& line) {
  const Floats f;
  const Ints ints;
  const std::size_t stride = padded(columns.runs);
  float* const west_x = gradients;
  float* const west_z = gradients + stride;
  float* const east_x = gradients + 2 * stride;
  float* const east_z = gradients + 3 * stride;
  draw_gradients(columns.west_hash.data(), columns.runs, z_hash, west_x, west_z);
  draw_gradients(columns.east_hash.data(), columns.runs, z_hash, east_x, east_z);
  const auto w = hn::Set(f, weight);
  const auto one = hn::Set(f, 1.0F);
  for (std::size_t i = 0; i < columns.width; i += hn::Lanes(f)) {
    // A vector of columns spans at most as many runs as it has lanes: one load, then a table lookup.
    const std::int32_t first = columns.run[i];
    const auto lanes =
        hn::IndicesFromVec(f, hn::Sub(hn::LoadU(ints, columns.run.data() + i), hn::Set(ints, first)));
    const auto spread = [&](const float* of_runs) {
      return hn::TableLookupLanes(hn::LoadU(f, of_runs + first), lanes);
    };
    const auto t = hn::LoadU(f, columns.t.data() + i);
    const auto faded = hn::LoadU(f, columns.faded.data() + i);
    const auto lerp = [&](auto a, auto b) { return hn::Add(a, hn::Mul(faded, hn::Sub(b, a))); };
    const auto value = lerp(hn::Mul(spread(west_x), t), hn::Mul(spread(east_x), hn::Sub(t, one)));
    const auto slope = lerp(spread(west_z), spread(east_z));
    hn::StoreU(hn::Mul(w, value), f, line.value.data() + i);
    hn::StoreU(hn::Mul(w, slope), f, line.slope.data() + i);
  }
}

void blend(const OctaveRow* octaves, std::size_t count, std::size_t first, std::size_t last, float* out) {
  const Floats f;
  const std::size_t lanes = hn::Lanes(f);
  std::size_t i = first;
  const auto store = [&](std::size_t v, auto sum) HWY_ATTR { hn::StoreU(sum, f, out + i + v * lanes); };
  for (; i + 3 * lanes < last; i += 4 * lanes) with_noise<4>(f, octaves, count, i, store);
  for (; i < last; i += lanes) with_noise<1>(f, octaves, count, i, store);
}

void shape(const float* noise, std::size_t width, float gain, int exponent, float highest_fx,
           std::int32_t* heights_fx) {
  over_row(Floats{}, width, [=](auto f, std::size_t i) HWY_ATTR {
    const auto raised = hn::Add(hn::Set(f, 0.5F), hn::Mul(hn::Set(f, gain), hn::LoadU(f, noise + i)));
    const auto level = hn::Min(hn::Max(raised, hn::Zero(f)), hn::Set(f, 1.0F));
    auto power = level;
    for (int e = 1; e < exponent; ++e) power = hn::Mul(power, level);
    const hn::RebindToSigned<decltype(f)> ints;
    hn::StoreU(round_to_even(f, hn::Mul(power, hn::Set(f, highest_fx))), ints, heights_fx + i);
  });
}

}  // namespace

constexpr NoiseKernels kNoise{place_columns, fade_columns, draw_line, blend, shape};

}  // namespace talus::terrain::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace talus::terrain {

const NoiseKernels& noise_kernels(InstructionSet set) {
  static constexpr const NoiseKernels* kTables[] = TALUS_TABLES(kNoise);
  return *kTables[static_cast<std::size_t>(set)];
}

}  // namespace talus::terrain
#endif
