#include "volume.h"

#include <algorithm>
#include <memory>

#include "header.h"
#include "material_code.h"
#include "volume_scalar.h"
#include "volume_tables.h"

namespace talus::codec {
namespace {

constexpr std::size_t kTables = kVolumeClasses.size();

constexpr std::size_t class_of_digit(char digit) {
  const int value = digit <= '9' ? digit - '0' : digit <= 'Z' ? digit - 'A' + 10 : digit - 'a' + 36;
  return static_cast<std::size_t>(value);
}

// The three tables that follow are constants everywhere but in a WebAssembly module, which would bring 12 kB
// of them compressed: it makes them when it starts.
#ifdef __wasm__
#define TALUS_TABLE const
void at_start() {}  // not constexpr: what calls it is no constant
#else
#define TALUS_TABLE constexpr
constexpr void at_start() {}
#endif

TALUS_TABLE std::array<VolumeIntervals, kTables> kIntervals = [] {
  at_start();
  std::array<VolumeIntervals, kTables> all{};
  for (std::size_t t = 0; t < kTables; ++t) {
    for (std::size_t c = 0; c < kVolumeContexts; ++c) {
      const auto& ends = kVolumeEnds[class_of_digit(kVolumeClasses[t][c])];
      all[t][c] = ends[0] | std::uint32_t{ends[1]} << 8U | std::uint32_t{ends[2]} << 16U;
    }
  }
  return all;
}();

TALUS_TABLE auto kSymbols = [] {
  at_start();
  std::array<VolumeSymbols, kTables> all{};
  for (std::size_t t = 0; t < kTables; ++t) {
    for (std::size_t c = 0; c < kVolumeContexts; ++c) {
      for (std::uint8_t symbol = 0; symbol < 4; ++symbol) {
        const Interval interval = interval_of(kIntervals[t][c], symbol);
        all[t].interval[4 * c + symbol] = interval.start | std::uint32_t{interval.size} << 16U;
      }
      all[t].ends[c] = static_cast<std::uint8_t>(class_of_digit(kVolumeClasses[t][c]));
    }
  }
  return all;
}();

/// Cost of a symbol whose interval has this size, in sixteenths of a bit: 16 * (8 - log2(size)), rounded down
/// digit by digit, so that every compiler computes the same.
constexpr std::uint16_t cost_of(std::uint32_t size) {
  double value = 256.0 / size;
  std::uint64_t cost = 0;
  while (value >= 2) {
    value /= 2;
    cost += 16;
  }
  for (std::uint64_t digit = 8; digit > 0; digit /= 2) {
    value *= value;
    if (value < 2) continue;
    value /= 2;
    cost += digit;
  }
  return static_cast<std::uint16_t>(cost);
}

/// Costs by table, for each context and symbol.
using TableCosts = std::array<std::uint16_t, kTables>;
TALUS_TABLE auto kCosts = [] {
  at_start();
  std::array<TableCosts, kVolumeContexts * 4> costs{};
  for (std::size_t c = 0; c < kVolumeContexts; ++c) {
    for (std::uint8_t symbol = 0; symbol < 4; ++symbol) {
      for (std::size_t t = 0; t < kTables; ++t) {
        costs[4 * c + symbol][t] = cost_of(interval_of(kIntervals[t][c], symbol).size);
      }
    }
  }
  return costs;
}();

#undef TALUS_TABLE

/// Returns the table that takes the fewest bits for every eighth coded voxel of each batch.
std::size_t best_table(const VolumeEvents& events) {
  constexpr std::size_t kStep = 8;
  constexpr std::size_t kMaxSamples = kMaxBatch / kStep;  // per batch
  // Collects these voxels, separately for even and odd batches, in loops with predictable ends: batches are
  // small and of all sizes.
  std::array<std::array<std::uint16_t, kChunkVolume / kStep / 2 + kBatches + kMaxSamples>, 2> samples;
  std::array<std::size_t, 2> counts{};
  std::size_t at = 0;
  for (std::size_t batch = 0; batch < kBatches; ++batch) {
    const std::size_t size = events.batch[batch];
    std::uint16_t* const to = samples[batch % 2].data() + counts[batch % 2];
    for (std::size_t i = 0; i < kMaxSamples; ++i) to[i] = static_cast<std::uint16_t>(at + i * kStep);
    counts[batch % 2] += (size + kStep - 1) / kStep;
    at += size;
  }
  constexpr std::size_t kSummed = 256;
  static_assert(kSummed * 128 < 0x10000);  // costs are at most 128
  std::array<std::uint32_t, kTables> totals{};
  for (const std::size_t half : {0U, 1U}) {
    const TableCosts* const costs = kCosts.data() + 4 * first_context_of(half);
    for (std::size_t begin = 0; begin < counts[half]; begin += kSummed) {
      TableCosts sums{};
      for (std::size_t i = begin; i < std::min(begin + kSummed, counts[half]); ++i) {
        const std::size_t voxel = samples[half][i];
        const TableCosts& cost = costs[4 * std::size_t{events.context[voxel]} + events.symbol[voxel]];
        for (std::size_t t = 0; t < kTables; ++t) sums[t] = static_cast<std::uint16_t>(sums[t] + cost[t]);
      }
      for (std::size_t t = 0; t < kTables; ++t) totals[t] += sums[t];
    }
  }
  return static_cast<std::size_t>(std::min_element(totals.begin(), totals.end()) - totals.begin());
}

/// start + 65536 * size, by number of digits of a gap.
constexpr std::array<std::uint32_t, kDigitCounts> kGapIntervals = [] {
  std::array<std::uint32_t, kDigitCounts> intervals{};
  std::uint32_t start = 0;
  for (std::size_t i = 0; i < kDigitCounts; ++i) {
    intervals[i] = start | std::uint32_t{kGapSizes[i]} << 16U;
    start += kGapSizes[i];
  }
  return intervals;
}();

void put_group(RansSink& sink, std::span<const VolumeException> group, const MaterialCode& materials,
               const VolumeKernels& kernels) {
  std::array<std::uint32_t, kLanes> intervals{};
  for (std::size_t i = 0; i < group.size(); ++i)
    intervals[i] = materials.interval(to_integer(group[i].material));
  kernels.write_intervals(intervals.data(), group.size(), sink);
  put_digits(sink, group.size(), [&](std::size_t i) { return std::uint32_t{group[i].gap}; });
  for (std::size_t i = 0; i < group.size(); ++i) {
    intervals[i] = kGapIntervals[static_cast<std::size_t>(std::bit_width(group[i].gap))];
  }
  kernels.write_intervals(intervals.data(), group.size(), sink);
}

/// Replaces the events' materials by their numbers. Returns false if there are too many.
bool number_materials(VolumeEvents& events, MaterialCode& materials) {
  const auto number = [&](MaterialId& material) {
    const std::uint32_t found = materials.number_of(material);
    if (found == MaterialCode::kMaxMaterials) return false;
    materials.count(found);
    material = MaterialId{static_cast<std::uint16_t>(found)};
    return true;
  };
  for (std::size_t i = 0; i < events.exceptions; ++i) {
    if (!number(events.exception[i].material)) return false;
  }
  for (std::size_t i = 0; i < events.escapes; ++i) {
    if (!number(events.escape[i])) return false;
  }
  return true;
}

constexpr std::size_t kGroupBytes = 4 * kLanes;
// One byte per escape of a batch, then one per symbol, then the groups of a batch.
constexpr std::size_t kMaxBytesAtOnce = kMaxBatch + kChunkVolume + (kMaxBatch / kLanes + 2) * kGroupBytes;

}  // namespace

const VolumeIntervals* volume_intervals(std::size_t table) {
  return table < kTables ? &kIntervals[table] : nullptr;
}

bool encode_volume(const DenseVoxels& voxels, std::vector<std::byte>& out, const VolumeKernels& kernels,
                   std::size_t* changes) {
  VolumeEvents events;  // on the stack, where only bytes written are touched; so is the buffer
  const bool orderly = kernels.analyse(voxels, events);
  if (changes != nullptr) *changes = orderly ? events.changes : 0;
  if (!orderly) return false;
  MaterialCode materials{voxels.front()};
  if (!number_materials(events, materials)) return false;
  const std::span exceptions{events.exception.data(), events.exceptions};
  const std::size_t begin = out.size();
  materials.finish(out);
  put_number(static_cast<std::uint16_t>(exceptions.size()), out);
  const std::size_t table = best_table(events);
  out.push_back(static_cast<std::byte>(table));

  std::array<std::uint8_t, sizeof(DenseVoxels) + kMaxBytesAtOnce + kStatesBytes + kScribbled> buffer;
  std::uint8_t* const end = buffer.data() + buffer.size();
  RansSink sink{{}, end};
  sink.states.fill(static_cast<std::uint16_t>(kMinState));
  std::size_t coded = events.coded;
  std::size_t escapes = events.escapes;
  std::size_t groups = (exceptions.size() + kLanes - 1) / kLanes;  // groups not yet written
  const auto group = [&](std::size_t g) {
    return exceptions.subspan(g * kLanes).first(std::min(kLanes, exceptions.size() - g * kLanes));
  };
  // A decoder reads the next group within the batch of a group's last exception, before its symbols.
  const auto group_follows = [&](std::size_t batch) {
    return groups > 1 && exceptions[(groups - 1) * kLanes - 1].batch == batch;
  };
  for (std::size_t batch = kBatches; batch > 0;) {
    const std::size_t count = events.batch_escapes[batch - 1];
    escapes -= count;
    for (std::size_t i = count; i-- > 0;) {
      encode_symbol(sink, i % kLanes, unpacked(materials.interval(to_integer(events.escape[escapes + i]))));
    }
    // Combine batches that have only symbols between them.
    EventBatches batches{batch, batch, coded, 0};
    do {
      batches.coded += events.batch[--batches.begin];
    } while (batches.begin > 0 && events.batch_escapes[batches.begin - 1] == 0 &&
             !group_follows(batches.begin));
    batch = batches.begin;
    coded -= batches.coded;
    batches.first_coded = coded;
    kernels.write(events, batches, kSymbols[table], sink);
    while (group_follows(batch)) {
      --groups;
      put_group(sink, group(groups), materials, kernels);
    }
    if (static_cast<std::size_t>(end - sink.next) >= sizeof(DenseVoxels)) {
      out.resize(begin);
      return false;
    }
  }
  if (groups == 1) put_group(sink, group(0), materials, kernels);
  put_states(sink);
  out.insert(out.end(), reinterpret_cast<const std::byte*>(sink.next),
             reinterpret_cast<const std::byte*>(end));
  if (out.size() - begin < sizeof(DenseVoxels)) return true;
  out.resize(begin);
  return false;
}

tl::expected<Chunk, DecodeError> decode_volume(std::span<const std::byte> body,
                                               const VolumeKernels& kernels) {
  VolumeCode code;
  const auto first = take_material_code(body, code.materials);
  if (!first) return tl::unexpected{first.error()};
  code.first = *first;
  const auto exceptions = take_number(body);
  if (!exceptions) return tl::unexpected{exceptions.error()};
  code.exceptions = *exceptions;
  if (body.size() < 1 + kStatesBytes) return tl::unexpected{DecodeError::truncated};
  const auto table = std::to_integer<std::size_t>(body.front());
  code.intervals = volume_intervals(table);
  if (code.intervals == nullptr) return tl::unexpected{DecodeError::bad_number};

  VolumeSource source;
  source.next = reinterpret_cast<const std::uint8_t*>(body.data()) + 1;
  source.end = source.next + body.size() - 1;
  if (!take_states(source)) return tl::unexpected{DecodeError::bad_ending};
  const auto padded = std::make_shared_for_overwrite<PaddedVoxels>();
  switch (kernels.read(source, code, *padded)) {
    case VolumeFault::none:
      break;
    case VolumeFault::truncated:
      return tl::unexpected{DecodeError::truncated};
    case VolumeFault::bad_number:
      return tl::unexpected{DecodeError::bad_number};
  }
  if (source.next != source.end) return tl::unexpected{DecodeError::too_long};
  if (std::any_of(source.states.begin(), source.states.end(),
                  [](std::uint16_t state) { return state != kMinState; })) {
    return tl::unexpected{DecodeError::bad_ending};
  }
  return Chunk::from_dense(std::shared_ptr<const DenseVoxels>{padded, &padded->voxels});
}

}  // namespace talus::codec
