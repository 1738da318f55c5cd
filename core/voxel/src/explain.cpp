#include <talus/voxel/explain.h>

#include <array>
#include <memory>

#include <talus/voxel/codec.h>

#include "header.h"
#include "material_code.h"
#include "plane_scalar.h"
#include "volume.h"
#include "volume_scalar.h"

namespace talus {
namespace {

using namespace codec;

std::string text(std::uint64_t number) {
  return std::to_string(number);
}

std::string interval_text(Interval interval) {
  return text(interval.start) + " to " + text(interval.start + interval.size - 1U);
}

/// Walks through a payload and records the fields read.
class Explainer {
 public:
  Explainer(std::span<const std::byte> payload, std::size_t symbols)
      : payload_{payload}, rest_{payload}, symbols_left_{symbols} {}

  std::vector<PayloadField> explain() {
    const auto whole = decode(payload_);
    if (!payload_.empty()) walk();
    if (whole) {
      const std::size_t at = payload_.size();
      fields_.push_back({at, 0, "end", "the payload is a valid chunk"});
    } else {
      fields_.push_back({offset(), 0, "error", std::string{describe(whole.error())}});
    }
    return std::move(fields_);
  }

 private:
  [[nodiscard]] std::size_t offset() const { return payload_.size() - rest_.size(); }

  /// Records the bytes from `from` to the current position.
  void note(std::size_t from, std::string name, std::string meaning) {
    fields_.push_back({from, offset() - from, std::move(name), std::move(meaning)});
  }

  /// Returns false at the end of the payload.
  bool take_byte(unsigned& byte) {
    if (rest_.empty()) return false;
    byte = std::to_integer<unsigned>(rest_.front());
    rest_ = rest_.subspan(1);
    return true;
  }

  bool note_number(const std::string& name, std::uint32_t& number, const std::string& meaning) {
    const std::size_t from = offset();
    const auto taken = take_number(rest_);
    if (!taken) return false;
    number = *taken;
    note(from, name, text(number) + meaning);
    return true;
  }

  void walk() {
    unsigned version = 0;
    unsigned encoding = 0;
    (void)take_byte(version);
    note(0, "version", text(version));
    if (!take_byte(encoding)) return;
    const std::string key = text(version) + "." + text(encoding);
    struct FormatName {
      const char* key;
      const char* name;
    };
    static constexpr std::array kNames{FormatName{"3.0", "layered"}, FormatName{"4.1", "volume"},
                                       FormatName{"4.2", "raw"}, FormatName{"4.3", "runs"}};
    std::string name = "unknown";
    for (const FormatName& each : kNames) {
      if (key == each.key) name = each.name;
    }
    note(1, "encoding", text(encoding) + ": " + name);
    if (name == "layered") return walk_layered();
    if (name == "volume") return walk_volume();
    if (name == "runs") return walk_runs();
    const std::size_t from = offset();
    rest_ = {};
    if (name == "raw") note(from, "voxels", "ids of two bytes, low byte first, in dense order");
  }

  bool note_materials(std::uint32_t count) {
    for (std::uint32_t i = 0; i < count; ++i) {
      std::uint32_t id = 0;
      if (!note_number("material " + text(i), id, "")) return false;
    }
    return true;
  }

  bool note_states(RansSource& source) {
    if (rest_.size() < kStatesBytes) return false;
    source.next = reinterpret_cast<const std::uint8_t*>(rest_.data());
    source.end = source.next + rest_.size();
    const std::size_t from = offset();
    if (!take_states(source)) return false;
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      fields_.push_back({from + 2 * lane, 2, "state " + text(lane), text(source.states[lane])});
    }
    rest_ = rest_.subspan(kStatesBytes);
    return true;
  }

  /// The current position, even if `source` reads from a copy of the bytes.
  [[nodiscard]] std::size_t offset_of(const RansSource& source) const {
    return payload_.size() - static_cast<std::size_t>(source.end - source.next);
  }

  /// Records the bytes up to `from` as symbols that are not shown.
  void note_hidden(std::size_t from) {
    if (from > offset())
      fields_.push_back({offset(), from - offset(), "symbols", "of exceptions or escapes, not shown"});
  }

  /// Records a symbol read from `lane`, whose state was `state`, if more symbols are wanted.
  void note_symbol(const RansSource& source, std::size_t from, std::size_t lane, std::uint32_t state,
                   std::string name, const std::string& meaning) {
    if (symbols_left_ == 0 || source.next > source.end) return;
    --symbols_left_;
    note_hidden(from);
    fields_.push_back(
        {from, offset_of(source) - from, std::move(name),
         meaning + "; state " + text(lane) + " was " + text(state) + ", is " + text(source.states[lane])});
    rest_ = payload_.subspan(offset_of(source));
  }

  /// Records the remaining bytes as symbols that are not shown.
  void note_rest() {
    const std::size_t from = offset();
    rest_ = {};
    if (from < payload_.size()) note(from, "symbols", "the rest");
  }

  void walk_layered() {
    std::uint32_t count = 0;
    const std::size_t from = offset();
    const auto taken = take_number(rest_);
    if (!taken) return;
    count = *taken;
    const bool in_states = count > Layers::kMaxMaterials + 1 && count <= Layers::kMaxMaterials + kLanes;
    note(from, "count of materials",
         in_states ? text(count) + ": " + text(count - Layers::kMaxMaterials) +
                         ", whose ids are in the final states"
                   : text(count));
    if (!in_states && (!note_materials(count) || count < 2)) return;
    RansSource source;
    if (!note_states(source)) return;
    // Continue in a copy with room behind it, because reading looks ahead.
    std::vector<std::uint8_t> bytes(source.next, source.end);
    bytes.resize(bytes.size() + kReadAhead);
    source.next = bytes.data();
    source.end = bytes.data() + bytes.size() - kReadAhead;
    const std::size_t kinds = offset_of(source);
    bool fault = false;
    const std::uint32_t carried = take_carried(source, fault);
    if (source.next > source.end || fault) return;
    fields_.push_back({kinds, offset_of(source) - kinds, "carried rows of plane 0",
                       carried == 0 ? "none" : "bit z of " + text(carried)});
    rest_ = payload_.subspan(offset_of(source));
    // First row of the first plane, above a floor of 0.
    static constexpr std::array<std::uint8_t, kChunkArea> kFloorPlane{};
    const RowsBefore before = RowsBefore::of(nullptr, kFloorPlane.data(), 0, Steps{});
    Symbols symbols{};
    for (std::size_t at = 0; at < kChunkSize && source.next <= source.end; ++at) {
      const std::size_t x = at % kLanes * 2 + at / kLanes;
      const std::size_t lane = at % kLanes;
      const Starts starts = starts_of(before, kFirst, symbols, x);
      const std::uint32_t state = source.states[lane];
      const std::size_t from_byte = offset_of(source);
      const std::size_t symbol = decode_symbol(source, lane, starts.data());
      symbols[x] = static_cast<Symbol>(symbol);
      std::string meaning = "symbol " + text(symbol) + ", intervals from 0";
      for (std::size_t i = 1; i < 4; ++i) meaning += ", " + text(static_cast<std::uint32_t>(starts[i]));
      note_symbol(source, from_byte, lane, state, "plane 0, z 0, x " + text(x), meaning);
    }
    note_rest();
  }

  bool note_material_code(SlotTable& slots) {
    std::uint32_t count = 0;
    if (!note_number("count of materials", count, "")) return false;
    const std::span<const std::byte> whole = payload_.subspan(2);
    std::span<const std::byte> after = whole;
    if (!note_materials(count)) return false;
    const auto first = take_material_code(after, slots);
    if (!first) return false;
    first_material_ = to_integer(*first);
    std::uint32_t start = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
      const std::size_t from = offset();
      unsigned byte = 0;
      if (!take_byte(byte)) return false;
      note(from, "size " + text(i),
           "interval " +
               interval_text({static_cast<std::uint16_t>(start), static_cast<std::uint16_t>(byte + 1)}));
      start += byte + 1;
    }
    return true;
  }

  void walk_volume() {
    VolumeCode code;
    std::uint32_t exceptions = 0;
    if (!note_material_code(code.materials)) return;
    if (!note_number("count of exceptions", exceptions, "")) return;
    const std::size_t from = offset();
    unsigned table = 0;
    if (!take_byte(table)) return;
    note(from, "table", text(table));
    const VolumeIntervals* const intervals = volume_intervals(table);
    if (intervals == nullptr) return;
    VolumeSource source;
    if (!note_states(source)) return;
    code.first = MaterialId{first_material_};
    code.intervals = intervals;
    code.exceptions = exceptions;
    VolumeSource ahead = source;  // reads the exceptions of the first group, as decoding the voxels will
    note_group(ahead, code, std::min<std::size_t>(exceptions, kLanes));
    const auto voxels = std::make_unique<PaddedVoxels>();
    const auto see = [this](const RansSource& now, const VolumeSymbol& found) {
      const Interval interval = interval_of(found.ends, static_cast<std::uint8_t>(found.symbol));
      const std::size_t row = found.voxel / kChunkSize;
      note_symbol(now, payload_.size() - found.bytes_left, found.lane, found.state,
                  "voxel (" + text(found.voxel % kChunkSize) + ", " + text(row / kChunkSize) + ", " +
                      text(row % kChunkSize) + ")",
                  "context " + text(found.context) + ", symbol " + text(found.symbol) + ", interval " +
                      interval_text(interval));
    };
    (void)read_volume_scalar(source, code, *voxels, see);
    note_rest();
  }

  /// Records a group of exceptions.
  void note_group(VolumeSource& source, const VolumeCode& code, std::size_t size) {
    std::array<std::uint8_t, kLanes> digits;
    source.keep_ahead();
    for (std::size_t i = 0; i < size; ++i) {
      const std::uint32_t state = source.states[i];
      const std::size_t from = offset_of(source);
      digits[i] = static_cast<std::uint8_t>(decode_slot(source, i, kGapSlots));
      note_symbol(source, from, i, state, "exception " + text(i),
                  "its gap has " + text(digits[i]) + " digits");
    }
    if (size == 0 || source.next > source.end) return;
    const std::size_t from = offset_of(source);
    std::string gaps;
    take_digits(source, digits.data(), size,
                [&gaps](std::size_t, std::uint32_t gap) { gaps += (gaps.empty() ? "" : ", ") + text(gap); });
    if (source.next > source.end) return;
    note_hidden(from);
    fields_.push_back({from, offset_of(source) - from, "gaps", gaps});
    rest_ = payload_.subspan(offset_of(source));
    for (std::size_t i = 0; i < size && source.next <= source.end; ++i) {
      const std::uint32_t state = source.states[i];
      const std::size_t at = offset_of(source);
      const std::uint16_t id = decode_slot(source, i, code.materials);
      note_symbol(source, at, i, state, "exception " + text(i), "material " + text(id));
    }
  }

  void walk_runs() {
    SlotTable materials;
    if (!note_material_code(materials)) return;
    std::uint32_t count = 0;
    if (!note_number("count of runs", count, count == kChunkVolume ? ", each a voxel" : "")) return;
    if (count != kChunkVolume) {
      std::uint32_t start = 0;
      for (std::size_t i = 0; i < kDigitCounts; ++i) {
        const std::size_t from = offset();
        unsigned size = 0;
        if (!take_byte(size)) return;
        note(from, "size of " + text(i) + " digits",
             size == 0 ? "none"
                       : "interval " + interval_text({static_cast<std::uint16_t>(start),
                                                      static_cast<std::uint16_t>(size)}));
        start += size;
      }
    }
    RansSource source;
    if (note_states(source)) note_rest();
  }

  std::span<const std::byte> payload_;
  std::span<const std::byte> rest_;
  std::size_t symbols_left_;
  std::uint16_t first_material_ = 0;
  std::vector<PayloadField> fields_;
};

}  // namespace

std::vector<PayloadField> explain(std::span<const std::byte> payload, std::size_t symbols) {
  return Explainer{payload, symbols}.explain();
}

}  // namespace talus
