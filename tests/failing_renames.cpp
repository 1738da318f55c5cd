#include "failing_renames.h"

#include <fcntl.h>

#include <atomic>
#include <cerrno>
#include <cstdint>
#include <cstdio>

namespace {

constexpr std::int64_t kNever = -1;
std::atomic<std::int64_t> left{kNever};  // until the rename that fails

}  // namespace

// In the place of the C library's, of libraries too.
extern "C" int rename(const char* from, const char* to) noexcept {
  if (left > kNever && left-- == 0) {
    errno = ENOSPC;
    return -1;
  }
  return ::renameat(AT_FDCWD, from, AT_FDCWD, to);
}

namespace talus::test {

FailingRenames::FailingRenames(std::size_t renames) {
  left = static_cast<std::int64_t>(renames);
}

bool FailingRenames::has_failed() const {
  return left == kNever;
}

FailingRenames::~FailingRenames() {
  left = kNever;
}

}  // namespace talus::test
