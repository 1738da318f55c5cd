#include "net/acceptor.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <exception>
#include <thread>
#include <utility>

#include <asio/post.hpp>

namespace talus::server {
namespace {

using asio::ip::tcp;

constexpr std::chrono::milliseconds kPause{100};        // after an accept that failed
constexpr std::chrono::milliseconds kPauseOfThread{1};  // if there is no memory for a timer
constexpr std::chrono::seconds kBetweenLines{5};        // about accepts that fail

tcp::endpoint resolve(const protocol::Endpoint& endpoint, const asio::any_io_executor& executor,
                      std::error_code& error) {
  tcp::resolver resolver{executor};
  const auto found = resolver.resolve(endpoint.host, std::to_string(endpoint.port),
                                      tcp::resolver::passive | tcp::resolver::numeric_service, error);
  return error ? tcp::endpoint{} : found.begin()->endpoint();
}

bool lacks_descriptors(const std::error_code& error) {
  // By number: Asio's category maps these to no std::errc.
  return error.value() == EMFILE || error.value() == ENFILE;
}

/// Returns true if the error concerns only this connection: its peer has gone, or there was none to accept.
bool is_of_one_connection(const std::error_code& error) {
  return error == asio::error::would_block || error == asio::error::connection_aborted ||
         error.value() == EPROTO;
}

}  // namespace

/// Continuation of an asynchronous operation. Its memory belongs to the acceptor.
struct Acceptor::Step {
  using allocator_type = HandlerAllocator<std::byte>;

  Acceptor* acceptor;
  void (Acceptor::*next)(std::error_code);
  allocator_type memory;

  [[nodiscard]] allocator_type get_allocator() const noexcept { return memory; }
  void operator()(std::error_code failed = {}) const { (acceptor->*next)(failed); }
};

Acceptor::Acceptor(asio::io_context& io, Logger log, const Clock& clock)
    : io_{io}, socket_{io}, pause_{io}, log_{std::move(log)}, clock_{clock} {}

tl::expected<std::string, std::string> Acceptor::listen(const protocol::Endpoint& wanted) {
  std::error_code error;
  const tcp::endpoint endpoint = resolve(wanted, socket_.get_executor(), error);
  if (!error) socket_.open(endpoint.protocol(), error);
  if (!error) socket_.set_option(tcp::acceptor::reuse_address{true}, error);
  if (!error) socket_.bind(endpoint, error);
  if (!error) socket_.listen(asio::socket_base::max_listen_connections, error);
  // Makes accept() return if the pending connection has gone.
  if (!error) socket_.non_blocking(true, error);
  if (!error) socket_.set_option(asio::socket_base::enable_connection_aborted{true}, error);
  if (error) return tl::make_unexpected(error.message());
  const tcp::endpoint local = socket_.local_endpoint();
  return to_string(protocol::Endpoint{local.address().to_string(), local.port()});
}

void Acceptor::start(NextContext next_context, OnSocket on_socket, MakeRoom make_room) {
  next_context_ = std::move(next_context);
  on_socket_ = std::move(on_socket);
  make_room_ = std::move(make_room);
  wait_for_connection();
}

void Acceptor::wait_for_connection() {
  socket_.async_wait(tcp::acceptor::wait_read, Step{this, &Acceptor::on_readable, memory_});
}

void Acceptor::on_readable(std::error_code failed) {
  if (!socket_.is_open()) return;
  if (accept_one(failed)) {
    wait_for_connection();
  } else {
    pause();
  }
}

bool Acceptor::accept_one(std::error_code failed) noexcept {
  try {
    if (!failed) {
      // Not async_accept(): without memory it throws where the exception cannot be caught.
      tcp::socket socket = socket_.accept(next_context_(), failed);
      if (!failed) {
        hand_over(std::move(socket));
        return true;
      }
    }
    if (is_of_one_connection(failed)) return true;
    if (lacks_descriptors(failed) && make_room_()) return true;
    log_failure(failed.message());
  } catch (const std::exception& error) {
    log_failure(error.what());
  }
  return false;
}

void Acceptor::hand_over(tcp::socket socket) noexcept {
  try {
    on_socket_(std::move(socket));
  } catch (const std::exception& error) {
    log_failure(error.what());
  }
}

void Acceptor::pause() {
  try {
    pause_.expires_after(kPause);
    pause_.async_wait(Step{this, &Acceptor::end_pause, memory_});
  } catch (const std::exception&) {
    // The io_context has no memory for another timer. Let its other handlers run first.
    std::this_thread::sleep_for(kPauseOfThread);
    asio::post(io_.get_executor(), Step{this, &Acceptor::end_pause, memory_});
  }
}

void Acceptor::end_pause(std::error_code) {
  if (!socket_.is_open()) return;
  wait_for_connection();
}

void Acceptor::log_failure(std::string_view why) noexcept {
  const auto now = clock_.now();
  if (unlogged_++ == 0) first_unlogged_ = now;
  if (last_line_ != Clock::time_point::min() && now - last_line_ < kBetweenLines) return;
  try {
    log_->warn(
        "{} {} failed in the last {} s, the last one: {}", unlogged_, unlogged_ == 1 ? "accept" : "accepts",
        std::max<std::int64_t>(1, std::chrono::ceil<std::chrono::seconds>(now - first_unlogged_).count()),
        why);
    last_line_ = now;
    unlogged_ = 0;
  } catch (const std::exception&) {
    // retried at the next failure
  }
}

void Acceptor::close() {
  std::error_code ignored;
  socket_.close(ignored);
  pause_.cancel();
}

}  // namespace talus::server
