#include "net/refusals.h"

#include <array>
#include <chrono>
#include <cstddef>
#include <memory>
#include <system_error>
#include <utility>

#include <asio/buffer.hpp>
#include <asio/dispatch.hpp>
#include <asio/steady_timer.hpp>
#include <asio/write.hpp>

#include "net/descriptors.h"

namespace talus::server {
namespace {

constexpr std::chrono::milliseconds kTimeToRead{1000};

/// One of the kMax or kMaxSpare refusals in flight.
class InFlightSlot {
 public:
  /// The caller has incremented `in_flight`.
  explicit InFlightSlot(std::atomic<std::size_t>& in_flight) : in_flight_{&in_flight} {}
  InFlightSlot(InFlightSlot&& other) noexcept : in_flight_{std::exchange(other.in_flight_, nullptr)} {}
  InFlightSlot& operator=(InFlightSlot&&) = delete;
  ~InFlightSlot() {
    if (in_flight_ != nullptr) --*in_flight_;
  }

 private:
  std::atomic<std::size_t>* in_flight_;
};

/// A socket that closes itself at its deadline.
struct ClosingSocket {
  InFlightSlot slot;
  asio::ip::tcp::socket socket;
  asio::steady_timer deadline;
  std::vector<std::byte> message;
  std::array<std::byte, 512> unread{};
};
using ClosingSocketPtr = std::shared_ptr<ClosingSocket>;

// Not coroutines: if Asio has no memory to begin an operation of a coroutine, the process ends. Here the
// caller gets std::bad_alloc.

// Closing with unread bytes would reset the connection and could lose the message.
void read_to_end(const ClosingSocketPtr& closing) {
  closing->socket.async_read_some(asio::buffer(closing->unread),
                                  [closing](std::error_code ended, std::size_t) {
                                    if (ended) {
                                      closing->deadline.cancel();
                                    } else {
                                      read_to_end(closing);
                                    }
                                  });
}

void send_and_close(const ClosingSocketPtr& closing) {
  closing->deadline.expires_after(kTimeToRead);
  closing->deadline.async_wait([closing](std::error_code cancelled) {
    std::error_code ignored;
    if (!cancelled) closing->socket.close(ignored);
  });
  asio::async_write(closing->socket, asio::buffer(closing->message),
                    [closing](std::error_code failed, std::size_t) {
                      if (!failed) closing->socket.shutdown(asio::ip::tcp::socket::shutdown_send, failed);
                      if (!failed) return read_to_end(closing);
                      closing->deadline.cancel();
                    });
}

}  // namespace

void Refusals::refuse(asio::ip::tcp::socket socket, std::vector<std::byte> message) {
  const bool spare = is_spare(socket.native_handle());
  std::atomic<std::size_t>& in_flight = spare ? spare_in_flight_ : in_flight_;
  const bool full = in_flight.fetch_add(1) >= (spare ? kMaxSpare : kMax);
  InFlightSlot slot{in_flight};
  if (full) return;
  const auto executor = socket.get_executor();
  const auto closing = std::make_shared<ClosingSocket>(
      ClosingSocket{std::move(slot), std::move(socket), asio::steady_timer{executor}, std::move(message)});
  asio::dispatch(executor, [closing] { send_and_close(closing); });
}

}  // namespace talus::server
