// talus-http-floor: the least that a server can do for a GET by keep-alive, to compare others with: an epoll
// loop that answers each request with the same bytes, whatever it asks for.
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/epoll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <string_view>

namespace {

void watch(int epoll, int socket) {
  epoll_event event{EPOLLIN, {.fd = socket}};
  ::epoll_ctl(epoll, EPOLL_CTL_ADD, socket, &event);
}

/// False where the connection is over.
bool serve(int socket, const std::string& answer) {
  std::array<char, 4096> input;
  const ssize_t got = ::recv(socket, input.data(), input.size(), 0);
  if (got <= 0) return false;
  const std::string_view text{input.data(), static_cast<std::size_t>(got)};
  std::string output;
  for (std::size_t end = text.find("\r\n\r\n"); end != std::string_view::npos;
       end = text.find("\r\n\r\n", end + 4)) {
    output += answer;
  }
  return ::send(socket, output.data(), output.size(), MSG_NOSIGNAL) >= 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "usage: talus-http-floor PORT FILE-OF-THE-WHOLE-ANSWER\n";
    return 2;
  }
  std::ifstream file{argv[2], std::ios::binary};
  const std::string answer{std::istreambuf_iterator<char>{file}, {}};
  const int listener = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  const int on = 1;
  ::setsockopt(listener, SOL_SOCKET, SO_REUSEADDR, &on, sizeof(on));
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(std::stoul(argv[1])));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  if (::bind(listener, reinterpret_cast<const sockaddr*>(&address), sizeof(address)) != 0 ||
      ::listen(listener, 128) != 0) {
    std::cerr << "talus-http-floor: 127.0.0.1:" << argv[1] << " cannot be listened on\n";
    return 1;
  }
  const int epoll = ::epoll_create1(EPOLL_CLOEXEC);
  watch(epoll, listener);
  std::array<epoll_event, 64> events{};
  for (;;) {
    const int count = ::epoll_wait(epoll, events.data(), static_cast<int>(events.size()), -1);
    for (int i = 0; i < count; ++i) {
      const int socket = events[static_cast<std::size_t>(i)].data.fd;
      if (socket == listener) {
        const int accepted = ::accept4(listener, nullptr, nullptr, SOCK_CLOEXEC);
        ::setsockopt(accepted, IPPROTO_TCP, TCP_NODELAY, &on, sizeof(on));
        watch(epoll, accepted);
      } else if (!serve(socket, answer)) {
        ::close(socket);
      }
    }
  }
}
