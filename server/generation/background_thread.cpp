#include "generation/background_thread.h"

#include <signal.h>
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

void block_signals() {
  sigset_t all;
  ::sigfillset(&all);
  ::pthread_sigmask(SIG_BLOCK, &all, nullptr);
}

}  // namespace talus::server
