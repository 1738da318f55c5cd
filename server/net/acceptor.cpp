#include "net/acceptor.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <exception>
#include <new>
#include <thread>
#include <utility>

#include <asio/redirect_error.hpp>
#include <asio/use_awaitable.hpp>

namespace talus::server {
namespace {

using asio::ip::tcp;

constexpr std::chrono::milliseconds kPause{100};  // after an accept that failed
constexpr std::chrono::seconds kBetweenLines{5};  // about accepts that fail

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

}  // namespace

DescriptorReserve::DescriptorReserve(std::size_t wanted) : wanted_{wanted} {
  held_.reserve(wanted);
  fill();
}

DescriptorReserve::~DescriptorReserve() {
  while (release_one()) continue;
}

void DescriptorReserve::fill() noexcept {
  while (held_.size() < wanted_) {
    const int descriptor = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
    if (descriptor < 0) return;
    held_.push_back(descriptor);
  }
}

bool DescriptorReserve::release_one() {
  if (held_.empty()) return false;
  ::close(held_.back());
  held_.pop_back();
  return true;
}

Acceptor::Acceptor(asio::io_context& io, Logger log, const Clock& clock, std::size_t reserved_descriptors)
    : socket_{io}, pause_{io}, log_{std::move(log)}, clock_{clock}, reserve_{reserved_descriptors} {}

tl::expected<std::string, std::string> Acceptor::listen(const protocol::Endpoint& wanted) {
  std::error_code error;
  const tcp::endpoint endpoint = resolve(wanted, socket_.get_executor(), error);
  if (!error) socket_.open(endpoint.protocol(), error);
  if (!error) socket_.set_option(tcp::acceptor::reuse_address{true}, error);
  if (!error) socket_.bind(endpoint, error);
  if (!error) socket_.listen(asio::socket_base::max_listen_connections, error);
  if (error) return tl::make_unexpected(error.message());
  const tcp::endpoint local = socket_.local_endpoint();
  return to_string(protocol::Endpoint{local.address().to_string(), local.port()});
}

asio::awaitable<void> Acceptor::run(NextContext next_context, OnSocket on_socket, MakeRoom make_room) {
  while (socket_.is_open()) {
    std::error_code failed;
    std::string why;
    try {
      failed = co_await accept_one(next_context, on_socket);
      if (failed) why = failed.message();
    } catch (const std::exception& error) {
      failed = std::make_error_code(std::errc::not_enough_memory);
      why = error.what();
    }
    if (!socket_.is_open()) co_return;
    const bool again = !failed || failed == asio::error::connection_aborted ||
                       (lacks_descriptors(failed) && (reserve_.release_one() || make_room()));
    if (!again) {
      log_failure(why);
      co_await pause();
    }
    if (!again || !failed) reserve_.fill();
  }
}

asio::awaitable<std::error_code> Acceptor::accept_one(const NextContext& next_context,
                                                      const OnSocket& on_socket) {
  std::error_code failed;
  tcp::socket socket =
      co_await socket_.async_accept(next_context(), asio::redirect_error(asio::use_awaitable, failed));
  if (failed || !socket_.is_open()) co_return failed;
  try {
    on_socket(std::move(socket));
  } catch (const std::exception& error) {
    log_->error("a new connection failed: {}", error.what());
  }
  co_return failed;
}

asio::awaitable<void> Acceptor::pause() {
  std::error_code ignored;
  try {
    pause_.expires_after(kPause);
    co_await pause_.async_wait(asio::redirect_error(asio::use_awaitable, ignored));
  } catch (const std::bad_alloc&) {
    std::this_thread::sleep_for(kPause);  // without memory for a timer the thread has nothing better to do
  }
}

void Acceptor::log_failure(const std::string& why) {
  ++unlogged_;
  const auto now = clock_.now();
  if (last_line_ != Clock::time_point::min() && now - last_line_ < kBetweenLines) return;
  last_line_ = now;
  log_->warn("cannot accept a connection: {} ({} such failures since the last such line)", why,
             std::exchange(unlogged_, 0));
}

void Acceptor::close() {
  std::error_code ignored;
  socket_.close(ignored);
  pause_.cancel();
}

}  // namespace talus::server
