// By which NATS server a stream's leader answers.
#pragma once

#include <chrono>
#include <cstddef>
#include <memory>
#include <optional>

#include "config/server_urls.h"
#include "jetstream/credentials.h"
#include "jetstream/stream_names.h"

namespace talus::server::jetstream {

/// Asks by connections of its own, which are closed again: a connection that stands is not given up before
/// another is known to be better. Of one thread at a time.
class LeaderScout {
 public:
  /// For unreachable servers; one that is reached may take two answers' time more.
  static constexpr std::chrono::milliseconds kPatience{500};

  LeaderScout(ServerUrls urls, std::shared_ptr<const Credentials> credentials, StreamNames names);

  /// The first server by which the leader gives what it has and one of its messages, and hears a
  /// majority. Goes on where the last look ended; none where all or the time have passed.
  [[nodiscard]] std::optional<ServerUrls> look();

 private:
  [[nodiscard]] bool answers_by(const ServerUrls& server) const;

  ServerUrls urls_;
  std::shared_ptr<const Credentials> credentials_;
  StreamNames names_;
  std::size_t next_;
};

}  // namespace talus::server::jetstream
