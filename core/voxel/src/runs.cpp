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

constexpr std::size_t kBytesOfGroup = 5 * kLanes;

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
    const bool ends = i == voxels.size() || voxels[i] != voxels[first];
    count += ends ? 1 : 0;
    first = ends ? i : first;
  }
  return count;
}

}  // namespace

bool encode_runs(const DenseVoxels& voxels, std::size_t limit, std::vector<std::byte>& out) {
  std::array<Run, kChunkVolume + 1> buffer;  // on the stack, where only what is written is touched
  const std::span runs{buffer.data(), find_runs(voxels, buffer)};
  MaterialCode materials{voxels.front()};
  for (const Run& run : runs) {
    if (!materials.add(run.material)) return false;
  }
  const std::size_t begin = out.size();
  materials.finish(out);
  const auto sizes = sizes_of(runs);
  std::array<Interval, kDigitCounts> digits;
  std::uint16_t start = 0;
  for (std::size_t i = 0; i < kDigitCounts; ++i) {
    out.push_back(static_cast<std::byte>(sizes[i]));
    digits[i] = {start, sizes[i]};
    start = static_cast<std::uint16_t>(start + sizes[i]);
  }
  put_number(static_cast<std::uint16_t>(runs.size()), out);

  std::array<std::uint8_t, sizeof(DenseVoxels) + 2 * kBytesOfGroup + kStatesBytes> bytes;
  std::uint8_t* const end = bytes.data() + bytes.size();
  RansSink sink{{}, end};
  sink.states.fill(static_cast<std::uint16_t>(kMinState));
  const auto size = [&] { return out.size() - begin + static_cast<std::size_t>(end - sink.next); };
  for (std::size_t g = (runs.size() + kLanes - 1) / kLanes; g-- > 0 && size() < limit;) {
    const auto group = runs.subspan(g * kLanes, std::min(kLanes, runs.size() - g * kLanes));
    for (std::size_t i = group.size(); i-- > 0;)
      encode_symbol(sink, i, materials.interval(group[i].material));
    put_digits(sink, group.size(), [&](std::size_t i) { return std::uint32_t{group[i].more}; });
    for (std::size_t i = group.size(); i-- > 0;) encode_symbol(sink, i, digits[digits_of(group[i])]);
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

tl::expected<Chunk, DecodeError> decode_runs(std::span<const std::byte> body) {
  SlotTable materials;
  if (const auto first = take_material_code(body, materials); !first) return tl::unexpected{first.error()};
  if (body.size() < kDigitCounts) return tl::unexpected{DecodeError::truncated};
  std::array<std::uint16_t, kDigitCounts> sizes;
  std::size_t sum = 0;
  for (std::size_t i = 0; i < kDigitCounts; ++i) {
    sizes[i] = std::to_integer<std::uint16_t>(body[i]);
    sum += sizes[i];
  }
  if (sum != kProbabilityTotal) return tl::unexpected{DecodeError::bad_number};
  const SlotTable digits = slots_of(sizes);
  body = body.subspan(kDigitCounts);
  const auto count = take_number(body);
  if (!count) return tl::unexpected{count.error()};
  if (body.size() < kStatesBytes) return tl::unexpected{DecodeError::truncated};

  VolumeSource source;
  source.next = reinterpret_cast<const std::uint8_t*>(body.data());
  source.end = source.next + body.size();
  if (!take_states(source)) return tl::unexpected{DecodeError::bad_ending};
  const auto padded = std::make_shared_for_overwrite<PaddedVoxels>();
  DenseVoxels& voxels = padded->voxels;
  std::size_t filled = 0;
  for (std::size_t left = *count; left > 0;) {
    const std::size_t size = std::min(left, kLanes);
    left -= size;
    source.keep_ahead();
    std::array<std::uint8_t, kLanes> digit_counts;
    for (std::size_t i = 0; i < size; ++i) {
      digit_counts[i] = static_cast<std::uint8_t>(decode_slot(source, i, digits));
    }
    std::array<std::uint32_t, kLanes> lengths;
    take_digits(source, digit_counts.data(), size,
                [&lengths](std::size_t i, std::uint32_t more) { lengths[i] = more + 1; });
    for (std::size_t i = 0; i < size; ++i) {
      const MaterialId material{decode_slot(source, i, materials)};
      if (lengths[i] > voxels.size() - filled) {
        return tl::unexpected{source.next > source.end ? DecodeError::truncated : DecodeError::bad_number};
      }
      // Most runs are short: sixteen voxels are written in any case.
      MaterialId* const to = voxels.data() + filled;
      std::fill_n(to, kVolumeMargin / 2, material);
      if (lengths[i] > kVolumeMargin / 2) std::fill_n(to, lengths[i], material);
      filled += lengths[i];
    }
    if (source.next > source.end) return tl::unexpected{DecodeError::truncated};
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
