#include "chunks/generation/background_thread.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>

namespace talus::server {

void lower_priority() {
  // On Linux niceness is a thread's, against POSIX.
  const auto thread = static_cast<id_t>(::gettid());
  const int niceness = std::max(kBackgroundNiceness, ::getpriority(PRIO_PROCESS, thread));
  ::setpriority(PRIO_PROCESS, thread, niceness);
}

}  // namespace talus::server
