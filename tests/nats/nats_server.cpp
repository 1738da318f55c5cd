#include "nats_server.h"

#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <poll.h>
#include <stdlib.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>
#include <csignal>

#include <array>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <thread>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace talus::nats_test {
namespace {

constexpr std::chrono::milliseconds kPollInterval{10};
constexpr int kPageTimeoutMs = 1000;
constexpr std::chrono::seconds kPatience{60};

sockaddr_in loopback(std::uint16_t port) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  return address;
}

/// A socket that closes itself.
class Socket {
 public:
  explicit Socket(int flags) : fd_{::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC | flags, 0)} {}
  ~Socket() { ::close(fd_); }
  Socket(const Socket&) = delete;
  Socket& operator=(const Socket&) = delete;
  [[nodiscard]] int fd() const { return fd_; }

 private:
  int fd_;
};

std::filesystem::path scratch_directory() {
  std::string pattern = (std::filesystem::temp_directory_path() / "talus-nats-XXXXXX").string();
  if (::mkdtemp(pattern.data()) == nullptr) throw std::runtime_error{"cannot make " + pattern};
  return pattern;
}

bool wait_for(int fd, short what) {
  pollfd waiting{fd, what, 0};
  return ::poll(&waiting, 1, kPageTimeoutMs) == 1;
}

std::string http_get(std::uint16_t port, std::string_view path) {
  const Socket socket{SOCK_NONBLOCK};
  const sockaddr_in address = loopback(port);
  if (::connect(socket.fd(), reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0 &&
      (errno != EINPROGRESS || !wait_for(socket.fd(), POLLOUT))) {
    return {};
  }
  const std::string request = fmt::format("GET {} HTTP/1.0\r\n\r\n", path);
  if (::send(socket.fd(), request.data(), request.size(), MSG_NOSIGNAL) !=
      static_cast<ssize_t>(request.size())) {
    return {};
  }
  std::string answer;
  std::array<char, 65'536> buffer{};
  for (;;) {
    if (!wait_for(socket.fd(), POLLIN)) return {};
    const ssize_t bytes = ::recv(socket.fd(), buffer.data(), buffer.size(), 0);
    if (bytes < 0) return {};
    if (bytes == 0) break;
    answer.append(buffer.data(), static_cast<std::size_t>(bytes));
  }
  const std::size_t body = answer.find("\r\n\r\n");
  return body == std::string::npos ? std::string{} : answer.substr(body + 4);
}

/// Whether a NATS server greets whoever connects.
bool greets(std::uint16_t port) {
  const Socket socket{SOCK_NONBLOCK};
  const sockaddr_in address = loopback(port);
  if (::connect(socket.fd(), reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0 &&
      (errno != EINPROGRESS || !wait_for(socket.fd(), POLLOUT))) {
    return false;
  }
  char first = 0;
  return wait_for(socket.fd(), POLLIN) && ::recv(socket.fd(), &first, 1, 0) == 1 && first == 'I';
}

nlohmann::json parsed(const std::string& text) {
  return nlohmann::json::parse(text, nullptr, false);
}

/// What the servers' page says of a stream; null where no server knows it.
nlohmann::json stream_of(const nlohmann::json& page, const std::string& stream) {
  if (!page.is_object()) return {};
  for (const auto& account : page.value("account_details", nlohmann::json::array())) {
    for (const auto& each : account.value("stream_detail", nlohmann::json::array())) {
      if (each.value("name", "") == stream) return each;
    }
  }
  return {};
}

}  // namespace

std::string talusd_permissions(Permissions allowed) {
  // An empty list would allow all.
  return fmt::format(
      "no_auth_user: all\nauthorization {{ users = [ {{ user: all, password: p }}, {{ user: talus, password: "
      "p, permissions: {{ publish: [\"talus.*.log\", \"$JS.API.STREAM.INFO.*\"{}], subscribe: "
      "[\"nothing\"{}{}] }} }} ] }}",
      allowed.messages ? ", \"$JS.API.STREAM.MSG.GET.*\"" : "", allowed.tail ? ", \"talus.*.tail\"" : "",
      allowed.answers ? ", \"_INBOX.>\"" : "");
}

NatsServers::NatsServers(NatsSettings settings)
    : settings_{std::move(settings)}, directory_{scratch_directory()} {
  servers_.resize(settings_.servers);
  write_configurations();
  try {
    for (std::size_t server = 0; server < count(); ++server) launch(server);
    for (std::size_t server = 0; server < count(); ++server) await_start(server);
    await_ready();
  } catch (...) {
    end_all();
    throw;
  }
}

NatsServers::~NatsServers() {
  end_all();
}

void NatsServers::end_all() {
  for (std::size_t server = 0; server < count(); ++server) kill(server);
  std::error_code ignored;
  std::filesystem::remove_all(directory_, ignored);
}

std::filesystem::path NatsServers::file(std::size_t server, std::string_view ending) const {
  return directory_ / fmt::format("n{}{}", server + 1, ending);
}

void NatsServers::write_configurations() const {
  std::string routes;
  for (const Server& server : servers_) {
    routes +=
        fmt::format("{}nats-route://127.0.0.1:{}", routes.empty() ? "" : ", ", server.route_port.number());
  }
  for (std::size_t i = 0; i < count(); ++i) {
    const Server& server = servers_[i];
    std::ofstream out{file(i, ".conf")};
    out << fmt::format(
        "server_name: n{}\nlisten: 127.0.0.1:{}\nhttp: 127.0.0.1:{}\nlog_file: \"{}\"\n"
        "ping_interval: 2\nping_max: 2\n",
        i + 1, server.port.number(), server.monitoring_port.number(), file(i, ".log").string());
    if (settings_.jetstream) {
      // What a stream may grow to is not what the disk has.
      out << fmt::format(
          "jetstream {{ store_dir: \"{}\", max_memory_store: 256MB, max_file_store: 256GB }}\n",
          file(i, "").string());
    }
    if (count() > 1) {
      out << fmt::format("cluster {{ name: talus, listen: 127.0.0.1:{}, routes: [{}] }}\n",
                         server.route_port.number(), routes);
    }
    out << settings_.more << '\n';
    if (!out.flush()) throw std::runtime_error{"cannot write a configuration of nats-server"};
  }
}

void NatsServers::start(std::size_t server) {
  launch(server);
  await_start(server);
}

void NatsServers::launch(std::size_t server) {
  const std::string configuration = file(server, ".conf").string();
  const std::string log = file(server, ".err").string();
  const std::array<const char*, 4> arguments{"nats-server", "-c", configuration.c_str(), nullptr};
  const pid_t child = ::fork();
  if (child < 0) throw std::runtime_error{"cannot start nats-server: fork fails"};
  if (child == 0) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    sigset_t none;
    ::sigemptyset(&none);
    ::sigprocmask(SIG_SETMASK, &none, nullptr);
    const int out = ::open(log.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0600);
    ::dup2(out, STDOUT_FILENO);
    ::dup2(out, STDERR_FILENO);
    ::execvp("nats-server", const_cast<char* const*>(arguments.data()));
    ::_exit(127);
  }
  servers_[server].pid = child;
  servers_[server].frozen = false;
}

void NatsServers::await_start(std::size_t server) {
  bool ended = false;
  await("nats-server", kPatience, [&] {
    ended = ::waitpid(servers_[server].pid, nullptr, WNOHANG) == servers_[server].pid;
    return ended || (!page(server, "/varz").empty() && greets(port(server)));
  });
  if (!ended) return;
  servers_[server].pid = -1;
  throw std::runtime_error{"nats-server does not start:\n" + log(server)};
}

void NatsServers::kill(std::size_t server) {
  if (!runs(server)) return;
  ::kill(servers_[server].pid, SIGKILL);
  ::waitpid(std::exchange(servers_[server].pid, -1), nullptr, 0);
}

void NatsServers::end(std::size_t server) {
  if (!runs(server)) return;
  ::kill(servers_[server].pid, SIGTERM);
  ::waitpid(std::exchange(servers_[server].pid, -1), nullptr, 0);
}

void NatsServers::reconfigure(std::string more) {
  settings_.more = std::move(more);
  write_configurations();
  const auto reloads = [this](std::size_t server) {
    constexpr std::string_view kDone = "Reloaded server configuration";
    const std::string text = log(server);
    std::size_t count = 0;
    for (std::size_t at = text.find(kDone); at != std::string::npos; at = text.find(kDone, at + 1)) ++count;
    return count;
  };
  for (std::size_t server = 0; server < count(); ++server) {
    if (!runs(server)) continue;
    const std::size_t before = reloads(server);
    ::kill(servers_[server].pid, SIGHUP);
    await("a configuration that is read again", kPatience, [&] { return reloads(server) > before; });
  }
}

void NatsServers::freeze(std::size_t server) {
  ::kill(servers_[server].pid, SIGSTOP);
  // Returns when it stands still.
  ::waitpid(servers_[server].pid, nullptr, WUNTRACED);
  servers_[server].frozen = true;
}

void NatsServers::go_on(std::size_t server) {
  ::kill(servers_[server].pid, SIGCONT);
  servers_[server].frozen = false;
}

bool NatsServers::runs(std::size_t server) const {
  return servers_[server].pid > 0;
}

void NatsServers::lose_files(std::size_t server) {
  std::filesystem::remove_all(file(server, ""));
}

std::string NatsServers::url(std::size_t server) const {
  return fmt::format("{}://127.0.0.1:{}", settings_.scheme, port(server));
}

std::vector<std::string> NatsServers::urls() const {
  std::vector<std::string> all;
  for (std::size_t server = 0; server < count(); ++server) all.push_back(url(server));
  return all;
}

std::string NatsServers::url_list() const {
  return fmt::format("{}", fmt::join(urls(), ","));
}

std::uint16_t NatsServers::port(std::size_t server) const {
  return servers_[server].port.number();
}

std::string NatsServers::page(std::size_t server, std::string_view path) const {
  return http_get(servers_[server].monitoring_port.number(), path);
}

std::string NatsServers::log(std::size_t server) const {
  std::string text;
  for (const std::string_view ending : {".err", ".log"}) {
    std::ifstream in{file(server, ending)};
    text.append(std::istreambuf_iterator<char>{in}, {});
  }
  return text;
}

bool NatsServers::know_each_other() const {
  std::size_t running = 0;
  for (const Server& server : servers_) running += server.pid > 0 && !server.frozen ? 1 : 0;
  bool led = false;
  for (std::size_t server = 0; server < count(); ++server) {
    if (!runs(server) || servers_[server].frozen) continue;
    const nlohmann::json said = parsed(page(server, settings_.jetstream ? "/jsz" : "/varz"));
    if (!said.is_object() || !greets(port(server))) return false;
    if (!settings_.jetstream || count() == 1) continue;
    const nlohmann::json meta = said.value("meta_cluster", nlohmann::json::object());
    if (meta.value("leader", "").empty()) return false;
    if (meta.value("leader", "") != fmt::format("n{}", server + 1)) continue;
    std::size_t current = 1;
    for (const auto& peer : meta.value("replicas", nlohmann::json::array())) {
      current += peer.value("current", false) && !peer.value("offline", false) ? 1 : 0;
    }
    led = current >= running;
  }
  return led || !settings_.jetstream || count() == 1;
}

void NatsServers::await(const std::string& what, std::chrono::seconds patience,
                        const std::function<bool()>& come) const {
  const auto patience_ends = std::chrono::steady_clock::now() + patience;
  while (!come()) {
    if (std::chrono::steady_clock::now() > patience_ends) {
      std::string said;
      for (std::size_t server = 0; server < count(); ++server) said += log(server);
      throw std::runtime_error{"waited in vain for " + what + ":\n" + said};
    }
    std::this_thread::sleep_for(kPollInterval);
  }
}

void NatsServers::await_ready(std::chrono::seconds patience) const {
  await("servers that know each other", patience, [&] { return know_each_other() && are_healthy(); });
}

bool NatsServers::are_healthy() const {
  for (std::size_t server = 0; server < count(); ++server) {
    if (!runs(server) || servers_[server].frozen) continue;
    if (page(server, "/healthz").find("ok") == std::string::npos) return false;
  }
  return true;
}

std::size_t NatsServers::leader_of(const std::string& stream, std::chrono::seconds patience) const {
  std::size_t found = 0;
  await("a leader of " + stream, patience, [&] {
    for (std::size_t server = 0; server < count(); ++server) {
      if (!runs(server) || servers_[server].frozen) continue;
      if (count() == 1) return true;
      const nlohmann::json said = stream_of(parsed(page(server, "/jsz?streams=true")), stream);
      if (said.is_null()) continue;
      // Only the leader's word counts: others may still name the one before.
      if (said.value("/cluster/leader"_json_pointer, "") != fmt::format("n{}", server + 1)) continue;
      found = server;
      return true;
    }
    return false;
  });
  return found;
}

void NatsServers::await_replicas(const std::string& stream, std::chrono::seconds patience) const {
  await("current replicas of " + stream, patience, [&] {
    const std::size_t leader = leader_of(stream, patience);
    const nlohmann::json said = stream_of(parsed(page(leader, "/jsz?streams=true")), stream);
    if (said.is_null()) return false;
    for (const auto& peer : said.value("/cluster/replicas"_json_pointer, nlohmann::json::array())) {
      if (!peer.value("current", false) || peer.value("offline", false) || peer.value("lag", 0) > 0)
        return false;
    }
    return true;
  });
}

}  // namespace talus::nats_test
