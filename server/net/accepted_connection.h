// A connection that has passed the acceptor and the handshaker.
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
  std::string address;  // for the log: the client's own address if a proxy sent it
  Clock::time_point accepted;
  bool through_proxy = false;                 // the proxy's own connection: each request names its client
  std::optional<std::uint16_t> proxy_port{};  // Peer::proxy_port()
};

struct AcceptedConnection {
  ConnectionInfo info;
  Admission::Slot slot;
  std::variant<TcpStream, TlsStream> stream;
};

}  // namespace talus::server
