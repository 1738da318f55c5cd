#include "layered.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "header.h"
#include "plane_kernels.h"

namespace talus::codec {
namespace {

constexpr std::size_t kMaxBytes = sizeof(DenseVoxels);  // larger results are better stored raw
constexpr std::size_t kMaterialsBytes = 256;            // upper bound for a list of materials

// Added to the count of materials if their ids are stored in the states' final bytes instead of in front.
constexpr std::size_t kCountInStates = Layers::kMaxMaterials;

constexpr std::array<std::uint8_t, kChunkArea> kFloorPlane{};

using EndBytes = std::array<std::uint8_t, kLanes>;

/// Writes the ids as numbers into the states' final bytes if they fit, followed by zeros.
bool put_in_states(std::span<const MaterialId> materials, EndBytes& ends) {
  std::array<std::byte, kLanes + kMaxBytesOfNumber> numbers;
  std::size_t size = 0;
  for (const MaterialId material : materials) {
    size = static_cast<std::size_t>(put_number(to_integer(material), numbers.data() + size) - numbers.data());
    if (size > ends.size()) return false;
  }
  std::memcpy(ends.data(), numbers.data(), size);
  return true;
}

tl::expected<void, DecodeError> take_from_states(const RansSource& source, std::span<MaterialId> materials) {
  std::array<std::byte, kLanes> ends;
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    if (source.states[lane] >= 2 * kMinState) return tl::unexpected{DecodeError::bad_ending};
    ends[lane] = static_cast<std::byte>(source.states[lane] - kMinState);
  }
  std::span<const std::byte> numbers{ends};
  for (MaterialId& material : materials) {
    const auto id = take_number(numbers);
    if (!id) return tl::unexpected{DecodeError::bad_ending};
    material = MaterialId{*id};
  }
  const bool rest =
      std::any_of(numbers.begin(), numbers.end(), [](std::byte byte) { return byte != std::byte{0}; });
  if (rest) return tl::unexpected{DecodeError::bad_ending};
  return {};
}

}  // namespace

bool encode_layered(const Layers& layers, std::size_t limit, std::vector<std::byte>& out) {
  const std::size_t begin = out.size();
  EndBytes ends{};
  if (layers.plane_count() > 0 && put_in_states(layers.materials, ends)) {
    put_number(static_cast<std::uint16_t>(kCountInStates + layers.materials.size()), out);
  } else {
    put_materials(layers.materials, out);
    if (layers.plane_count() == 0) return out.size() - begin <= limit;
  }
  // On the stack, where only bytes written are touched; one plane beyond the limit still fits.
  std::array<std::uint8_t, kMaxBytes + kMaxBytesOfPlane + kStatesBytes + kScribbled> buffer;
  std::uint8_t* const end = buffer.data() + buffer.size();
  RansSink sink{{}, end};
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    sink.states[lane] = static_cast<std::uint16_t>(kMinState + ends[lane]);
  }
  PlaneIntervals intervals;
  const PlaneKernels& kernels = plane_kernels();
  const std::uint8_t* const tops = layers.tops.data();
  for (std::size_t p = layers.plane_count(); p-- > 0;) {
    kernels.model(tops + p * kChunkArea, p == 0 ? kFloorPlane.data() : tops + (p - 1) * kChunkArea,
                  intervals);
    kernels.encode(intervals, sink);
    const std::size_t size = out.size() - begin + static_cast<std::size_t>(end - sink.next) + kStatesBytes;
    if (size > std::min(limit, kMaxBytes - kMaterialsBytes)) {
      out.resize(begin);
      return false;
    }
  }
  for (std::size_t lane = kLanes; lane-- > 0;) {
    *--sink.next = static_cast<std::uint8_t>(sink.states[lane] >> 8U);
    *--sink.next = static_cast<std::uint8_t>(sink.states[lane] & 0xFFU);
  }
  out.insert(out.end(), reinterpret_cast<const std::byte*>(sink.next),
             reinterpret_cast<const std::byte*>(end));
  return true;
}

tl::expected<Chunk, DecodeError> decode_layered(std::span<const std::byte> body) {
  std::span<const std::byte> after_count = body;
  const auto count = take_number(after_count);
  // Sixteen bytes hold at most sixteen ids.
  const bool in_states = count && *count > kCountInStates + 1 && *count <= kCountInStates + kLanes;
  Layers layers;
  if (in_states) {
    body = after_count;
    layers.materials.resize(*count - kCountInStates);
  } else {
    auto materials = take_layer_materials(body);
    if (!materials) return tl::unexpected{materials.error()};
    if (materials->size() == 1) {
      if (!body.empty()) return tl::unexpected{DecodeError::too_long};
      return Chunk::uniform(materials->front());
    }
    layers.materials = std::move(*materials);
  }
  if (body.size() < kStatesBytes) return tl::unexpected{DecodeError::truncated};

  // Vectors read ahead, so the bytes are copied to a buffer with room behind them.
  std::array<std::uint8_t, kMaxPayloadBytes + kReadAhead> bytes;
  std::memcpy(bytes.data(), body.data(), body.size());
  std::memset(bytes.data() + body.size(), 0, kReadAhead);
  RansSource source{{}, bytes.data() + kStatesBytes, bytes.data() + body.size()};
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    source.states[lane] = static_cast<std::uint16_t>(bytes[2 * lane] | bytes[2 * lane + 1] << 8U);
    if (source.states[lane] < kMinState) return tl::unexpected{DecodeError::bad_ending};
  }

  layers.tops.resize(layers.plane_count() * kChunkArea);
  const PlaneKernels& kernels = plane_kernels();
  const std::uint8_t* below = kFloorPlane.data();
  for (std::size_t p = 0; p < layers.plane_count(); ++p) {
    std::uint8_t* const plane = layers.tops.data() + p * kChunkArea;
    switch (kernels.decode(source, below, plane)) {
      case PlaneFault::none:
        break;
      case PlaneFault::truncated:
        return tl::unexpected{DecodeError::truncated};
      case PlaneFault::bad_number:
        return tl::unexpected{DecodeError::bad_number};
    }
    below = plane;
  }
  if (source.next != source.end) return tl::unexpected{DecodeError::too_long};
  if (in_states) {
    if (const auto taken = take_from_states(source, layers.materials); !taken)
      return tl::unexpected{taken.error()};
    if (std::adjacent_find(layers.materials.begin(), layers.materials.end()) != layers.materials.end()) {
      return tl::unexpected{DecodeError::bad_materials};
    }
  } else if (std::any_of(source.states.begin(), source.states.end(),
                         [](std::uint16_t state) { return state != kMinState; })) {
    return tl::unexpected{DecodeError::bad_ending};
  }
  return Chunk::from_layers(std::move(layers));
}

}  // namespace talus::codec
