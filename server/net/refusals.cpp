#include "net/refusals.h"

#include <array>
#include <chrono>
#include <memory>
#include <utility>

#include <asio/buffer.hpp>
#include <asio/co_spawn.hpp>
#include <asio/detached.hpp>
#include <asio/redirect_error.hpp>
#include <asio/steady_timer.hpp>
#include <asio/use_awaitable.hpp>
#include <asio/write.hpp>

#include "session/reply_frames.h"

namespace talus::server {
namespace {

constexpr std::chrono::milliseconds kTimeToRead{1000};

/// One of Refusals::kMax.
class InFlightSlot {
 public:
  /// Counted already.
  explicit InFlightSlot(std::atomic<std::size_t>& in_flight) : in_flight_{&in_flight} {}
  InFlightSlot(InFlightSlot&& other) noexcept : in_flight_{std::exchange(other.in_flight_, nullptr)} {}
  InFlightSlot& operator=(InFlightSlot&&) = delete;
  ~InFlightSlot() {
    if (in_flight_ != nullptr) --*in_flight_;
  }

 private:
  std::atomic<std::size_t>* in_flight_;
};

/// A socket that closes itself when the time is over.
struct Closing {
  InFlightSlot slot;
  asio::ip::tcp::socket socket;
  asio::steady_timer deadline;
  protocol::Frame error;
};

asio::awaitable<void> send_and_close(std::shared_ptr<Closing> closing) {
  closing->deadline.expires_after(kTimeToRead);
  closing->deadline.async_wait([closing](std::error_code cancelled) {
    std::error_code ignored;
    if (!cancelled) closing->socket.close(ignored);
  });
  std::error_code failed;
  co_await asio::async_write(closing->socket, asio::buffer(closing->error),
                             asio::redirect_error(asio::use_awaitable, failed));
  if (!failed) closing->socket.shutdown(asio::ip::tcp::socket::shutdown_send, failed);
  // Closing with unread bytes would reset the connection and could take the error with it.
  std::array<std::byte, 512> unread{};
  while (!failed) {
    co_await closing->socket.async_read_some(asio::buffer(unread),
                                             asio::redirect_error(asio::use_awaitable, failed));
  }
  closing->deadline.cancel();
}

}  // namespace

void Refusals::refuse(asio::ip::tcp::socket socket, const std::string& text,
                      std::chrono::milliseconds retry_after) {
  const bool full = in_flight_.fetch_add(1) >= kMax;
  InFlightSlot slot{in_flight_};
  if (full) return;
  const auto executor = socket.get_executor();
  const auto closing =
      std::make_shared<Closing>(Closing{std::move(slot), std::move(socket), asio::steady_timer{executor},
                                        error_frame(wire::ErrorCode::overloaded, text, 0, retry_after)});
  asio::co_spawn(
      executor, [closing] { return send_and_close(closing); }, asio::detached);
}

}  // namespace talus::server
