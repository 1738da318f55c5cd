// A connection that came through the acceptor and the handshaker.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>

#include "net/admission.h"
#include "net/registry.h"
#include "net/tcp_stream.h"
#include "net/tls_stream.h"
#include "runtime/clock.h"

namespace talus::server {

struct ConnectionInfo {
  ConnectionId id{};
  std::string address;  // as the log names it; the client's own, where a proxy speaks for it
  Clock::time_point accepted;
  bool through_proxy = false;                 // a proxy's own: each request says whose it is
  std::optional<std::uint16_t> proxy_port{};  // Peer::proxy_port()
};

struct AcceptedConnection {
  ConnectionInfo info;
  Admission::Slot slot;
  std::variant<TcpStream, TlsStream> stream;
};

}  // namespace talus::server
