// Waits for libnats' threads before the process exits.
#pragma once

namespace talus::server::jetstream {

/// Lives in main(), longer than all connections. Their threads run on for a moment after their destruction
/// and use OpenSSL, whose state is freed at exit: with TLS one exit in a hundred crashed. The destructor
/// waits for them, at most two seconds; not at all if there were none.
class NatsThreads {
 public:
  NatsThreads() = default;
  NatsThreads(const NatsThreads&) = delete;
  NatsThreads& operator=(const NatsThreads&) = delete;
  ~NatsThreads();
};

}  // namespace talus::server::jetstream
