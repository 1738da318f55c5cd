// Layers of codec version 2: FORMAT.md, "Version 2". Column by column, as nobody writes them any more.
#include <algorithm>
#include <array>
#include <cstdlib>

#include "header.h"
#include "layered.h"
#include "layered_v2_odds.h"

namespace talus::codec {
namespace {

constexpr std::uint32_t kTotal = 4096;
constexpr std::uint32_t kLeastState = 1U << 16;
constexpr std::uint32_t kLastPlace = kFurther.size() - 2;  // from it on the place itself follows
constexpr std::uint32_t kPlaceShare = 32;
constexpr int kMostStep = kChunkSize;
constexpr std::size_t kRowContexts = 486;

const Odds& odds_in(std::size_t context) {
  const char digit = kOddsOfContext[context];
  const int value = digit <= '9' ? digit - '0' : digit <= 'Z' ? digit - 'A' + 10 : digit - 'a' + 36;
  return kOdds[static_cast<std::size_t>(value)];
}

class States {
 public:
  explicit States(std::span<const std::byte> bytes) : bytes_{bytes} {
    for (std::uint32_t& state : states_) {
      for (int i = 0; i < 3; ++i) state = state << 8 | take();
    }
  }

  [[nodiscard]] bool starved() const { return starved_; }
  [[nodiscard]] bool may_begin() const {
    return std::all_of(states_.begin(), states_.end(),
                       [](std::uint32_t state) { return state >= kLeastState; });
  }
  [[nodiscard]] bool bytes_left() const { return !bytes_.empty(); }
  [[nodiscard]] bool ended() const {
    return std::all_of(states_.begin(), states_.end(),
                       [](std::uint32_t state) { return state == kLeastState; });
  }

  [[nodiscard]] std::uint32_t place(std::size_t which) const { return states_[which] % kTotal; }

  void took(std::size_t which, std::uint32_t start, std::uint32_t end) {
    std::uint32_t& state = states_[which];
    state = (end - start) * (state / kTotal) + state % kTotal - start;
    while (state < kLeastState) state = state << 8 | take();
  }

 private:
  std::uint32_t take() {
    if (bytes_.empty()) {
      starved_ = true;
      return 0xFF;  // any but 0, with which a state might never grow
    }
    const auto byte = std::to_integer<std::uint32_t>(bytes_.front());
    bytes_ = bytes_.subspan(1);
    return byte;
  }

  std::span<const std::byte> bytes_;
  std::array<std::uint32_t, 2> states_{};
  bool starved_ = false;
};

int read_further(States& states, std::size_t which) {
  const std::uint32_t where = states.place(which);
  std::uint32_t place = 0;
  while (kFurther[place + 1] <= where) ++place;
  states.took(which, kFurther[place], kFurther[place + 1]);
  if (place == kLastPlace) {
    place = states.place(which) / kPlaceShare;
    states.took(which, place * kPlaceShare, (place + 1) * kPlaceShare);
  }
  const int size = static_cast<int>(place / 2) + 2;
  return place % 2 == 0 ? size : -size;
}

int read_change(States& states, std::size_t which, const Odds& odds) {
  const std::uint32_t place = states.place(which);
  if (place < odds.up) return states.took(which, 0, odds.up), 0;
  if (place < odds.down) return states.took(which, odds.up, odds.down), 1;
  if (place < odds.further) return states.took(which, odds.down, odds.further), -1;
  states.took(which, odds.further, kTotal);
  return read_further(states, which);
}

std::size_t sign(int value) {
  return value < 0 ? 0 : value == 0 ? 1 : 2;
}

std::size_t west_of(int step) {
  return step == 0 ? 0 : step == 1 ? 1 : step == -1 ? 2 : 3;
}

using Steps = std::array<int, kChunkSize>;

/// False where a row lies below its floor or above the chunk.
bool read_row(States& states, std::uint8_t* row, const std::uint8_t* floor, const std::uint8_t* northern,
              const std::uint8_t* floor_north, const Steps& steps_north, Steps& steps) {
  bool inside = true;
  const auto north = [&](int x) { return int{northern[std::clamp<int>(x, 0, kChunkSize - 1)]}; };
  const auto step_north = [&](int x) {
    return x < 0 || x >= kChunkSize ? 0 : steps_north[static_cast<std::size_t>(x)];
  };
  for (int x = 0; x < kChunkSize; ++x) {
    const auto i = static_cast<std::size_t>(x);
    const bool bare = northern[i] == floor_north[i];
    std::size_t context = sign(north(x) - north(x - 1));
    context = context * 3 + sign(north(x + 2) - north(x));
    context = context * 3 + sign(step_north(x + 1));
    context = context * 3 + sign(step_north(x - 1));
    context = context * 3 + sign(floor[i] - floor_north[i]);
    const int west = x == 0 ? 0 : steps[i - 1];
    context += (bare ? kRowContexts / 2 : 0) + west_of(west) * kRowContexts;
    const int carried = std::abs(west) >= 2 ? west : 0;
    const int step = carried + read_change(states, i % 2, odds_in(context));
    const int top = (bare ? floor[i] : std::max(northern[i], floor[i])) + step;
    inside = inside && std::abs(step) <= kMostStep && top >= floor[i] && top <= kChunkSize;
    if (!inside) return false;
    steps[i] = step;
    row[i] = static_cast<std::uint8_t>(top);
  }
  return true;
}

bool read_plane(States& states, std::uint8_t* plane, const std::uint8_t* below) {
  Steps north;
  north.fill(1);
  for (std::size_t z = 0; z < kChunkSize; ++z) {
    const std::uint8_t* const floor = below + z * kChunkSize;
    const std::uint8_t* const floor_north = z == 0 ? floor : floor - kChunkSize;
    std::uint8_t* const row = plane + z * kChunkSize;
    Steps steps{};
    if (!read_row(states, row, floor, z == 0 ? floor : row - kChunkSize, floor_north, north, steps))
      return false;
    north = steps;
  }
  return true;
}

}  // namespace

tl::expected<Chunk, DecodeError> decode_layered_v2(std::span<const std::byte> body) {
  auto materials = take_layer_materials(body);
  if (!materials) return tl::unexpected{materials.error()};
  if (materials->size() == 1) {
    if (!body.empty()) return tl::unexpected{DecodeError::too_long};
    return Chunk::uniform(materials->front());
  }
  States states{body};
  if (states.starved()) return tl::unexpected{DecodeError::truncated};
  if (!states.may_begin()) return tl::unexpected{DecodeError::bad_ending};
  Layers layers{std::move(*materials), {}};
  layers.tops.resize(layers.plane_count() * kChunkArea);
  static constexpr std::array<std::uint8_t, kChunkArea> kGround{};
  const std::uint8_t* below = kGround.data();
  for (std::size_t p = 0; p < layers.plane_count(); ++p) {
    std::uint8_t* const plane = layers.tops.data() + p * kChunkArea;
    const bool inside = read_plane(states, plane, below);
    if (states.starved()) return tl::unexpected{DecodeError::truncated};
    if (!inside) return tl::unexpected{DecodeError::bad_number};
    below = plane;
  }
  if (states.bytes_left()) return tl::unexpected{DecodeError::too_long};
  if (!states.ended()) return tl::unexpected{DecodeError::bad_ending};
  return Chunk::from_layers(std::move(layers));
}

}  // namespace talus::codec
