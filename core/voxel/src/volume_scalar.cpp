#include "volume_scalar.h"

#include <utility>

namespace talus::codec {
namespace {

using Row = std::array<MaterialId, kChunkSize>;

Row row_of(MaterialId material) {
  Row row;
  row.fill(material);
  return row;
}

/// Calls visit(y, z, x) for the voxels of a batch.
template <class Visit>
void over_batch(std::size_t batch, const Visit& visit) {
  const int wave = static_cast<int>(batch / 2);
  for (int y = first_row_of(wave); y <= last_row_of(wave); ++y) {
    for (int x = static_cast<int>(batch % 2); x < kChunkSize; x += 2) visit(y, wave - 2 * y, x);
  }
}

constexpr std::size_t row_index(int y, int z) {
  return static_cast<std::size_t>(y * kChunkSize + z) * kChunkSize;
}

}  // namespace

bool analyse_volume_scalar(const DenseVoxels& voxels, VolumeEvents& events) {
  events.coded = events.surprises = events.changes = events.exceptions = events.escapes = 0;
  const Row row_zero = row_of(voxels.front());
  std::uint16_t gap = 0;
  for (std::size_t batch = 0; batch < kBatches; ++batch) {
    const std::size_t coded = events.coded;
    const std::size_t escapes = events.escapes;
    over_batch(batch, [&](int y, int z, int x) {
      const MaterialId* const row = voxels.data() + row_index(y, z);
      const Prediction prediction = predict(rows_around(voxels.data(), row_zero.data(), y, z), row, x);
      events.changes += x > 0 && row[x] != row[x - 1] ? 1 : 0;
      if (prediction.steady) {
        if (row[x] == prediction.candidate[0]) {
          ++gap;
        } else {
          events.exception[events.exceptions++] = {std::exchange(gap, std::uint16_t{0}),
                                                   static_cast<std::uint16_t>(batch), row[x]};
        }
        return;
      }
      std::uint8_t symbol = 0;
      while (symbol < prediction.candidates && row[x] != prediction.candidate[symbol]) ++symbol;
      if (symbol == prediction.candidates) symbol = kEscape;
      if (symbol == kEscape) events.escape[events.escapes++] = row[x];
      events.context[events.coded] =
          static_cast<std::uint8_t>(static_cast<std::size_t>(prediction.context) - first_context_of(batch));
      events.symbol[events.coded++] = symbol;
      events.surprises += symbol != 0 && batch < 2 * kProbeWaves ? 1 : 0;
    });
    events.batch[batch] = static_cast<std::uint16_t>(events.coded - coded);
    events.batch_escapes[batch] = static_cast<std::uint16_t>(events.escapes - escapes);
    if (is_noise(batch + 1, events)) return false;
  }
  return true;
}

void write_volume_scalar(const VolumeEvents& events, const EventBatches& batches,
                         const VolumeSymbols& symbols, RansSink& sink) {
  std::size_t first = batches.first_coded + batches.coded;
  for (std::size_t batch = batches.end; batch-- > batches.begin;) {
    first -= events.batch[batch];
    for (std::size_t i = events.batch[batch]; i-- > 0;) {
      const std::size_t context = first_context_of(batch) + events.context[first + i];
      encode_symbol(sink, i % kLanes, unpacked(symbols.interval[4 * context + events.symbol[first + i]]));
    }
  }
}

void write_intervals_scalar(const std::uint32_t* intervals, std::size_t count, RansSink& sink) {
  for (std::size_t i = count; i-- > 0;) encode_symbol(sink, i % kLanes, unpacked(intervals[i]));
}

void read_slots_scalar(VolumeSource& source, const SlotTable& slots, std::size_t count, std::uint8_t* kinds) {
  for (std::size_t i = 0; i < count; ++i) {
    kinds[i] = static_cast<std::uint8_t>(slots.slot[source.states[i % kLanes] % kProbabilityTotal]);
    (void)decode_slot(source, i % kLanes, slots);
  }
}

VolumeFault read_volume_scalar(VolumeSource& source, const VolumeCode& code, PaddedVoxels& padded) {
  return read_volume_scalar(source, code, padded, {});
}

VolumeFault read_volume_scalar(VolumeSource& source, const VolumeCode& code, PaddedVoxels& padded,
                               const SeeSymbol& see) {
  DenseVoxels& voxels = padded.voxels;
  const Row row_zero = row_of(code.first);
  ExceptionReader exceptions{code, source};
  bool fault = false;
  for (std::size_t batch = 0; batch < kBatches; ++batch) {
    // Steady voxels first: an exception may read a group.
    std::array<std::uint16_t, kMaxBatch> coded;
    std::array<Prediction, kMaxBatch> predictions;
    std::size_t count = 0;
    over_batch(batch, [&](int y, int z, int x) {
      MaterialId* const row = voxels.data() + row_index(y, z);
      const Prediction prediction = predict(rows_around(voxels.data(), row_zero.data(), y, z), row, x);
      row[x] = prediction.candidate[0];
      if (!prediction.steady) {
        predictions[count] = prediction;
        coded[count++] = static_cast<std::uint16_t>(row_index(y, z) + static_cast<std::size_t>(x));
      } else if (exceptions.gap() == 0) {
        row[x] = MaterialId{code.materials.value[exceptions.take(source)]};
      } else {
        exceptions.pass(1);
      }
    });
    source.keep_ahead();
    std::array<std::uint16_t, kMaxBatch> escaped;
    std::size_t escapes = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const Prediction& prediction = predictions[i];
      const std::uint32_t ends = (*code.intervals)[static_cast<std::size_t>(prediction.context)];
      const std::array starts{0, static_cast<int>(ends & 0xFFU), static_cast<int>(ends >> 8U & 0xFFU),
                              static_cast<int>(ends >> 16U & 0xFFU), kProbabilityTotal};
      const std::size_t lane = i % kLanes;
      VolumeSymbol seen{coded[i],
                        static_cast<std::size_t>(prediction.context),
                        ends,
                        0,
                        lane,
                        source.states[lane],
                        static_cast<std::size_t>(source.end - source.next)};
      const std::size_t symbol = decode_symbol(source, lane, starts.data());
      seen.symbol = symbol;
      if (see) see(source, seen);
      if (symbol == kEscape) {
        escaped[escapes++] = coded[i];
      } else {
        fault |= symbol >= prediction.candidates;
        voxels[coded[i]] = prediction.candidate[std::min(symbol, prediction.candidates - 1)];
      }
    }
    for (std::size_t i = 0; i < escapes; ++i) {
      voxels[escaped[i]] = MaterialId{decode_slot(source, i % kLanes, code.materials)};
    }
    if (source.next > source.end) return VolumeFault::truncated;
    if (fault) return VolumeFault::bad_number;
  }
  return exceptions.all_taken() ? VolumeFault::none : VolumeFault::bad_number;
}

}  // namespace talus::codec
