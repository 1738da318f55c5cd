#include "runs.h"

#include <algorithm>
#include <array>
#include <bit>
#include <memory>

#include "header.h"
#include "material_code.h"
#include "volume_kernels.h"

namespace talus::codec {
namespace {

/// Runs of a chunk: number of voxels after the first, and number of the material.
struct Runs {
  std::array<std::uint16_t, kChunkVolume + 1> more;
  std::array<std::uint8_t, kChunkVolume + 1> kind;
  std::size_t count = 0;
  bool single = false;  // each run is one voxel
};

constexpr std::size_t kMaxGroupBytes = 5 * kLanes;

/// Above this number, run lengths cost more than they save: single voxels are written instead.
constexpr std::size_t kManyRuns = 18'000;

std::size_t digits_of(std::uint16_t more) {
  return static_cast<std::size_t>(std::bit_width(more));
}

/// Interval sizes of the digit counts. No interval covers the whole range: it would not fit a byte.
std::array<std::uint16_t, kDigitCounts> sizes_of(const Runs& runs) {
  std::array<std::uint32_t, kDigitCounts> counts{};
  for (std::size_t i = 0; i < runs.count; ++i) ++counts[digits_of(runs.more[i])];
  std::array<std::uint16_t, kDigitCounts> sizes;
  to_sizes(counts, sizes);
  const auto whole = std::find(sizes.begin(), sizes.end(), kProbabilityTotal);
  if (whole != sizes.end()) {
    --*whole;
    ++*(whole == sizes.begin() ? whole + 1 : sizes.begin());
  }
  return sizes;
}

/// Returns false if there are too many materials.
bool find_runs(const DenseVoxels& voxels, Runs& runs, MaterialCode& materials) {
  runs.more[0] = 0;
  runs.count = 1;
  for (std::size_t i = 1; i < voxels.size(); ++i) {
    // Possible start of the next run, written unconditionally: changes of material are unpredictable.
    runs.more[runs.count] = static_cast<std::uint16_t>(i);
    runs.count += static_cast<std::size_t>(voxels[i] != voxels[i - 1]);
  }
  runs.single = runs.count > kManyRuns;
  if (runs.single) runs.count = voxels.size();
  // Number + 1 by id: one load per voxel, instead of several for a hash.
  std::array<std::uint16_t, 0x10000> after_numbers{};
  // Alternating between two sums: successive increments seldom wait for each other.
  std::array<std::array<std::uint32_t, MaterialCode::kMaxMaterials>, 2> counts{};
  for (std::size_t i = 0; i < runs.count; ++i) {
    const MaterialId material = voxels[runs.single ? i : runs.more[i]];
    std::uint16_t& after_number = after_numbers[to_integer(material)];
    if (after_number == 0) {
      const std::uint32_t number = materials.number_of(material);
      if (number == MaterialCode::kMaxMaterials) return false;
      after_number = static_cast<std::uint16_t>(number + 1);
    }
    const auto number = static_cast<std::uint8_t>(after_number - 1);
    runs.kind[i] = number;
    ++counts[i % 2][number];
  }
  for (std::uint32_t number = 0; number < MaterialCode::kMaxMaterials; ++number) {
    materials.count(number, counts[0][number] + counts[1][number]);
  }
  if (runs.single) return true;
  // Convert the starts of runs to lengths.
  for (std::size_t i = 0; i < runs.count; ++i) {
    const std::size_t end = i + 1 < runs.count ? runs.more[i + 1] : voxels.size();
    runs.more[i] = static_cast<std::uint16_t>(end - runs.more[i] - 1);
  }
  return true;
}

}  // namespace

bool encode_runs(const DenseVoxels& voxels, std::size_t limit, std::vector<std::byte>& out,
                 const VolumeKernels& kernels) {
  Runs runs;  // on the stack, where only bytes written are touched; so is the buffer
  MaterialCode materials{voxels.front()};
  if (!find_runs(voxels, runs, materials)) return false;
  const std::size_t begin = out.size();
  materials.finish(out);
  put_number(static_cast<std::uint16_t>(runs.count), out);
  std::array<Interval, kDigitCounts> digits{};
  if (!runs.single) {
    const auto sizes = sizes_of(runs);
    std::uint16_t start = 0;
    for (std::size_t i = 0; i < kDigitCounts; ++i) {
      out.push_back(static_cast<std::byte>(sizes[i]));
      digits[i] = {start, sizes[i]};
      start = static_cast<std::uint16_t>(start + sizes[i]);
    }
  }

  std::array<std::uint8_t, sizeof(DenseVoxels) + kMaxBatch + kMaxGroupBytes + kStatesBytes + kScribbled>
      bytes;
  std::uint8_t* const end = bytes.data() + bytes.size();
  RansSink sink{{}, end};
  sink.states.fill(static_cast<std::uint16_t>(kMinState));
  const auto size = [&] { return out.size() - begin + static_cast<std::size_t>(end - sink.next); };
  // Single voxels have no lengths between their materials, so many groups are written at once.
  const std::size_t step = runs.single ? kMaxBatch : kLanes;
  for (std::size_t left = runs.count; left > 0 && size() < limit;) {
    const std::size_t count = left % step != 0 ? left % step : step;
    left -= count;
    std::array<std::uint32_t, kMaxBatch> intervals;
    for (std::size_t i = 0; i < count; ++i) intervals[i] = materials.interval(runs.kind[left + i]);
    kernels.write_intervals(intervals.data(), count, sink);
    if (runs.single) continue;
    put_digits(sink, count, [&](std::size_t i) { return std::uint32_t{runs.more[left + i]}; });
    for (std::size_t i = count; i-- > 0;) encode_symbol(sink, i, digits[digits_of(runs.more[left + i])]);
  }
  put_states(sink);
  if (size() >= limit) {
    out.resize(begin);
    return false;
  }
  out.insert(out.end(), reinterpret_cast<const std::byte*>(sink.next),
             reinterpret_cast<const std::byte*>(end));
  return true;
}

tl::expected<Chunk, DecodeError> decode_runs(std::span<const std::byte> body, const VolumeKernels& kernels) {
  SlotTable materials;
  if (const auto first = take_material_code(body, materials); !first) return tl::unexpected{first.error()};
  const auto count = take_number(body);
  if (!count) return tl::unexpected{count.error()};
  const bool single = *count == kChunkVolume;
  SlotTable digits;
  if (!single) {
    if (body.size() < kDigitCounts) return tl::unexpected{DecodeError::truncated};
    std::array<std::uint16_t, kDigitCounts> sizes;
    std::size_t sum = 0;
    for (std::size_t i = 0; i < kDigitCounts; ++i) {
      sizes[i] = std::to_integer<std::uint16_t>(body[i]);
      sum += sizes[i];
    }
    if (sum != kProbabilityTotal) return tl::unexpected{DecodeError::bad_number};
    digits = slots_of(sizes);
    body = body.subspan(kDigitCounts);
  }
  if (body.size() < kStatesBytes) return tl::unexpected{DecodeError::truncated};

  VolumeSource source;
  source.next = reinterpret_cast<const std::uint8_t*>(body.data());
  source.end = source.next + body.size();
  if (!take_states(source)) return tl::unexpected{DecodeError::bad_ending};
  const auto padded = std::make_shared_for_overwrite<PaddedVoxels>();
  DenseVoxels& voxels = padded->voxels;
  std::size_t filled = 0;
  for (std::size_t left = *count; left > 0;) {
    // Single voxels have no groups: as many are read at once as a source allows.
    const std::size_t size = std::min(left, single ? kMaxBatch : kLanes);
    left -= size;
    source.keep_ahead();
    std::array<std::uint32_t, kLanes> lengths;
    if (!single) {
      std::array<std::uint8_t, kLanes> digit_counts;
      kernels.read_slots(source, digits, size, digit_counts.data());
      take_digits(source, digit_counts.data(), size,
                  [&lengths](std::size_t i, std::uint32_t more) { lengths[i] = more + 1; });
    }
    std::array<std::uint8_t, kMaxBatch> kinds;
    kernels.read_slots(source, materials, size, kinds.data());
    if (source.next > source.end) return tl::unexpected{DecodeError::truncated};
    for (std::size_t i = 0; i < size; ++i) {
      const MaterialId material{materials.value[kinds[i]]};
      MaterialId* const to = voxels.data() + filled;
      if (single) {
        *to = material;
        ++filled;
        continue;
      }
      if (lengths[i] > voxels.size() - filled) return tl::unexpected{DecodeError::bad_number};
      // Most runs are short: sixteen voxels are written unconditionally.
      std::fill_n(to, kVolumeMargin / 2, material);
      if (lengths[i] > kVolumeMargin / 2) std::fill_n(to, lengths[i], material);
      filled += lengths[i];
    }
  }
  if (filled != voxels.size()) return tl::unexpected{DecodeError::bad_number};
  if (source.next != source.end) return tl::unexpected{DecodeError::too_long};
  if (std::any_of(source.states.begin(), source.states.end(),
                  [](std::uint16_t state) { return state != kMinState; })) {
    return tl::unexpected{DecodeError::bad_ending};
  }
  return Chunk::from_dense(std::shared_ptr<const DenseVoxels>{padded, &voxels});
}

}  // namespace talus::codec
