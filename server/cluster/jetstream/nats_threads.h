// The end of libnats' own threads, before the process's.
#pragma once

namespace talus::server::jetstream {

/// Lives in main(), beyond all connections. They have threads that go on for a moment after they are
/// destroyed, and call OpenSSL, which frees what it has when the process exits: who ends by TLS then crashed
/// once in a hundred times. So its end waits for theirs, at most two seconds; at once where there were none.
class NatsThreads {
 public:
  NatsThreads() = default;
  NatsThreads(const NatsThreads&) = delete;
  NatsThreads& operator=(const NatsThreads&) = delete;
  ~NatsThreads();
};

}  // namespace talus::server::jetstream
