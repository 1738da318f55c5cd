// What a new connection passes before it has a session: the proxy's word on whose it is, a place, the
// address's budget of handshakes, and TLS.
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>
#include <mutex>
#include <string>

#include <asio/awaitable.hpp>
#include <asio/ip/tcp.hpp>

#include "config/config.h"
#include "log/logger.h"
#include "metrics/metrics.h"
#include "net/admission.h"
#include "net/handshake_budget.h"
#include "net/refusal.h"
#include "net/registry.h"
#include "net/tls_context.h"
#include "net/wire.h"

namespace talus::server {

/// Who came in.
struct Guest {
  ConnectionId id{};
  Wire wire;
  std::string address;  // as the log names it; the client's own, where a proxy speaks for it
  Admission::Place place;
  std::chrono::steady_clock::time_point came;
};

class Door {
 public:
  using Clock = std::chrono::steady_clock;
  /// On the guest's own thread, or in the caller of knock().
  using Welcome = std::function<void(Guest)>;

  /// Whether there is memory for one more.
  using HasRoom = std::function<bool()>;

  /// `config`, `admission` and `metrics` outlive it. It outlives the sockets' io_contexts.
  Door(const Config& config, Admission& admission, Metrics& metrics, Logger log, HasRoom has_room,
       Welcome welcome);

  /// Takes a socket up and returns at once, whatever the peer does; by TLS where there is a context. Each
  /// socket is welcomed, refused, or closed within limits.handshake_timeout_ms. From one thread at a time.
  void knock(asio::ip::tcp::socket socket, ConnectionId id, const TlsContext& tls);

  /// Logs how many were refused and whom last, where that is not said and the line before so long ago. Any
  /// thread.
  void tell_refusals(Clock::duration since_the_last = std::chrono::seconds{1});

 private:
  struct Visit;
  using VisitPtr = std::shared_ptr<Visit>;

  [[nodiscard]] asio::awaitable<void> receive(VisitPtr visit);
  [[nodiscard]] asio::awaitable<bool> ask_proxy(Visit& visit);
  [[nodiscard]] asio::awaitable<bool> shake_hands(Visit& visit);
  /// A place for the visitor, within its budget; else it has been refused.
  [[nodiscard]] bool admit(Visit& visit);
  void let_in(Visit& visit);
  void refuse(Visit& visit, Refusal why, const std::string& text, std::chrono::milliseconds retry_after);
  void note_refusal(const std::string& who, const std::string& why);

  const Config& config_;
  Admission& admission_;
  Metrics& metrics_;
  Logger log_;
  HasRoom has_room_;
  Welcome welcome_;
  HandshakeBudget budget_;
  Refusals refusals_;
  std::mutex refusal_lines_;
  Clock::time_point last_refusal_line_{};
  std::uint64_t refusals_unsaid_ = 0;
  std::string last_refused_;  // who, and why
};

}  // namespace talus::server
