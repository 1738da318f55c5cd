// Reasons for refusing a connection before it has a session.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace talus::server {

enum class Refusal : std::uint8_t {
  places,       // too many connections, in total or from its address
  memory,       // the memory budget is used up
  pace,         // its address opens connections too fast
  handshakes,   // too many handshakes in flight
  proxy,        // a proxy that sent no valid PROXY header
  descriptors,  // only spare descriptors are left
  blocked,      // its address is on the list of access.blocked_file
};
/// The label `reason` of talus_connections_refused_total.
inline constexpr std::array<std::string_view, 7> kRefusalNames{
    "places", "memory", "pace", "handshakes", "proxy", "descriptors", "blocked"};

}  // namespace talus::server
