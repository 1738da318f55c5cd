#include "layered.h"

#include <algorithm>
#include <array>
#include <cstdlib>

#include "header.h"
#include "kernels.h"
#include "layered_odds.h"
#include "rans.h"
#include "row_guess.h"

namespace talus::codec {
namespace {

// From kLastPlace on, the place itself follows, as one of kPlaces equally likely ones.
constexpr std::uint32_t kLastPlace = kFurther.size() - 2;
constexpr std::uint32_t kPlaces = 128;
constexpr std::uint32_t kPlaceShare = kOddsTotal / kPlaces;
static_assert(place_of(2 * kMostStep) < kPlaces && place_of(-2 * kMostStep) < kPlaces);

constexpr std::size_t kMostBytes = sizeof(DenseVoxels);  // more than that is better kept raw
constexpr std::size_t kMaterialsBytes = 256;             // at least what a list of materials takes
constexpr std::size_t kMostBytesOfColumn = 6;            // three symbols of up to two bytes

constexpr int change_at(std::uint32_t place) {
  const int size = static_cast<int>(place / 2) + 2;
  return place % 2 == 0 ? size : -size;
}

/// Which of kOdds each context has, and each its odds.
constexpr auto kOddsIndex = [] {
  std::array<std::uint8_t, kContexts> index{};
  for (std::size_t context = 0; context < kContexts; ++context) {
    const char digit = kOddsOfContext[context];
    const int value = digit <= '9' ? digit - '0' : digit <= 'Z' ? digit - 'A' + 10 : digit - 'a' + 36;
    index[context] = static_cast<std::uint8_t>(value);
  }
  return index;
}();

struct alignas(8) AlignedOdds : Odds {};  // found by a shift

constexpr auto kOddsByContext = [] {
  std::array<AlignedOdds, kContexts> odds{};
  for (std::size_t context = 0; context < kContexts; ++context) odds[context] = {kOdds[kOddsIndex[context]]};
  return odds;
}();

constexpr auto kShares = [] {
  std::array<std::array<Share, 4>, kOdds.size()> shares;
  for (std::size_t i = 0; i < kOdds.size(); ++i) {
    const Odds& odds = kOdds[i];
    shares[i] = {Share{0, odds.up}, Share{odds.up, odds.down}, Share{odds.down, odds.further},
                 Share{odds.further, kOddsTotal}};
  }
  return shares;
}();

constexpr auto kFurtherShares = [] {
  std::array<Share, kFurther.size() - 1> shares;
  for (std::size_t i = 0; i < shares.size(); ++i) shares[i] = {kFurther[i], kFurther[i + 1]};
  return shares;
}();

constexpr Share place_share(std::uint32_t place) {
  return {place * kPlaceShare, (place + 1) * kPlaceShare};
}

// ---- Writing ----

/// The rows of a plane are written from the last to the first, and so are their columns: everything that a
/// reader will know of a row is known here anyway.
class PlaneWriter {
 public:
  explicit PlaneWriter(RansWriter& coder) : coder_{coder} {}

  void write(const std::uint8_t* plane, const std::uint8_t* below) {
    RowGuess guess;
    for (std::size_t z = 0; z < kChunkSize; ++z) {
      kernels_.guess(RowsBefore::of(plane, below, z, steps_[z == 0 ? 0 : z - 1]), guess);
      kernels_.classify(plane + z * kChunkSize, guess, steps_[z], symbols_[z]);
    }
    for (std::size_t z = kChunkSize; z-- > 0;) write_row(steps_[z], symbols_[z]);
  }

 private:
  void write_row(const Steps& steps, const RowSymbols& row) {
    RansWriter coder = coder_;  // a copy that lives in registers
    const auto write_column = [&](std::uint32_t & state, std::size_t x) __attribute__((always_inline)) {
      if (row.symbol[x] == kFurtherOff) [[unlikely]] {
        write_further(coder, state, change_of(steps.data()[x], steps.padded[x]));
      }
      coder.put(state, kShares[kOddsIndex[row.context[x]]][row.symbol[x]]);
    };
    for (std::size_t x = kChunkSize; x > 0; x -= 2) {
      write_column(coder.odd, x - 1);
      write_column(coder.even, x - 2);
    }
    coder_ = coder;
  }

  static void write_further(RansWriter& coder, std::uint32_t& state, int change) {
    const std::uint32_t place = place_of(change);
    if (place >= kLastPlace) coder.put(state, place_share(place));
    coder.put(state, kFurtherShares[std::min(place, kLastPlace)]);
  }

  RansWriter& coder_;
  const VoxelKernels& kernels_ = voxel_kernels();
  std::array<Steps, kChunkSize> steps_;
  std::array<RowSymbols, kChunkSize> symbols_;
};

// ---- Reading ----

class PlaneReader {
 public:
  explicit PlaneReader(RansReader& coder) : coder_{coder} {}

  /// False where a row lies below its floor or above the chunk.
  [[nodiscard]] bool read(std::uint8_t* plane, const std::uint8_t* below) {
    std::array<Steps, 2> steps;
    RowGuess guess;
    for (std::size_t z = 0; z < kChunkSize; ++z) {
      const RowsBefore before = RowsBefore::of(plane, below, z, steps[(z + 1) % 2]);
      kernels_.guess(before, guess);
      Steps& found = steps[z % 2];
      if (!read_row(guess.context, found)) return false;
      if (!kernels_.apply(guess, found, before.floor, plane + z * kChunkSize)) return false;
    }
    return true;
  }

 private:
  [[nodiscard]] bool read_row(const std::array<std::uint16_t, kChunkSize>& contexts, Steps& steps) {
    RansReader coder = coder_;  // a copy that lives in registers
    std::size_t west = 0;       // the context of the column to the west
    std::size_t level = 0;      // that of a column that is as predicted
    int carried = 0;            // the step of the column to the west where it is steep
    bool inside = true;
    const auto read_column = [&](std::uint32_t & state, std::size_t x) __attribute__((always_inline)) {
      const Odds& odds = kOddsByContext[contexts[x] + west];
      const std::uint32_t place = RansReader::place(state);
      int step = carried;
      west = level;
      if (place < odds.up) [[likely]] {
        coder.took(state, 0, odds.up);
      } else {
        if (place < odds.further) [[likely]] {
          // Which of the two nobody can foretell: chosen without a branch.
          const bool down = place >= odds.down;
          const std::uint32_t start = down ? odds.down : odds.up;
          const std::uint32_t end = down ? odds.further : odds.down;
          coder.took(state, start, end - start);
          step += down ? -1 : 1;
        } else {
          coder.took(state, odds.further, kOddsTotal - odds.further);
          step += read_further(coder, state);
        }
        if (carried == 0 && place < odds.further) [[likely]] {
          west = context_of(step > 0 ? West::up : West::down);
        } else {
          inside &= std::abs(step) <= kMostStep;
          west = context_of(west_of(step));
          const bool steep = west == context_of(West::steep);
          carried = steep ? step : 0;
          level = steep ? west : 0;
        }
      }
      steps.data()[x] = static_cast<std::int8_t>(step);
    };
    for (std::size_t x = 0; x < kChunkSize; x += 4) {
      read_column(coder.even, x);
      read_column(coder.odd, x + 1);
      read_column(coder.even, x + 2);
      read_column(coder.odd, x + 3);
    }
    coder_ = coder;
    return inside;
  }

  static int read_further(RansReader& coder, std::uint32_t& state) {
    const std::uint32_t where = RansReader::place(state);
    std::uint32_t place = 0;
    while (kFurther[place + 1] <= where) ++place;
    coder.took(state, kFurther[place], static_cast<std::uint32_t>(kFurther[place + 1] - kFurther[place]));
    if (place == kLastPlace) {
      place = RansReader::place(state) / kPlaceShare;
      coder.took(state, place * kPlaceShare, kPlaceShare);
    }
    return change_at(place);
  }

  RansReader& coder_;
  const VoxelKernels& kernels_ = voxel_kernels();
};

}  // namespace

bool encode_layered(const Layers& layers, std::vector<std::byte>& out) {
  const std::size_t begin = out.size();
  put_materials(layers.materials, out);
  if (layers.plane_count() == 0) return true;
  // On the stack, where only what is written is touched; one plane past the limit still fits.
  std::array<std::byte, kMostBytes + kChunkArea * kMostBytesOfColumn> buffer;
  RansWriter coder{buffer};
  PlaneWriter planes{coder};
  const std::byte* const end = buffer.data() + buffer.size();
  const std::uint8_t* const tops = layers.tops.data();
  for (std::size_t p = layers.plane_count(); p-- > 0;) {
    planes.write(tops + p * kChunkArea, p == 0 ? nullptr : tops + (p - 1) * kChunkArea);
    if (static_cast<std::size_t>(end - coder.next()) > kMostBytes - kMaterialsBytes) {
      out.resize(begin);
      return false;
    }
  }
  out.insert(out.end(), coder.finish(), end);
  return true;
}

tl::expected<Chunk, DecodeError> decode_layered(std::span<const std::byte> body) {
  auto materials = take_layer_materials(body);
  if (!materials) return tl::unexpected{materials.error()};
  if (materials->size() == 1) {
    if (!body.empty()) return tl::unexpected{DecodeError::too_long};
    return Chunk::uniform(materials->front());
  }
  Layers layers{std::move(*materials), {}};
  layers.tops.resize(layers.plane_count() * kChunkArea);
  RansReader coder{body};
  if (const auto fault = coder.fault_of_beginning()) return tl::unexpected{*fault};
  PlaneReader planes{coder};
  for (std::size_t p = 0; p < layers.plane_count(); ++p) {
    std::uint8_t* const plane = layers.tops.data() + p * kChunkArea;
    const bool inside = planes.read(plane, p == 0 ? nullptr : plane - kChunkArea);
    if (coder.starved()) return tl::unexpected{DecodeError::truncated};
    if (!inside) return tl::unexpected{DecodeError::bad_number};
  }
  if (const auto fault = coder.fault()) return tl::unexpected{*fault};
  return Chunk::from_layers(std::move(layers));
}

}  // namespace talus::codec
