#include "net/descriptors.h"

#include <sys/resource.h>

#include <algorithm>

#include "net/refusals.h"

namespace talus::server {

bool is_spare(int descriptor) {
  rlimit limit{};
  if (getrlimit(RLIMIT_NOFILE, &limit) != 0) return false;
  return static_cast<rlim_t>(descriptor) + kSpareDescriptors >= limit.rlim_cur;
}

std::uint64_t descriptors_needed(std::uint64_t sockets, std::size_t io_contexts) {
  // For each io_context: its epoll, timer and event descriptors.
  constexpr std::uint64_t kPerContext = 3;
  // Standard streams, listening sockets, the signal pipe, the store, key files while they are read, and
  // descriptors opened by libraries.
  constexpr std::uint64_t kOwn = 32;
  return sockets + Refusals::kMax + kPerContext * io_contexts + kOwn + kSpareDescriptors;
}

namespace {

std::uint64_t set_limit(std::uint64_t wanted, bool lowers) {
  rlimit limit{};
  if (getrlimit(RLIMIT_NOFILE, &limit) != 0) return 0;
  const rlim_t least = lowers ? 0 : limit.rlim_cur;
  limit.rlim_cur = std::max(least, std::min<rlim_t>(wanted, limit.rlim_max));
  if (setrlimit(RLIMIT_NOFILE, &limit) != 0) getrlimit(RLIMIT_NOFILE, &limit);
  return limit.rlim_cur;
}

}  // namespace

std::uint64_t set_descriptor_limit(std::uint64_t wanted) {
  return set_limit(wanted, true);
}

std::uint64_t raise_descriptor_limit(std::uint64_t wanted) {
  return set_limit(wanted, false);
}

}  // namespace talus::server
