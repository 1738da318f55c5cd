#include "layered.h"

#include <algorithm>
#include <array>
#include <cstdlib>

#include "header.h"
#include "range_coder.h"

namespace talus::codec {
namespace {

using Residuals = std::array<std::int8_t, kChunkArea>;

constexpr std::size_t kUnary = 12;

struct PlaneModels {
  std::array<std::array<std::array<std::array<BitModel, 4>, 3>, 3>, 27>
      differs;                                          // form, room, below, touching
  std::array<BitModel, 27> falls;                       // form
  std::array<std::array<BitModel, kUnary>, 2> goes_on;  // falls, size
};

std::size_t sign(int value) {
  return value < 0 ? 0U : value == 0 ? 1U : 2U;
}

/// The rows known around a column: as a picture, from above, north up.
struct Around {
  int corner, north, north_east, west;

  /// The median of west, north and the plane through all three: keeps edges and follows slopes.
  [[nodiscard]] int predicted() const {
    const auto [low, high] = std::minmax(west, north);
    return corner >= high ? low : corner <= low ? high : west + north - corner;
  }
  /// Which way the surface falls here, 0 to 26.
  [[nodiscard]] std::size_t form() const {
    return (sign(west - corner) * 3 + sign(north - corner)) * 3 + sign(north_east - north);
  }
};

/// Beyond an edge lies what is nearest on this side of it; `first` stands for all before the first column.
Around look_around(const std::uint8_t* plane, int x, int z, int first) {
  const std::uint8_t* const at = plane + column_index(x, z);
  if (z == 0) {
    const int west = x > 0 ? at[-1] : first;
    return {west, west, west, west};
  }
  const std::uint8_t* const north = at - kChunkSize;
  const int north_east = x + 1 < kChunkSize ? north[1] : north[0];
  if (x == 0) return {north[0], north[0], north_east, north[0]};
  return {north[-1], north[0], north_east, at[-1]};
}

/// Codes how far a column lies from its prediction; the result lies in `least` to `most`, both sides of 0.
template <class Coder>
int code_residual(Coder& coder, PlaneModels& models, BitModel& differs, std::size_t form, int least, int most,
                  int residual) {
  if (!coder.code(differs, residual != 0)) return 0;
  bool falls = most == 0;
  if (least < 0 && most > 0) falls = coder.code(models.falls[form], residual < 0);
  const int limit = falls ? -least : most;
  const int size = std::abs(residual);
  auto& goes_on = models.goes_on[falls ? 1 : 0];
  int found = 1;
  while (found < limit) {
    BitModel& model = goes_on[std::min(static_cast<std::size_t>(found), kUnary) - 1];
    if (!coder.code(model, size > found)) break;
    ++found;
  }
  return falls ? -found : found;
}

/// `floor` is the plane below, `below` its residuals; `residuals` are those of this plane.
template <class Coder, class Row>
void code_plane(Coder& coder, PlaneModels& models, const std::uint8_t* floor, const Residuals& below,
                Row* plane, Residuals& residuals) {
  for (int z = 0; z < kChunkSize; ++z) {
    for (int x = 0; x < kChunkSize; ++x) {
      const std::size_t i = column_index(x, z);
      const int lowest = floor[i];
      if (lowest == kChunkSize) {
        residuals[i] = 0;
        if constexpr (Coder::kDecodes) plane[i] = kChunkSize;
        continue;
      }
      const Around around = look_around(plane, x, z, lowest);
      const int predicted = std::clamp(around.predicted(), lowest, kChunkSize);
      const std::size_t form = around.form();
      const std::size_t room = predicted == lowest ? 0 : predicted == kChunkSize ? 2 : 1;
      const bool touches_west = x == 0 || plane[i - 1] == floor[i - 1];
      const bool touches_north = z == 0 || plane[i - kChunkSize] == floor[i - kChunkSize];
      const std::size_t touching = (touches_west ? 1U : 0U) + (touches_north ? 2U : 0U);
      const int residual = code_residual(coder, models, models.differs[form][room][sign(below[i])][touching],
                                         form, lowest - predicted, kChunkSize - predicted,
                                         Coder::kDecodes ? 0 : plane[i] - predicted);
      residuals[i] = static_cast<std::int8_t>(residual);
      if constexpr (Coder::kDecodes) plane[i] = static_cast<std::uint8_t>(predicted + residual);
    }
  }
}

/// False where the decoder ran out of bytes.
template <class Coder, class Row>
bool code_planes(Coder& coder, std::size_t count, Row* tops) {
  constexpr std::array<std::uint8_t, kChunkArea> kFloor{};
  PlaneModels models;
  Residuals below{};
  Residuals residuals{};
  for (std::size_t p = 0; p < count; ++p) {
    Row* const plane = tops + p * kChunkArea;
    code_plane(coder, models, p == 0 ? kFloor.data() : plane - kChunkArea, below, plane, residuals);
    below = residuals;
    if constexpr (Coder::kDecodes) {
      if (coder.starved()) return false;
    }
  }
  return true;
}

}  // namespace

void encode_layered(const Layers& layers, std::vector<std::byte>& out) {
  put_materials(layers.materials, out);
  if (layers.plane_count() == 0) return;
  Encoder coder{out};
  code_planes(coder, layers.plane_count(), layers.tops.data());
  coder.finish();
}

tl::expected<Chunk, DecodeError> decode_layered(std::span<const std::byte> body) {
  auto materials = take_materials(body, Layers::kMaxMaterials);
  if (!materials) return tl::unexpected{materials.error()};
  if (std::adjacent_find(materials->begin(), materials->end()) != materials->end()) {
    return tl::unexpected{DecodeError::bad_materials};
  }
  if (materials->size() == 1) {
    if (!body.empty()) return tl::unexpected{DecodeError::too_long};
    return Chunk::uniform(materials->front());
  }
  Layers layers{std::move(*materials), {}};
  layers.tops.resize(layers.plane_count() * kChunkArea);
  Decoder coder{body};
  if (!code_planes(coder, layers.plane_count(), layers.tops.data())) {
    return tl::unexpected{DecodeError::truncated};
  }
  if (const auto fault = coder.fault()) return tl::unexpected{*fault};
  return Chunk::from_layers(std::move(layers));
}

}  // namespace talus::codec
