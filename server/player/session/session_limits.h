// The settings that sessions need. Filled by app/.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>

#include "edits/admission/edit_rules.h"

namespace talus::server {

/// A limit that Welcome contains has its type on the wire.
struct SessionLimits {
  std::uint32_t frame_bytes = 0;  // a frame from the client, with its prefix
  std::uint32_t requests_in_flight = 0;
  std::uint32_t heights_per_request = 0;
  std::uint64_t height_tiles_per_request = 0;  // tiles of 32 x 32 columns in one GetHeights; not in Welcome
  std::uint16_t view_horizontal_radius = 0;    // chunks
  std::uint16_t view_vertical_radius = 0;      // chunks
  std::uint32_t view_chunks = 0;
  std::uint64_t window_bytes = 0;
  std::size_t queued_bytes = 0;  // chunks queued for the client; not in Welcome
  std::chrono::milliseconds idle_timeout{};
  bool view_base = false;  // the world is published
  EditRules edits{};       // not in Welcome
};

}  // namespace talus::server
