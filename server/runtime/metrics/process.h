// Figures that the operating system reports about this process.
#pragma once

#include <cstdint>

namespace talus::server {

struct ProcessStats {
  double cpu_seconds = 0;
  double start_seconds = 0;  // since 1970
  std::uint64_t resident_bytes = 0;
  std::uint64_t virtual_bytes = 0;
  std::uint64_t open_descriptors = 0;
  std::uint64_t max_descriptors = 0;
  std::uint64_t threads = 0;
};

/// A field is 0 if /proc does not report it.
[[nodiscard]] ProcessStats read_process();

}  // namespace talus::server
