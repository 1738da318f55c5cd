#include "layered.h"

#include <algorithm>
#include <array>

#include "header.h"
#include "range_coder.h"

namespace talus::codec {
namespace {

constexpr std::size_t kUnary = 12;

// The context of a column, mixed into one number: which way the surface falls around it (three signs: west,
// north and north-east), how much room its prediction has, the sign of the residual in the plane below, and
// which of two neighbours touch the floor.
constexpr std::size_t kTouching = 1;
constexpr std::size_t kBelow = 4 * kTouching;
constexpr std::size_t kRoom = 3 * kBelow;
constexpr std::size_t kNorthEast = 3 * kRoom;
constexpr std::size_t kNorth = 3 * kNorthEast;
constexpr std::size_t kWest = 3 * kNorth;
constexpr std::size_t kContexts = 3 * kWest;
constexpr std::size_t kForm = kNorthEast;  // context / kForm: the three signs alone

struct PlaneModels {
  std::array<BitModel, kContexts> differs;
  std::array<BitModel, kContexts / kForm> falls;
  std::array<std::array<BitModel, kUnary>, 2> goes_on;  // falls, size
};

constexpr std::size_t sign(int value) {
  return static_cast<std::size_t>((value > 0 ? 1 : 0) - (value < 0 ? 1 : 0) + 1);
}

/// The same of a and b, in bytes.
template <class Byte>
constexpr std::uint8_t byte_sign(Byte a, Byte b) {
  return static_cast<std::uint8_t>(1 + (a > b ? 1 : 0) - (a < b ? 1 : 0));
}

/// By west - corner + 32.
constexpr auto kWestPart = [] {
  std::array<std::uint16_t, 2 * kChunkSize + 1> parts{};
  for (int i = 0; i <= 2 * kChunkSize; ++i) {
    parts[static_cast<std::size_t>(i)] = static_cast<std::uint16_t>(sign(i - kChunkSize) * kWest);
  }
  return parts;
}();

/// Reads a residual that is not 0; it lies in `least` to `most`, both sides of 0.
int read_distance(Decoder& coder, PlaneModels& models, std::size_t form, int least, int most) {
  bool falls = most == 0;
  if (least < 0 && most > 0) falls = coder.code(models.falls[form]);
  const int limit = falls ? -least : most;
  auto& goes_on = models.goes_on[falls ? 1 : 0];
  int size = 1;
  while (size < limit && coder.code(goes_on[std::min(static_cast<std::size_t>(size), kUnary) - 1])) ++size;
  return falls ? -size : size;
}

/// Reads plane after plane, each a row after a row.
class PlaneReader {
 public:
  PlaneReader(Decoder& coder, std::uint8_t* tops) : coder_{coder}, tops_{tops} {}

  void read_plane(std::size_t index) {
    plane_ = tops_ + index * kChunkArea;
    floor_ = index == 0 ? kGround.data() : plane_ - kChunkArea;
    read_first_row();
    for (int z = 1; z < kChunkSize; ++z) read_row(plane_ + z * kChunkSize, z);
  }

 private:
  static constexpr std::array<std::uint8_t, kChunkArea> kGround{};

  /// Nothing lies north of it: what is west stands for all around, and for the first column the floor.
  void read_first_row() {
    constexpr std::size_t kFlat = kWest + kNorth + kNorthEast;
    int west = floor_[0];
    std::size_t touching = 3;
    for (int x = 0; x < kChunkSize; ++x) {
      const auto i = static_cast<std::size_t>(x);
      const std::size_t context = kFlat + sign(below_[i]) * kBelow + touching * kTouching;
      west = read_column(i, west, context);
      touching = west == floor_[i] ? 3 : 2;
    }
  }

  void read_row(const std::uint8_t* row, int z) {
    const std::size_t first = static_cast<std::size_t>(z) * kChunkSize;
    // The row to the north, and once more what lies at its ends.
    std::array<std::uint8_t, kChunkSize + 2> around;
    std::copy_n(row - kChunkSize, kChunkSize, around.begin() + 1);
    around.front() = around[1];
    around.back() = around[kChunkSize];
    const std::array<std::uint16_t, kChunkSize> known = context_of_north(around, first);
    int west = around[1];
    int corner = west;
    std::size_t touches_west = 1;
    for (std::size_t x = 0; x < kChunkSize; ++x) {
      // The median of west, north and the plane through all three: keeps edges and follows slopes.
      const int north = around[x + 1];
      const int predicted = std::clamp(west + north - corner, std::min(west, north), std::max(west, north));
      const std::size_t context = known[x] + kWestPart[static_cast<std::size_t>(west - corner + kChunkSize)] +
                                  touches_west * kTouching;
      corner = north;
      west = read_column(first + x, predicted, context);
      touches_west = west == floor_[first + x] ? 1 : 0;
    }
  }

  /// What the rows before tell about every column of a row: plain loops over bytes, so that they run in
  /// vectors.
  std::array<std::uint16_t, kChunkSize> context_of_north(
      const std::array<std::uint8_t, kChunkSize + 2>& around, std::size_t first) const {
    std::array<std::uint8_t, kChunkSize> north{};
    std::array<std::uint8_t, kChunkSize> north_east{};
    std::array<std::uint8_t, kChunkSize> below{};
    for (std::size_t x = 0; x < kChunkSize; ++x) {
      north[x] = byte_sign(around[x + 1], around[x]);
      north_east[x] = byte_sign(around[x + 2], around[x + 1]);
      below[x] = byte_sign(below_[first + x], std::int8_t{0});
    }
    const std::uint8_t* const floor = floor_ + first - kChunkSize;
    std::array<std::uint16_t, kChunkSize> known{};
    for (std::size_t x = 0; x < kChunkSize; ++x) {
      const auto touches = static_cast<std::uint8_t>(around[x + 1] == floor[x] ? 2 : 0);
      const auto low =
          static_cast<std::uint8_t>(below[x] * kBelow + touches * kTouching + north_east[x] * kNorthEast);
      known[x] = static_cast<std::uint16_t>(low + north[x] * kNorth);
    }
    return known;
  }

  /// Returns the column's top.
  int read_column(std::size_t i, int predicted, std::size_t context) {
    const int lowest = floor_[i];
    if (lowest == kChunkSize) {
      below_[i] = 0;
      plane_[i] = kChunkSize;
      return kChunkSize;
    }
    predicted = std::clamp(predicted, lowest, kChunkSize);
    const std::size_t room = predicted == lowest ? 0 : predicted == kChunkSize ? 2 : 1;
    context += room * kRoom;
    int residual = 0;
    if (coder_.code(models_.differs[context])) {
      residual = read_distance(coder_, models_, context / kForm, lowest - predicted, kChunkSize - predicted);
    }
    below_[i] = static_cast<std::int8_t>(residual);
    plane_[i] = static_cast<std::uint8_t>(predicted + residual);
    return plane_[i];
  }

  Decoder& coder_;
  std::uint8_t* tops_;
  std::uint8_t* plane_ = nullptr;
  const std::uint8_t* floor_ = nullptr;          // the plane below
  std::array<std::int8_t, kChunkArea> below_{};  // residuals: of the plane below, then of this one
  PlaneModels models_;
};

}  // namespace

tl::expected<Chunk, DecodeError> decode_layered_v1(std::span<const std::byte> body) {
  auto materials = take_layer_materials(body);
  if (!materials) return tl::unexpected{materials.error()};
  if (materials->size() == 1) {
    if (!body.empty()) return tl::unexpected{DecodeError::too_long};
    return Chunk::uniform(materials->front());
  }
  Layers layers{std::move(*materials), {}};
  layers.tops.resize(layers.plane_count() * kChunkArea);
  Decoder coder{body};
  PlaneReader planes{coder, layers.tops.data()};
  for (std::size_t p = 0; p < layers.plane_count(); ++p) {
    planes.read_plane(p);
    if (coder.starved()) return tl::unexpected{DecodeError::truncated};
  }
  if (const auto fault = coder.fault()) return tl::unexpected{*fault};
  return Chunk::from_layers(std::move(layers));
}

}  // namespace talus::codec
