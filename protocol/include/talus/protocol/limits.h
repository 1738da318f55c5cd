// Bounds of the protocol. The configuration may set lower ones. PROTOCOL.md explains each.
#pragma once

#include <cstdint>

namespace talus::protocol {

inline constexpr std::uint16_t kProtocolVersion = 2;  // newest version spoken
inline constexpr std::uint16_t kOldestProtocol = 1;   // oldest version still spoken
inline constexpr std::uint16_t kEditsProtocol =
    2;  // from which on a client may edit, and gets EditBroadcasts

/// Frames from a client, prefix included: the default, and the least that a server may set.
inline constexpr std::uint32_t kDefaultClientFrameBytes = 64U * 1024;
inline constexpr std::uint32_t kMinClientFrameBytes = 4U * 1024;
/// Its name in 0.1; goes with 0.3.
[[deprecated("its name is kMinClientFrameBytes")]] inline constexpr std::uint32_t kLeastClientFrameBytes =
    kMinClientFrameBytes;

/// A frame before Welcome, prefix included: Hello with the longest strings fits.
inline constexpr std::uint32_t kHelloFrameBytes = 16U * 1024;

/// Frames from a server, prefix included: a raw chunk fits, and so do the heights of the largest request. A
/// client refuses longer ones.
inline constexpr std::uint32_t kServerFrameBytes = 256U * 1024;

/// GetHeights columns per request: 16 bytes each, so the largest fits the default frame from a client.
inline constexpr std::uint32_t kMaxHeightsPerRequest = 2048;

/// GetHeights fields per request, so that the answer about the most columns fits a frame.
inline constexpr std::uint32_t kMaxFieldsPerRequest = 16;

/// Strings from a client (token, name), in bytes.
inline constexpr std::uint32_t kMaxStringBytes = 4096;

}  // namespace talus::protocol
