// Bounds of the protocol. Settings may lower them. PROTOCOL.md explains each.
#pragma once

#include <cstdint>

namespace talus::protocol {

inline constexpr std::uint16_t kProtocolVersion = 2;  // newest supported version
inline constexpr std::uint16_t kOldestProtocol = 2;   // oldest supported version

/// Maximum frame from a client, prefix included: the default, and the lowest that a server may set.
inline constexpr std::uint32_t kDefaultClientFrameBytes = 64U * 1024;
inline constexpr std::uint32_t kMinClientFrameBytes = 4U * 1024;

/// Maximum frame before Welcome, prefix included: a Hello with the longest strings fits.
inline constexpr std::uint32_t kHelloFrameBytes = 16U * 1024;

/// Maximum frame from a server, prefix included: a raw chunk fits, and so do the heights of the largest
/// request. Clients reject longer frames.
inline constexpr std::uint32_t kServerFrameBytes = 256U * 1024;

/// Maximum columns of a GetHeights: at 16 bytes each, they fit the default frame from a client.
inline constexpr std::uint32_t kMaxHeightsPerRequest = 2048;

/// Maximum fields of a GetHeights, so that the answer for the most columns fits a frame.
inline constexpr std::uint32_t kMaxFieldsPerRequest = 16;

/// Maximum bytes of a file in a FilePart.
inline constexpr std::uint32_t kMaxFilePartBytes = 64U * 1024;

/// Maximum bytes of a client's strings (token, name).
inline constexpr std::uint32_t kMaxStringBytes = 4096;

}  // namespace talus::protocol
