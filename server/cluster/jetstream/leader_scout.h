// By which NATS server a stream's leader answers.
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

/// Asks by connections of its own, which are closed again: a connection that stands is not given up before
/// another is known to be better. Of one thread at a time.
///
/// A look goes on by a thread that nobody waits for without end: a server that is reached and never ends its
/// TLS handshake holds libnats up for as long. Then there are no more looks.
class LeaderScout {
 public:
  /// A leader of another stream of the name, or of an older copy, is none.
  struct Wanted {
    std::int64_t created_ns = 0;  // 0: not known
    std::uint64_t last = 0;       // its last message, at least
  };

  LeaderScout(ServerUrls urls, std::shared_ptr<const Credentials> credentials, StreamNames names);
  /// Waits two seconds at most for a look that is on.
  ~LeaderScout();
  LeaderScout(const LeaderScout&) = delete;
  LeaderScout& operator=(const LeaderScout&) = delete;

  /// The first server by which the leader gives what it has and one of its messages, and hears a majority.
  /// Begins a look at all servers, one a second and after two minutes of them one each five, or waits for the
  /// one that is on; none where that takes longer than `patience`, which is for the next call to see, or none
  /// was found.
  [[nodiscard]] std::optional<ServerUrls> look(std::chrono::milliseconds patience, Wanted wanted);
  /// There is a leader: looks are frequent again.
  void rest() { looks_ = 0; }
  /// Whether a look is on, or has an end that look() has not told yet.
  [[nodiscard]] bool is_looking() const { return look_ != nullptr; }

 private:
  struct Look;

  ServerUrls urls_;
  std::shared_ptr<const Credentials> credentials_;
  StreamNames names_;
  std::size_t next_;
  std::size_t looks_ = 0;  // since there was a leader
  std::chrono::steady_clock::time_point looked_at_{};
  std::shared_ptr<Look> look_;  // that is on, or was not seen to end
};

}  // namespace talus::server::jetstream
