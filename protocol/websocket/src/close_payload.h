// Payload of a Close frame. Source: RFC 6455, sections 5.5.1 and 7.4.
#pragma once

#include <cstddef>
#include <span>

#include <talus/websocket/frame_reader.h>

namespace talus::websocket {

/// End::closed, or the error in the payload.
[[nodiscard]] End end_by_close(std::span<const std::byte> payload);

}  // namespace talus::websocket
