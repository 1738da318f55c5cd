#include "generation/background_thread.h"

#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

namespace talus::server {

void be_in_background() {
  // Sockets are served first where both want a core: what is at hand must not wait for what is being made.
  constexpr int kNiceness = 5;
  ::setpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()), kNiceness);  // of this thread alone, on Linux

  // Signals are for the main thread, which alone knows what they mean at the end.
  sigset_t all;
  ::sigfillset(&all);
  ::pthread_sigmask(SIG_BLOCK, &all, nullptr);
}

}  // namespace talus::server
