// Takes a new connection to the beginning of its session: the PROXY header that names the client, admission,
// the rate of its address, and TLS.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <asio/awaitable.hpp>
#include <asio/ip/tcp.hpp>

#include <talus/protocol/message.h>

#include "config/access/access_control.h"
#include "config/networks.h"
#include "limits/flows/flow_uses.h"
#include "limits/memory/memory_budget.h"
#include "net/accepted_connection.h"
#include "net/admission.h"
#include "net/connection_rate_limiter.h"
#include "net/refusal_log.h"
#include "net/refusal_reason.h"
#include "net/refusals.h"
#include "net/tls_context.h"
#include "runtime/clock.h"
#include "runtime/log/logger.h"
#include "runtime/metrics/metrics.h"

namespace talus::server {

struct HandshakeSettings {
  std::uint64_t per_address_per_second = 1;
  std::uint64_t per_address_burst = 1;
  std::uint64_t max_in_flight = 1;  // connections with a PROXY header or TLS
  std::chrono::milliseconds timeout{};
  Networks proxies;  // peers that must send a PROXY header
  /// True if proxies may omit it, as their connections carry requests of many clients. The connection then
  /// belongs to the proxy: ConnectionInfo::through_proxy.
  bool header_optional = false;
  /// A connection is reset if the client's system answers nothing for this time; 0: the system's.
  std::chrono::milliseconds silence{};
};

/// Makes the message sent to a refused client before it is disconnected.
using RefusalMessage = std::function<std::vector<std::byte>(wire::ErrorCode code, const std::string& text,
                                                            std::chrono::milliseconds retry_after)>;
/// A frame with an Error.
[[nodiscard]] std::vector<std::byte> refusal_frame(wire::ErrorCode code, const std::string& text,
                                                   std::chrono::milliseconds retry_after);

class Handshaker {
 public:
  /// Runs on the socket's own thread, or in the caller of begin().
  using OnAccepted = std::function<void(AcceptedConnection)>;

  /// Memory of a PROXY header and a TLS handshake: buffers, coroutines, OpenSSL's state. Charged to the
  /// sessions' budget while they are in flight.
  static constexpr std::size_t kProxyBytes = std::size_t{8} * 1024;
  static constexpr std::size_t kTlsBytes = std::size_t{44} * 1024;

  /// `admission`, `metrics`, `memory` and `clock` outlive it. It outlives the sockets' io_contexts.
  Handshaker(const HandshakeSettings& settings, Admission& admission, const AccessControl& access,
             FlowUses& flows, Metrics& metrics, MemoryBudget& memory, const Clock& clock, Logger log,
             OnAccepted on_accepted, RefusalMessage refusal_message = refusal_frame);

  /// Takes a socket and returns at once, whatever the peer does. Uses TLS if `tls` is not null. Each socket
  /// is accepted, refused, or closed within the timeout. Call from one thread at a time.
  void begin(asio::ip::tcp::socket socket, ConnectionId id, const tls::Context& tls);

  /// Changes all limits but the proxies. Callable from any thread.
  void change(const HandshakeSettings& settings);

  /// Callable from any thread.
  [[nodiscard]] RefusalLog& refusal_log() { return refusal_log_; }

 private:
  struct PendingConnection;
  using PendingPtr = std::shared_ptr<PendingConnection>;

  /// Takes a place among the handshakes in flight. If all are taken, a handshake that takes too long, or one
  /// of a flow that holds more, gives way; returns false if there is neither.
  [[nodiscard]] bool take_place(const PendingPtr& pending);
  void spawn(const PendingPtr& pending, ConnectionId id);
  [[nodiscard]] asio::awaitable<void> shake_hands(PendingPtr pending);
  [[nodiscard]] asio::awaitable<bool> read_proxy_header(PendingConnection& pending);
  /// Returns true if the first bytes begin a PROXY header. Consumes no bytes.
  [[nodiscard]] asio::awaitable<bool> sends_proxy_header(PendingConnection& pending);
  [[nodiscard]] asio::awaitable<bool> begin_tls(PendingPtr pending);
  /// Takes an admission slot, within the rate of the address. Returns false if the connection was refused.
  [[nodiscard]] bool admit(PendingConnection& pending);
  void accept(PendingConnection& pending);
  void refuse(PendingConnection& pending, Refusal why, const std::string& text,
              std::chrono::milliseconds retry_after);
  /// Logs only the first connection that each line of the list blocks.
  void refuse_blocked(PendingConnection& pending, const BlockedAddress& blocked);
  void count(const PendingConnection& pending, Refusal why);
  void count_and_close(PendingConnection& pending, Refusal why, wire::ErrorCode code, const std::string& text,
                       std::chrono::milliseconds retry_after);

  const Networks proxies_;
  const bool header_optional_;
  std::atomic<std::uint64_t> per_address_per_second_;
  std::atomic<std::uint64_t> max_in_flight_;
  std::atomic<std::chrono::milliseconds> timeout_;
  std::atomic<std::chrono::milliseconds> silence_;
  Admission& admission_;
  const AccessControl& access_;
  FlowUses& flows_;
  Metrics& metrics_;
  MemoryBudget& memory_;
  const Clock& clock_;
  Logger log_;
  OnAccepted on_accepted_;
  RefusalMessage refusal_message_;
  ConnectionRateLimiter rate_;
  Refusals refusals_;
  RefusalLog refusal_log_;
};

}  // namespace talus::server
