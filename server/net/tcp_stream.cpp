#include "net/tcp_stream.h"

#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>

#include "net/stream.h"

namespace talus::server {

static_assert(Stream<TcpStream>);

void TcpStream::prefer_latency() {
  constexpr int kUnsentLowWaterBytes = 16 * 1024;
  std::error_code ignored;
  socket_.set_option(asio::ip::tcp::no_delay{true}, ignored);
  ::setsockopt(socket_.native_handle(), IPPROTO_TCP, TCP_NOTSENT_LOWAT, &kUnsentLowWaterBytes,
               sizeof(kUnsentLowWaterBytes));
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
