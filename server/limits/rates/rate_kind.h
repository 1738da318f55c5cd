// The rates that an operator sets, by name.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace talus::server {

enum class RateKind : std::uint8_t {
  session_chunks,
  session_bytes,
  session_requests,
  address_chunks,
  address_bytes,
  address_requests,
  session_voxels,
  address_voxels,
  address_editors,
  address_new_chunks,
  gateway_requests,
  gateway_voxels
};

/// The keys of the rates in the section [rates] of the configuration, and their label in metrics.
inline constexpr std::array<std::string_view, 12> kRateNames{
    "session_chunks",  "session_bytes",      "session_requests", "address_chunks",
    "address_bytes",   "address_requests",   "session_voxels",   "address_voxels",
    "address_editors", "address_new_chunks", "gateway_requests", "gateway_voxels"};

[[nodiscard]] constexpr std::string_view name(RateKind kind) {
  return kRateNames[static_cast<std::size_t>(kind)];
}

}  // namespace talus::server
