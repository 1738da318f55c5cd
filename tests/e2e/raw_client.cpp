#include "raw_client.h"

#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <catch2/catch.hpp>
#include <cerrno>
#include <utility>

#include "messages.h"

namespace talus::e2e {
namespace {

constexpr int kPatienceMs = 60'000;

}  // namespace

Received::Received(protocol::Frame frame) : frame_{std::move(frame)} {
  const auto message = protocol::read_message(frame_);
  REQUIRE(message.has_value());
  message_ = *message;
}

void Received::check_kind(wire::Body expected) const {
  if (kind() == wire::Body::Error) {
    UNSCOPED_INFO("Error: " << static_cast<const wire::Error*>(message_->body())->text()->str());
  }
  REQUIRE(std::string{wire::EnumNameBody(kind())} == wire::EnumNameBody(expected));
}

RawClient::RawClient(std::uint16_t port, std::uint32_t from)
    : socket_{::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)} {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  if (from != kLoopback) {  // a bound socket takes a port that no other may have, whomever it speaks to
    address.sin_addr.s_addr = htonl(from);
    REQUIRE(::bind(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof(address)) == 0);
  }
  address.sin_port = htons(port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  REQUIRE(::connect(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof(address)) == 0);
  const int on = 1;
  ::setsockopt(socket_, IPPROTO_TCP, TCP_NODELAY, &on, sizeof(on));
}

RawClient::~RawClient() {
  close();
}

RawClient::RawClient(RawClient&& other) noexcept
    : socket_{std::exchange(other.socket_, -1)},
      ended_{other.ended_},
      frames_{std::move(other.frames_)},
      whole_{std::move(other.whole_)} {}

void RawClient::end_sending() {
  ::shutdown(socket_, SHUT_WR);
}

void RawClient::close() {
  if (socket_ >= 0) ::close(std::exchange(socket_, -1));
}

bool RawClient::send(std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t sent = ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (sent < 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(sent));
  }
  return true;
}

std::optional<std::size_t> RawClient::send_some(std::span<const std::byte> bytes) {
  const ssize_t sent = ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
  if (sent >= 0) return static_cast<std::size_t>(sent);
  if (errno == EAGAIN || errno == EWOULDBLOCK) return 0;
  return std::nullopt;
}

bool RawClient::fill(int patience_ms) {
  pollfd readable{socket_, POLLIN, 0};
  if (::poll(&readable, 1, patience_ms) <= 0) return false;
  std::array<std::byte, 65536> buffer{};
  const ssize_t got = ::recv(socket_, buffer.data(), buffer.size(), 0);
  if (got <= 0) {
    ended_ = true;
    return true;
  }
  std::span<const std::byte> bytes{buffer.data(), static_cast<std::size_t>(got)};
  while (!bytes.empty()) {
    const auto taken = frames_.feed(bytes);
    REQUIRE(taken.has_value());
    bytes = bytes.subspan(*taken);
    if (!frames_.has_frame()) continue;
    whole_.emplace_back(frames_.frame().begin(), frames_.frame().end());
    frames_.pop();
  }
  return true;
}

std::optional<Received> RawClient::receive() {
  while (whole_.empty() && !ended_) {
    const bool something = fill(kPatienceMs);
    REQUIRE(something);
  }
  return receive_within(std::chrono::milliseconds{0});
}

std::optional<Received> RawClient::receive_within(std::chrono::milliseconds patience) {
  if (whole_.empty() && !ended_) (void)fill(static_cast<int>(patience.count()));
  if (whole_.empty()) return std::nullopt;
  Received received{std::move(whole_.front())};
  whole_.pop_front();
  return received;
}

Received RawClient::expect() {
  auto received = receive();
  REQUIRE(received.has_value());
  return *std::move(received);
}

bool RawClient::closed() {
  return !receive().has_value();
}

RawClient greeted(std::uint16_t port, std::uint64_t window_bytes, std::uint32_t from) {
  RawClient client{port, from};
  REQUIRE(client.send(hello({.window_bytes = window_bytes})));
  (void)client.expect_kind<wire::Welcome>();
  return client;
}

}  // namespace talus::e2e
