#include "cluster/jetstream/nats_threads.h"

#include <nats/nats.h>

namespace talus::server::jetstream {

NatsThreads::~NatsThreads() {
  constexpr int kPatienceMs = 2000;
  // Where no connection was ever made, or a thread hangs in the network, there is nothing to be done.
  (void)nats_CloseAndWait(kPatienceMs);
}

}  // namespace talus::server::jetstream
