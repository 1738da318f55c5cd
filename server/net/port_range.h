// A range of a balancer's ports.
#pragma once

#include <cstdint>

namespace talus::server {

/// Both ends included.
struct PortRange {
  std::uint16_t first = 0;
  std::uint16_t last = 0;
  bool operator==(const PortRange&) const = default;
  [[nodiscard]] bool contains(std::uint16_t port) const { return first <= port && port <= last; }
};

}  // namespace talus::server
