#include "edits/store_socket/pregen_fields.h"

#include <cmath>

#include <talus/store/bytes.h>

namespace talus::server {
namespace {

constexpr double kMillion = 1e6;

}  // namespace

void encode(const PregenPlan& plan, store::Bytes& out) {
  out.clear();
  store::ByteWriter writer{out};
  for (const std::int32_t number : {plan.x, plan.z, plan.radius}) {
    writer.fixed32(static_cast<std::uint32_t>(number));
  }
  writer.byte(static_cast<std::uint8_t>(plan.levels));
  writer.fixed32(static_cast<std::uint32_t>(std::lround(plan.share * kMillion)));
}

void encode(const PregenProgress& progress, store::Bytes& out) {
  out.clear();
  store::ByteWriter writer{out};
  for (const std::uint64_t number : {progress.squares, progress.of, progress.columns}) writer.varint(number);
}

std::optional<PregenPlan> decode_pregen_plan(std::span<const std::byte> fields) {
  store::ByteReader reader{fields};
  PregenPlan plan;
  for (std::int32_t* const number : {&plan.x, &plan.z, &plan.radius}) {
    *number = static_cast<std::int32_t>(reader.fixed32());
  }
  plan.levels = reader.byte();
  plan.share = reader.fixed32() / kMillion;
  return reader.ended() ? std::optional{plan} : std::nullopt;
}

std::optional<PregenProgress> decode_pregen_progress(std::span<const std::byte> fields) {
  store::ByteReader reader{fields};
  PregenProgress progress;
  for (std::uint64_t* const number : {&progress.squares, &progress.of, &progress.columns}) {
    *number = reader.varint();
  }
  return reader.ended() ? std::optional{progress} : std::nullopt;
}

}  // namespace talus::server
