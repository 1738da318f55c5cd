// The fields of a pregen's frames, as socket_frames.h defines them.
#pragma once

#include <optional>
#include <span>

#include <talus/store/records.h>

#include "chunks/pregen.h"

namespace talus::server {

// Both replace the contents of `out`.
void encode(const PregenPlan& plan, store::Bytes& out);
void encode(const PregenProgress& progress, store::Bytes& out);

[[nodiscard]] std::optional<PregenPlan> decode_pregen_plan(std::span<const std::byte> fields);
[[nodiscard]] std::optional<PregenProgress> decode_pregen_progress(std::span<const std::byte> fields);

}  // namespace talus::server
