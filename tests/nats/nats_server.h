// nats-server processes with JetStream, as one or three hosts of a cluster would run them.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "held_port.h"

namespace talus::nats_test {

/// What the servers are to be like.
struct NatsSettings {
  std::size_t servers = 3;
  bool jetstream = true;
  /// Lines of each server's configuration: "authorization { ... }", "tls { ... }", "max_payload: 64MB".
  std::string more{};
  /// Of urls(): "tls" where `more` has a tls block.
  std::string scheme = "nats";
};

/// Lines of a server's configuration: whoever says no name may do all, and the user "talus" what a talusd
/// must be allowed, but for what is false.
struct Permissions {
  bool messages = true;  // single ones
  bool tail = true;
  bool answers = true;
};
[[nodiscard]] std::string talusd_permissions(Permissions allowed = {});

/// Servers on ports of 127.0.0.1 that are theirs also while they are away, whose files lie in a scratch
/// directory. All of them end with the object, and with the thread that started them. What fails throws
/// std::runtime_error.
class NatsServers {
 public:
  /// Returns when all answer and, with JetStream, know each other: a stream can be made then.
  explicit NatsServers(NatsSettings settings = {});
  ~NatsServers();
  NatsServers(const NatsServers&) = delete;
  NatsServers& operator=(const NatsServers&) = delete;

  [[nodiscard]] std::size_t count() const { return servers_.size(); }
  /// "nats://127.0.0.1:22001"
  [[nodiscard]] std::string url(std::size_t server) const;
  [[nodiscard]] std::vector<std::string> urls() const;
  /// The same in one line, separated by commas, as the setting cluster.nats takes them.
  [[nodiscard]] std::string url_list() const;
  [[nodiscard]] std::uint16_t port(std::size_t server) const;

  /// SIGKILL; returns when it has ended.
  void kill(std::size_t server);
  /// SIGTERM; returns when it has ended.
  void end(std::size_t server);
  /// Runs a server again that has ended, on its ports, with its files. Returns when it answers, though it may
  /// know nobody yet; throws with what it says where it ends instead.
  void start(std::size_t server);
  /// Other lines in each server's configuration (NatsSettings::more); returns when all that run go by them.
  void reconfigure(std::string more);
  /// SIGSTOP: its connections stay and nothing answers. go_on(): SIGCONT.
  void freeze(std::size_t server);
  void go_on(std::size_t server);
  [[nodiscard]] bool runs(std::size_t server) const;
  /// Deletes the files of a server that has ended.
  void lose_files(std::size_t server);

  /// Waits until all that run, and are not frozen, know each other and a leader, and say that they are well.
  void await_ready(std::chrono::seconds patience = std::chrono::seconds{60}) const;
  /// The stream's leader, as the servers say. Waits until there is one.
  [[nodiscard]] std::size_t leader_of(const std::string& stream,
                                      std::chrono::seconds patience = std::chrono::seconds{60}) const;
  /// Waits until the stream has a leader and all of its replicas are as far as it.
  void await_replicas(const std::string& stream,
                      std::chrono::seconds patience = std::chrono::seconds{60}) const;
  /// What the server has logged.
  [[nodiscard]] std::string log(std::size_t server) const;
  /// The body of the monitoring page, such as "/jsz?streams=true"; empty where the server does not answer.
  [[nodiscard]] std::string page(std::size_t server, std::string_view path) const;

 private:
  struct Server {
    HeldPort port;
    HeldPort monitoring_port;
    HeldPort route_port;
    pid_t pid = -1;
    bool frozen = false;
  };

  void write_configurations() const;
  void launch(std::size_t server);
  void await_start(std::size_t server);
  void end_all();
  [[nodiscard]] bool know_each_other() const;
  [[nodiscard]] bool are_healthy() const;
  void await(const std::string& what, std::chrono::seconds patience, const std::function<bool()>& come) const;
  [[nodiscard]] std::filesystem::path file(std::size_t server, std::string_view ending) const;

  NatsSettings settings_;
  std::filesystem::path directory_;
  std::vector<Server> servers_;
};

}  // namespace talus::nats_test
