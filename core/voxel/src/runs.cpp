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

struct Run {
  std::uint16_t more;  // voxels after the first
  MaterialId material;
};

constexpr std::size_t kMaxGroupBytes = 5 * kLanes;

std::size_t digits_of(const Run& run) {
  return static_cast<std::size_t>(std::bit_width(run.more));
}

/// The sizes of the intervals of how many digits runs have. No interval is the whole range: it would not fit
/// a byte.
std::array<std::uint16_t, kDigitCounts> sizes_of(std::span<const Run> runs) {
  std::array<std::uint32_t, kDigitCounts> counts{};
  for (const Run& run : runs) ++counts[digits_of(run)];
  std::array<std::uint16_t, kDigitCounts> sizes;
  to_sizes(counts, sizes);
  const auto whole = std::find(sizes.begin(), sizes.end(), kProbabilityTotal);
  if (whole != sizes.end()) {
    --*whole;
    ++*(whole == sizes.begin() ? whole + 1 : sizes.begin());
  }
  return sizes;
}

std::size_t find_runs(const DenseVoxels& voxels, std::span<Run> runs) {
  std::size_t count = 0;
  std::size_t first = 0;
  for (std::size_t i = 1; i <= voxels.size(); ++i) {
    // Written in any case: that the material changes cannot be foreseen.
    runs[count] = {static_cast<std::uint16_t>(i - 1 - first), voxels[first]};
    const bool ends = i == voxels.size() || voxels[i] != voxels[i - 1];
    count += ends ? 1 : 0;
    first = ends ? i : first;
  }
  return count;
}

/// Runs so many that their lengths are worth less than they cost are written as single voxels.
constexpr std::size_t kManyRuns = 18'000;

class RunsEncoder {
 public:
  explicit RunsEncoder(std::size_t limit) : limit_{limit} {
    sink_.next = bytes_.data() + bytes_.size();
    sink_.states.fill(static_cast<std::uint16_t>(kMinState));
  }

  /// Writes the groups of runs, or single voxels where `digits` is null. False past the limit.
  bool write(std::span<const Run> runs, const std::array<Interval, kDigitCounts>* digits,
             const MaterialCode& materials, const VolumeKernels& kernels) {
    for (std::size_t left = runs.size(); left > 0;) {
      const std::size_t size = left % kLanes != 0 ? left % kLanes : kLanes;
      left -= size;
      const auto group = runs.subspan(left, size);
      std::array<std::uint32_t, kLanes> intervals;
      for (std::size_t i = 0; i < size; ++i) intervals[i] = materials.interval(to_integer(group[i].material));
      kernels.write_intervals(intervals.data(), size, sink_);
      if (digits != nullptr) {
        put_digits(sink_, size, [&](std::size_t i) { return std::uint32_t{group[i].more}; });
        for (std::size_t i = size; i-- > 0;) encode_symbol(sink_, i, (*digits)[digits_of(group[i])]);
      }
      if (this->size() >= limit_) return false;
    }
    put_states(sink_);
    return size() < limit_;
  }

  [[nodiscard]] std::span<const std::uint8_t> bytes() const { return {sink_.next, size()}; }

 private:
  [[nodiscard]] std::size_t size() const {
    return static_cast<std::size_t>(bytes_.data() + bytes_.size() - sink_.next);
  }

  std::size_t limit_;
  std::array<std::uint8_t, sizeof(DenseVoxels) + 2 * kMaxGroupBytes + kStatesBytes> bytes_;
  RansSink sink_;
};

}  // namespace

bool encode_runs(const DenseVoxels& voxels, std::size_t limit, std::vector<std::byte>& out,
                 const VolumeKernels& kernels) {
  std::array<Run, kChunkVolume + 1> buffer;  // on the stack, where only what is written is touched
  std::span<Run> runs{buffer.data(), find_runs(voxels, buffer)};
  const bool single = runs.size() > kManyRuns;
  if (single) {
    for (std::size_t i = 0; i < voxels.size(); ++i) buffer[i] = {0, voxels[i]};
    runs = {buffer.data(), voxels.size()};
  }
  // Materials become their numbers.
  MaterialCode materials{voxels.front()};
  for (Run& run : runs) {
    const std::uint32_t number = materials.number_of(run.material);
    if (number == MaterialCode::kMaxMaterials) return false;
    run.material = MaterialId{static_cast<std::uint16_t>(number)};
  }
  const std::size_t begin = out.size();
  materials.finish(out);
  put_number(static_cast<std::uint16_t>(runs.size()), out);
  std::array<Interval, kDigitCounts> digits{};
  if (!single) {
    const auto sizes = sizes_of(runs);
    std::uint16_t start = 0;
    for (std::size_t i = 0; i < kDigitCounts; ++i) {
      out.push_back(static_cast<std::byte>(sizes[i]));
      digits[i] = {start, sizes[i]};
      start = static_cast<std::uint16_t>(start + sizes[i]);
    }
  }
  const std::size_t header = out.size() - begin;
  RunsEncoder encoder{limit - std::min(limit, header)};
  if (!encoder.write(runs, single ? nullptr : &digits, materials, kernels)) {
    out.resize(begin);
    return false;
  }
  const auto* const bytes = reinterpret_cast<const std::byte*>(encoder.bytes().data());
  out.insert(out.end(), bytes, bytes + encoder.bytes().size());
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
    // Single voxels have no groups; they are read as many at once as a source allows.
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
      // Most runs are short: sixteen voxels are written in any case.
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
