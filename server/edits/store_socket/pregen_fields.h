// The fields of the frames of a pregen: socket_frames.h has them.
#pragma once

#include <optional>
#include <span>

#include <talus/store/records.h>

#include "chunks/pregen.h"

namespace talus::server {

// Both replace what `out` holds.
void encode(const PregenPlan& plan, store::Bytes& out);
void encode(const PregenProgress& progress, store::Bytes& out);

[[nodiscard]] std::optional<PregenPlan> decode_pregen_plan(std::span<const std::byte> fields);
[[nodiscard]] std::optional<PregenProgress> decode_pregen_progress(std::span<const std::byte> fields);

}  // namespace talus::server
