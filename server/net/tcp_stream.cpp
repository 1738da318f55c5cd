#include "net/tcp_stream.h"

#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>

#include <algorithm>
#include <climits>
#include <cstdint>

#include "net/stream.h"

namespace talus::server {

static_assert(Stream<TcpStream>);

namespace {

constexpr std::int64_t kMaxKeepAlive = 32'767;  // seconds, the system's limit

}  // namespace

void TcpStream::prefer_latency() {
  constexpr int kUnsentLowWaterBytes = 16 * 1024;
  std::error_code ignored;
  socket_.set_option(asio::ip::tcp::no_delay{true}, ignored);
  ::setsockopt(socket_.native_handle(), IPPROTO_TCP, TCP_NOTSENT_LOWAT, &kUnsentLowWaterBytes,
               sizeof(kUnsentLowWaterBytes));
}

void TcpStream::give_up_after(std::chrono::milliseconds silence) {
  const auto set = [&](int option, std::chrono::milliseconds::rep value) {
    const auto bounded = static_cast<int>(std::clamp<std::chrono::milliseconds::rep>(value, 1, INT_MAX));
    ::setsockopt(socket_.native_handle(), IPPROTO_TCP, option, &bounded, sizeof(bounded));
  };
  const auto seconds = std::chrono::ceil<std::chrono::seconds>(silence).count();
  std::error_code ignored;
  socket_.set_option(asio::socket_base::keep_alive{true}, ignored);
  set(TCP_KEEPIDLE, std::min<std::int64_t>(seconds / 2, kMaxKeepAlive));
  set(TCP_KEEPINTVL, std::min<std::int64_t>(seconds / 8, kMaxKeepAlive));
  set(TCP_USER_TIMEOUT, silence.count());
}

std::size_t TcpStream::write_now(asio::const_buffer from) {
  const ssize_t sent = ::send(socket_.native_handle(), from.data(), from.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
  return sent < 0 ? 0 : static_cast<std::size_t>(sent);
}

bool TcpStream::peer_has(short events) {
  pollfd peer{socket_.native_handle(), events, 0};
  return ::poll(&peer, 1, 0) > 0;
}

}  // namespace talus::server
