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

}  // namespace talus::server
