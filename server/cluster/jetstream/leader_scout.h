// Finds a NATS server on which the stream's leader answers.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>

#include "cluster/jetstream/credentials.h"
#include "cluster/jetstream/stream_names.h"
#include "config/server_urls.h"

namespace talus::server::jetstream {

/// Probes on separate, short-lived connections: an existing connection is kept until a better one is known.
/// Used by one thread at a time.
///
/// The probe runs on a detached thread, because a server that never ends its TLS handshake blocks libnats for
/// as long. Until such a probe ends there is not another one.
class LeaderScout {
 public:
  /// A leader of another stream of the name, or of an older copy, is rejected.
  struct Requirement {
    std::int64_t created_ns = 0;  // 0: unknown
    std::uint64_t last = 0;       // minimum last message
  };

  LeaderScout(ServerUrls urls, std::shared_ptr<const Credentials> credentials, StreamNames names);
  /// Waits at most two seconds for a running probe.
  ~LeaderScout();
  LeaderScout(const LeaderScout&) = delete;
  LeaderScout& operator=(const LeaderScout&) = delete;

  /// Returns the first server on which the leader returns its state and one of its messages, and is in
  /// contact with a majority. Joins or starts a probe of all servers (at most one per second; one per five
  /// seconds after two minutes). nullopt if none was found within `patience`; the probe continues for the
  /// next call.
  [[nodiscard]] std::optional<ServerUrls> probe(std::chrono::milliseconds patience, Requirement wanted);
  /// There is a leader: probes may be frequent again.
  void rest() { probes_ = 0; }
  /// True if a probe runs, or its result was not returned yet.
  [[nodiscard]] bool is_probing() const { return probe_ != nullptr; }

 private:
  struct Probe;

  ServerUrls urls_;
  std::shared_ptr<const Credentials> credentials_;
  StreamNames names_;
  std::size_t next_;
  std::size_t probes_ = 0;  // since a leader was known
  std::chrono::steady_clock::time_point probed_at_{};
  std::shared_ptr<Probe> probe_;  // running, or result not returned yet
};

}  // namespace talus::server::jetstream
