#include "link.h"

#include <netinet/in.h>
#include <sys/socket.h>

#include <algorithm>
#include <utility>

#include <asio/buffer.hpp>

#include <talus/protocol/limits.h>

namespace talus::load {
namespace {

using asio::ip::tcp;

constexpr int kPacedReceiveBuffer = 4096;

std::string words_of(const std::error_code& error) {
  if (error == asio::error::eof) return "closed by the server";
  if (error == asio::error::connection_reset || error == asio::error::broken_pipe) return "reset";
  if (error == asio::error::connection_refused) return "refused";
  return error.message();
}

std::error_code error_of(const tls::Step& step) {
  if (step.waits()) return asio::error::would_block;
  if (step.result == tls::Step::Result::closed) return asio::error::eof;
  return step.error;
}

}  // namespace

Link::Link(asio::io_context& io, std::span<std::byte> scratch, LinkOwner& owner)
    : socket_{io}, scratch_{scratch}, owner_{owner}, frames_{protocol::kServerFrameBytes} {}

void Link::open(const OpenOptions& options) {
  close(false);
  frames_ = protocol::FrameReader{protocol::kServerFrameBytes};
  std::error_code error;
  socket_.open(options.server.protocol(), error);
  if (!error && options.from) {
    // Choose the port on connecting, or there would be only 64,512 ports for all servers.
    const int on = 1;
    ::setsockopt(socket_.native_handle(), IPPROTO_IP, IP_BIND_ADDRESS_NO_PORT, &on, sizeof(on));
    socket_.bind({*options.from, 0}, error);
  }
  if (!error && options.paced) {
    socket_.set_option(asio::socket_base::receive_buffer_size{kPacedReceiveBuffer}, error);
  }
  if (!error) socket_.non_blocking(true, error);
  if (error) return fail(words_of(error));
  paced_ = options.paced;
  if (options.tls != nullptr) {
    tls_.emplace(client::new_tls(options.tls, options.tls_options, options.server.address().to_string()),
                 socket_.native_handle());
  }
  if (options.websocket.on) {
    auto side = client::new_websocket(options.websocket, options.server.address().to_string(),
                                      std::to_string(options.server.port()));
    if (!side) return fail(side.error().message);
    websocket_ = std::move(*side);
  }
  socket_.async_connect(options.server, [this, mine = opening_](std::error_code failed) {
    if (mine != opening_) return;
    if (failed) return fail(words_of(failed));
    std::error_code ignored;
    socket_.set_option(tcp::no_delay{true}, ignored);
    if (tls_) return shake_hands();
    secured();
  });
}

void Link::shake_hands() {
  const tls::Step step = tls_->handshake();
  if (step.result == tls::Step::Result::done) return secured();
  if (!step.waits()) return fail(client::handshake_failure(tls_->handle(), error_of(step)).message);
  const bool to_write = step.result == tls::Step::Result::wait_to_write;
  const auto ready = to_write ? tcp::socket::wait_write : tcp::socket::wait_read;
  socket_.async_wait(ready, [this, mine = opening_](std::error_code failed) {
    if (mine != opening_) return;
    if (failed) return fail(words_of(failed));
    shake_hands();
  });
}

void Link::secured() {
  if (!websocket_) return established();
  send_bytes(std::as_bytes(std::span{websocket_->request()}));
  upgrade();
}

void Link::upgrade() {
  socket_.async_wait(tcp::socket::wait_read, [this, mine = opening_](std::error_code failed) {
    if (mine != opening_) return;
    if (failed) return fail(words_of(failed));
    std::error_code error;
    const std::size_t bytes = read_some(scratch_, error);
    if (error && error != asio::error::would_block) return fail(words_of(error));
    const std::size_t payload = websocket_->take(scratch_.first(bytes));
    if (websocket_->failure()) return fail(websocket_->failure()->text);
    if (!websocket_->is_open()) return upgrade();
    established();
    if (mine == opening_ && payload > 0) feed(scratch_.first(payload));
  });
}

void Link::established() {
  established_ = true;
  if (!paced_) await_input();
  owner_.opened();
}

std::size_t Link::read_some(std::span<std::byte> into, std::error_code& error) {
  if (!tls_) return socket_.read_some(asio::buffer(into.data(), into.size()), error);
  std::size_t all = 0;
  while (all < into.size()) {  // one record at a time
    const tls::Step step = tls_->read(into.subspan(all));
    error = error_of(step);
    if (error) break;
    all += step.bytes;
  }
  if (all > 0) error.clear();  // the error will recur
  return all;
}

std::size_t Link::write_some(std::span<const std::byte> from, std::error_code& error) {
  if (!tls_) return socket_.write_some(asio::buffer(from.data(), from.size()), error);
  const tls::Step step = tls_->write(from);
  error = error_of(step);
  return step.bytes;
}

void Link::send(std::span<const std::byte> frame) {
  if (!websocket_) return send_bytes(frame);
  std::vector<std::byte> wrapped;
  websocket::ClientSide::append(wrapped, frame, client::random_mask());
  send_bytes(wrapped);
}

void Link::send_control() {
  std::vector<std::byte> wrapped;
  while (websocket_->has_control()) websocket_->append_control(wrapped, client::random_mask());
  if (!wrapped.empty()) send_bytes(wrapped);
}

void Link::send_bytes(std::span<const std::byte> bytes) {
  if (!socket_.is_open()) return;
  if (unsent_.empty()) {
    std::error_code error;
    bytes = bytes.subspan(write_some(bytes, error));
    if (error && error != asio::error::would_block) return;  // reading detects a broken connection
  }
  if (bytes.empty()) return;
  unsent_.insert(unsent_.end(), bytes.begin(), bytes.end());
  if (!writing_) await_output();
}

void Link::await_output() {
  writing_ = true;
  socket_.async_wait(tcp::socket::wait_write, [this, mine = opening_](std::error_code failed) {
    if (mine != opening_) return;
    writing_ = false;
    const std::vector<std::byte> rest = std::exchange(unsent_, {});
    if (!failed) send_bytes(rest);
  });
}

void Link::await_input() {
  socket_.async_wait(tcp::socket::wait_read, [this, mine = opening_](std::error_code failed) {
    if (mine != opening_) return;
    if (failed) return fail(words_of(failed));
    do {
      take(scratch_.size());
    } while (mine == opening_ && tls_ && tls_->has_more());
    if (mine == opening_) await_input();
  });
}

void Link::take(std::size_t max_bytes) {
  if (!established_) return;
  std::error_code error;
  const std::size_t bytes = read_some(scratch_.first(std::min(max_bytes, scratch_.size())), error);
  if (error == asio::error::would_block) return;
  if (error) return fail(words_of(error));
  received_bytes_ += bytes;
  if (!websocket_) return feed(scratch_.first(bytes));
  const std::uint32_t mine = opening_;
  const std::size_t payload = websocket_->take(scratch_.first(bytes));
  send_control();
  if (payload > 0) feed(scratch_.first(payload));
  if (mine != opening_ || !websocket_->failure()) return;
  fail(websocket_->failure()->text, websocket_->failure()->kind == websocket::Failure::Kind::violation);
}

void Link::feed(std::span<const std::byte> bytes) {
  const std::uint32_t mine = opening_;
  while (!bytes.empty()) {
    const auto taken = frames_.feed(bytes);
    if (!taken) return fail(taken.error().message(), true);
    bytes = bytes.subspan(*taken);
    if (!frames_.has_frame()) continue;
    const auto message = protocol::read_message(frames_.frame());
    if (!message) return fail(std::string{protocol::describe(message.error())}, true);
    owner_.received(**message, frames_.frame().size());
    if (mine != opening_) return;
    frames_.pop();
  }
  owner_.read_done();
}

void Link::fail(const std::string& reason, bool broken) {
  close(false);
  owner_.ended(reason, broken);
}

void Link::close(bool abruptly) {
  ++opening_;
  established_ = false;
  writing_ = false;
  std::vector<std::byte>{}.swap(unsent_);
  std::error_code ignored;
  if (abruptly) socket_.set_option(asio::socket_base::linger{true, 0}, ignored);
  tls_.reset();
  websocket_.reset();
  socket_.close(ignored);
}

}  // namespace talus::load
