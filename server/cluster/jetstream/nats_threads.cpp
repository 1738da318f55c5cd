#include "cluster/jetstream/nats_threads.h"

#include <nats/nats.h>

namespace talus::server::jetstream {

NatsThreads::~NatsThreads() {
  constexpr int kPatienceMs = 2000;
  // Ignores errors: no connection was ever opened, or a thread hangs in the network.
  (void)nats_CloseAndWait(kPatienceMs);
}

}  // namespace talus::server::jetstream
