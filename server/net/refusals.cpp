#include "net/refusals.h"

#include <array>
#include <chrono>
#include <cstddef>
#include <memory>
#include <system_error>
#include <utility>

#include <asio/buffer.hpp>
#include <asio/dispatch.hpp>
#include <asio/post.hpp>
#include <asio/steady_timer.hpp>
#include <asio/write.hpp>

#include "net/descriptors.h"

namespace talus::server {
namespace {

constexpr std::chrono::milliseconds kTimeToRead{1000};

/// A socket that closes itself at its deadline.
struct ClosingSocket {
  FlowShares::Part place;
  asio::ip::tcp::socket socket;
  asio::steady_timer deadline;
  std::vector<std::byte> message;
  std::array<std::byte, 512> unread{};

  ClosingSocket(FlowShares& in_flight, FlowId flow, Clock::time_point now, asio::ip::tcp::socket of,
                std::vector<std::byte> text)
      : place{in_flight, flow, 1, now},
        socket{std::move(of)},
        deadline{socket.get_executor()},
        message{std::move(text)} {}
  void close() {
    std::error_code ignored;
    socket.close(ignored);
  }
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
    if (!cancelled) closing->close();
  });
  asio::async_write(closing->socket, asio::buffer(closing->message),
                    [closing](std::error_code failed, std::size_t) {
                      if (!failed) closing->socket.shutdown(asio::ip::tcp::socket::shutdown_send, failed);
                      if (!failed) return read_to_end(closing);
                      closing->deadline.cancel();
                    });
}

}  // namespace

void Refusals::refuse(asio::ip::tcp::socket socket, std::vector<std::byte> message, FlowId flow,
                      Clock::time_point now) {
  const bool spare = is_spare(socket.native_handle());
  FlowShares& in_flight = spare ? spare_in_flight_ : in_flight_;
  if (in_flight.size() >= (spare ? kMaxSpare : kMax) && !in_flight.make_room(flow, 1, 0, now)) return;
  const auto executor = socket.get_executor();
  const auto closing =
      std::make_shared<ClosingSocket>(in_flight, flow, now, std::move(socket), std::move(message));
  closing->place.set_give_way([weak = std::weak_ptr{closing}, executor] {
    asio::post(executor, [weak] {
      if (const auto alive = weak.lock()) alive->close();
    });
  });
  asio::dispatch(executor, [closing] { send_and_close(closing); });
}

}  // namespace talus::server
