// A stream whose leader and replicas answer what a test says, on a nats-server without JetStream.
#pragma once

#include <cstdint>
#include <latch>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "cluster/jetstream/nats_handles.h"
#include "cluster/jetstream/stream_names.h"
#include "nats_server.h"

namespace talus::nats_test {

class ScriptedStream {
 public:
  struct Script {
    using Messages = std::map<std::uint64_t, std::string>;  // by number
    bool has_leader = true;
    Messages leader{};
    Messages replicas{};                                 // as any of them has them
    std::string replicas_time = "2026-01-01T00:00:00Z";  // which is the leader's
  };

  explicit ScriptedStream(server::jetstream::StreamNames names, NatsSettings settings = {});
  ~ScriptedStream();
  ScriptedStream(const ScriptedStream&) = delete;
  ScriptedStream& operator=(const ScriptedStream&) = delete;

  [[nodiscard]] std::string url() const { return servers_.url(0); }
  [[nodiscard]] const server::jetstream::StreamNames& names() const { return names_; }
  void set(Script script);
  /// How often replicas have been asked.
  [[nodiscard]] std::size_t asked_of_replicas() const;

 private:
  struct CloseConnection {
    void operator()(natsConnection* connection) const { natsConnection_Destroy(connection); }
  };
  static void ended(void* self);
  static void asked(natsConnection* connection, natsSubscription* subscription, natsMsg* message, void* self);
  void answer(natsConnection* connection, std::string_view subject, std::string_view text, const char* reply);

  server::jetstream::StreamNames names_;
  NatsServers servers_;
  std::latch subscriptions_end_{3};
  mutable std::mutex mutex_;
  Script script_;
  std::size_t asked_of_replicas_ = 0;
  std::unique_ptr<natsConnection, CloseConnection> connection_;
  std::vector<server::jetstream::NatsSubscription> subscriptions_;
};

}  // namespace talus::nats_test
