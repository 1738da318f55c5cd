// Loose material, noise, planes and voxels of a chunk by every instruction set of this processor: the same
// bits as by scalar code.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "loose/settle_grid.h"
#include "noise/fbm_rows.h"
#include "plane_scalar.h"
#include "runs.h"
#include "volume.h"
#include "volume_scalar.h"

namespace {

using namespace talus;
using namespace talus::terrain;

/// Numbers out of the input, 0 where it has ended.
class Input {
 public:
  explicit Input(std::span<const std::uint8_t> bytes) : bytes_{bytes} {}

  template <class Number>
  Number take() {
    Number number = 0;
    const std::size_t size = std::min(sizeof(Number), bytes_.size());
    if (size > 0) std::memcpy(&number, bytes_.data(), size);
    bytes_ = bytes_.subspan(size);
    return number;
  }

  [[nodiscard]] bool empty() const { return bytes_.empty(); }

 private:
  std::span<const std::uint8_t> bytes_;
};

std::vector<std::int32_t> settled(InstructionSet set, const Field& start, std::int32_t repose) {
  SettleGrid grid{set};
  grid.start(start);
  grid.settle(repose);
  std::vector<std::int32_t> all;
  for (int z = 0; z < start.depth; ++z) {
    grid.with_row(z, [&](const auto* row) { all.insert(all.end(), row, row + start.width); });
  }
  return all;
}

std::vector<float> noise(InstructionSet set, const Fbm& fbm, const std::vector<std::int64_t>& xs,
                         std::int64_t first_z) {
  FbmRows rows{set};
  rows.start(fbm, xs);
  std::vector<float> all;
  for (std::int64_t z = first_z; z < first_z + 4; ++z) {
    const float* row = rows.row(z, 0, xs.size());
    all.insert(all.end(), row, row + xs.size());
  }
  return all;
}

void settle_everywhere(Input& input) {
  Field start{1 + input.take<std::uint8_t>() % 80, 1 + input.take<std::uint8_t>() % 8};
  const std::int32_t repose = 1 + input.take<std::uint16_t>() % 14667;
  const std::uint32_t most = input.take<std::uint8_t>() % 2 == 0 ? 0x7FFF : 0x100000;
  for (std::int32_t& value : start.values) {
    value = static_cast<std::int32_t>(input.take<std::uint32_t>() % (most + 1));
  }
  const auto scalar = settled(InstructionSet::scalar, start, repose);
  for (const auto set : kInstructionSets) {
    if (runs_here(set) && settled(set, start, repose) != scalar) std::abort();
  }
}

void sample_everywhere(Input& input) {
  constexpr std::int64_t kFar = std::int64_t{1} << 36;
  Fbm fbm;
  fbm.seed = input.take<std::uint64_t>();
  fbm.period = 2 + input.take<std::uint32_t>() % (1 << 24);
  fbm.octaves = 1 + input.take<std::uint8_t>() % 16;
  const std::int64_t z = input.take<std::int64_t>() % kFar;
  std::vector<std::int64_t> xs{input.take<std::int64_t>() % kFar};
  const int count = 1 + input.take<std::uint8_t>() % 100;
  for (int i = 1; i < count; ++i) xs.push_back(xs.back() + 1 + input.take<std::uint8_t>() % 64);
  const auto scalar = noise(InstructionSet::scalar, fbm, xs, z);
  for (const auto set : kInstructionSets) {
    if (!runs_here(set)) continue;
    const auto vectors = noise(set, fbm, xs, z);
    if (std::memcmp(scalar.data(), vectors.data(), scalar.size() * sizeof(float)) != 0) std::abort();
  }
}

/// What is written before `states`, and what they are then.
template <class Write>
auto written(const Write& write, const codec::PlaneIntervals& intervals,
             const std::array<std::uint16_t, codec::kLanes>& states) {
  std::vector<std::uint8_t> bytes(codec::kMaxBytesOfPlane + codec::kScribbled);
  codec::RansSink sink{states, bytes.data() + bytes.size()};
  write(intervals, sink);
  return std::pair{std::vector<std::uint8_t>(sink.next, bytes.data() + bytes.size()), sink.states};
}

/// A plane out of the input's bytes, and one above it out of the rest; what can be read is written again.
void read_everywhere(Input& input) {
  using namespace talus::codec;
  std::vector<std::uint8_t> bytes;
  RansSource source;
  for (std::uint16_t& state : source.states) {
    state = static_cast<std::uint16_t>(std::max<std::uint32_t>(input.take<std::uint16_t>(), kMinState));
  }
  while (!input.empty() && bytes.size() < kMaxBytesOfPlane) bytes.push_back(input.take<std::uint8_t>());
  const std::size_t size = bytes.size();
  bytes.resize(size + kReadAhead);
  source.next = bytes.data();
  source.end = bytes.data() + size;

  std::vector<std::uint8_t> below(kChunkArea);
  for (int planes = 0; planes < 2; ++planes) {
    std::vector<std::uint8_t> plane(kChunkArea);
    RansSource after = source;
    const PlaneFault fault = decode_plane_scalar(after, below.data(), plane.data());
    PlaneIntervals intervals;
    if (fault == PlaneFault::none) model_plane_scalar(plane.data(), below.data(), intervals);
    for (const auto set : kInstructionSets) {
      if (!runs_here(set)) continue;
      const PlaneKernels kernels = plane_kernels(set);
      std::vector<std::uint8_t> other(kChunkArea);
      RansSource other_after = source;
      if (kernels.decode(other_after, below.data(), other.data()) != fault) std::abort();
      if (fault != PlaneFault::none) continue;
      if (other != plane || other_after.states != after.states || other_after.next != after.next)
        std::abort();
      PlaneIntervals found;
      kernels.model(plane.data(), below.data(), found);
      if (found.start != intervals.start || found.size != intervals.size ||
          found.others != intervals.others || found.carried != intervals.carried) {
        std::abort();
      }
      if (written(kernels.encode, found, after.states) !=
          written(encode_plane_scalar, intervals, after.states)) {
        std::abort();
      }
    }
    if (fault != PlaneFault::none) return;
    below = plane;
    source = after;
  }
}

void check_same(const tl::expected<Chunk, DecodeError>& found,
                const tl::expected<Chunk, DecodeError>& expected) {
  if (found.has_value() != expected.has_value()) std::abort();
  if (expected ? *found != *expected : found.error() != expected.error()) std::abort();
}

/// What follows the header of a volume or of runs; what can be read is written again.
void read_voxels_everywhere(Input& input) {
  using namespace talus::codec;
  std::vector<std::byte> body;
  const bool runs = input.take<std::uint8_t>() % 2 == 1;
  while (!input.empty()) body.push_back(std::byte{input.take<std::uint8_t>()});
  const auto read = [&](const VolumeKernels& kernels) {
    return runs ? decode_runs(body, kernels) : decode_volume(body, kernels);
  };
  const auto expected = read(kScalarVolume);
  const auto written = [&](const VolumeKernels& kernels) {
    std::vector<std::byte> bytes;
    auto voxels = std::make_unique<DenseVoxels>();
    expected->copy_to(*voxels);
    (void)encode_volume(*voxels, bytes, kernels);
    (void)encode_runs(*voxels, kMaxPayloadBytes, bytes, kernels);
    return bytes;
  };
  for (const auto set : kInstructionSets) {
    if (!runs_here(set)) continue;
    check_same(read(volume_kernels(set)), expected);
    if (expected && written(volume_kernels(set)) != written(kScalarVolume)) std::abort();
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Input input{{data, size}};
  const auto kind = input.take<std::uint8_t>();
  switch (kind == 0xFF ? 3 : kind % 3) {
    case 3:
      read_voxels_everywhere(input);
      break;
    case 0:
      settle_everywhere(input);
      break;
    case 1:
      sample_everywhere(input);
      break;
    default:
      read_everywhere(input);
  }
  return 0;
}
