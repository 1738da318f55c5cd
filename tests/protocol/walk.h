// Reads every field of a message, so that a sanitizer sees what a careless reader would touch.
#pragma once

#include <cstdint>

#include <talus/protocol/message.h>

namespace talus::protocol::testing {

/// A digest of all fields of a verified message. Equal messages have equal digests.
[[nodiscard]] std::uint64_t walk(const wire::Message& message);

}  // namespace talus::protocol::testing
