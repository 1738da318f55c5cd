// talus-http-load: GETs as fast as they are answered (a closed loop), on kept connections, so many deep. All
// must be answered by 200. It prints how many there were and how many bytes of bodies; who runs it measures
// the server.
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/epoll.h>
#include <sys/socket.h>

#include <array>
#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>
#include <string_view>
#include <vector>

namespace {

struct Plan {
  std::uint16_t port = 0;
  std::size_t connections = 0;
  std::size_t depth = 0;
  std::uint64_t requests = 0;
  std::vector<std::string> texts;  // of the requests, sent in turn
};

struct Connection {
  int socket = -1;
  std::string input;
  std::size_t in_flight = 0;
};

[[noreturn]] void fail(const std::string& why) {
  std::cerr << "talus-http-load: " << why << '\n';
  std::exit(1);
}

/// One answer from the front of `input`: how long all of it is, and its body. 0: it is not whole.
std::size_t answer_bytes(std::string_view input, std::size_t& body) {
  const std::size_t head = input.find("\r\n\r\n");
  if (head == std::string_view::npos) return 0;
  if (!input.starts_with("HTTP/1.1 200 ")) fail("an answer is " + std::string{input.substr(0, 40)});
  constexpr std::string_view kLength = "Content-Length: ";
  const std::size_t at = input.find(kLength);
  if (at > head) fail("an answer has no Content-Length");
  std::from_chars(input.data() + at + kLength.size(), input.data() + head, body);
  const std::size_t all = head + 4 + body;
  return input.size() < all ? 0 : all;
}

class Load {
 public:
  explicit Load(const Plan& plan) : plan_{plan}, epoll_{::epoll_create1(EPOLL_CLOEXEC)} {
    connections_.resize(plan.connections);
    for (std::size_t i = 0; i < connections_.size(); ++i) open(i);
  }

  void run() {
    for (Connection& each : connections_) ask(each);
    std::array<epoll_event, 64> events{};
    while (answered_ < plan_.requests) {
      const int count = ::epoll_wait(epoll_, events.data(), static_cast<int>(events.size()), 30'000);
      if (count <= 0) fail("the server is silent");
      for (int i = 0; i < count; ++i) take(connections_[events[static_cast<std::size_t>(i)].data.u64]);
    }
    std::cout << answered_ << " answers, " << bytes_ << " bytes of bodies\n";
  }

 private:
  void open(std::size_t i) {
    Connection& connection = connections_[i];
    connection.socket = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(plan_.port);
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    if (::connect(connection.socket, reinterpret_cast<const sockaddr*>(&address), sizeof(address)) != 0) {
      fail("no server listens on 127.0.0.1:" + std::to_string(plan_.port));
    }
    const int on = 1;
    ::setsockopt(connection.socket, IPPROTO_TCP, TCP_NODELAY, &on, sizeof(on));
    epoll_event event{EPOLLIN, {.u64 = i}};
    ::epoll_ctl(epoll_, EPOLL_CTL_ADD, connection.socket, &event);
  }

  /// Together, once all before are answered.
  void ask(Connection& connection) {
    std::string all;
    while (connection.in_flight < plan_.depth && asked_ < plan_.requests) {
      all += plan_.texts[asked_++ % plan_.texts.size()];
      ++connection.in_flight;
    }
    if (!all.empty() &&
        ::send(connection.socket, all.data(), all.size(), MSG_NOSIGNAL) != static_cast<ssize_t>(all.size())) {
      fail("the server closed a connection");
    }
  }

  void take(Connection& connection) {
    static std::array<char, 1 << 18> buffer;
    const ssize_t got = ::recv(connection.socket, buffer.data(), buffer.size(), 0);
    if (got <= 0) fail("the server closed a connection");
    connection.input.append(buffer.data(), static_cast<std::size_t>(got));
    std::string_view rest{connection.input};
    std::size_t body = 0;
    while (const std::size_t whole = answer_bytes(rest, body)) {
      rest.remove_prefix(whole);
      bytes_ += body;
      ++answered_;
      --connection.in_flight;
    }
    connection.input.erase(0, connection.input.size() - rest.size());
    if (connection.in_flight == 0) ask(connection);
  }

  const Plan& plan_;
  int epoll_;
  std::vector<Connection> connections_;
  std::uint64_t asked_ = 0;
  std::uint64_t answered_ = 0;
  std::uint64_t bytes_ = 0;
};

}  // namespace

int main(int argc, char** argv) {
  if (argc < 6) {
    std::cerr << "usage: talus-http-load PORT CONNECTIONS DEPTH REQUESTS FILE-OF-PATHS [FIELD...]\n";
    return 2;
  }
  Plan plan;
  plan.port = static_cast<std::uint16_t>(std::stoul(argv[1]));
  plan.connections = std::stoul(argv[2]);
  plan.depth = std::stoul(argv[3]);
  plan.requests = std::stoull(argv[4]);
  std::string fields = "\r\nHost: talus\r\n";
  for (int i = 6; i < argc; ++i) fields += std::string{argv[i]} + "\r\n";
  std::ifstream paths{argv[5]};
  for (std::string path; std::getline(paths, path);) {
    plan.texts.push_back("GET " + path + " HTTP/1.1" + fields + "\r\n");
  }
  if (plan.texts.empty()) fail(std::string{argv[5]} + " has no path");
  Load{plan}.run();
}
