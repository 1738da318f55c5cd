#include "net/acceptor.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <exception>
#include <utility>

#include <asio/redirect_error.hpp>
#include <asio/use_awaitable.hpp>

namespace talus::server {
namespace {

using asio::ip::tcp;

constexpr std::chrono::milliseconds kPause{100};  // after an accept that failed
constexpr int kFailuresPerLine = 100;

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

DescriptorReserve::~DescriptorReserve() {
  while (release_one()) continue;
}

void DescriptorReserve::fill() {
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

Acceptor::Acceptor(asio::io_context& io, Logger log, std::size_t reserved_descriptors)
    : socket_{io}, pause_{io}, log_{std::move(log)}, reserve_{reserved_descriptors} {}

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

asio::awaitable<void> Acceptor::run(NextContext next_context, OnSocket on_socket) {
  int failures = 0;  // in a row
  while (socket_.is_open()) {
    std::error_code failed;
    tcp::socket socket =
        co_await socket_.async_accept(next_context(), asio::redirect_error(asio::use_awaitable, failed));
    if (!socket_.is_open()) co_return;
    if (!failed) {
      failures = 0;
      try {
        on_socket(std::move(socket));
      } catch (const std::exception& error) {
        log_->error("a new connection failed: {}", error.what());
      }
      reserve_.fill();
      continue;
    }
    if (failed == asio::error::connection_aborted) continue;
    if (lacks_descriptors(failed) && reserve_.release_one()) continue;
    if (failures++ % kFailuresPerLine == 0) log_->warn("cannot accept a connection: {}", failed.message());
    pause_.expires_after(kPause);
    co_await pause_.async_wait(asio::redirect_error(asio::use_awaitable, failed));
    reserve_.fill();
  }
}

void Acceptor::close() {
  std::error_code ignored;
  socket_.close(ignored);
  pause_.cancel();
}

}  // namespace talus::server
