#include "raw_client.h"

#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cerrno>
#include <utility>

#include "messages.h"

namespace talus::e2e {
namespace {

constexpr int kPatienceMs = 60'000;

/// Of a frame that a client who sends no more gets while it waits, so that TCP says if it is gone.
bool says_nothing(std::span<const std::byte> frame) {
  const auto message = protocol::read_message(frame);
  const auto* const complete = message ? (*message)->body_as_ViewComplete() : nullptr;
  return complete != nullptr && complete->number() == 0;
}

}  // namespace

ReceivedFrame::ReceivedFrame(protocol::Frame frame) : frame_{std::move(frame)} {
  const auto message = protocol::read_message(frame_);
  REQUIRE(message.has_value());
  message_ = *message;
}

void ReceivedFrame::check_kind(wire::Body expected) const {
  if (kind() == wire::Body::Error) {
    UNSCOPED_INFO("Error: " << static_cast<const wire::Error*>(message_->body())->text()->str());
  }
  REQUIRE(std::string{wire::EnumNameBody(kind())} == wire::EnumNameBody(expected));
}

RawClient::RawClient(std::uint16_t port, std::uint32_t from, Transport transport)
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
  if (transport == Transport::websocket) open_websocket();
}

void RawClient::open_websocket() {
  constexpr std::array<std::byte, websocket::kNonceBytes> kNonce{};  // nobody here would foretell it
  websocket_.emplace("127.0.0.1", "/v1/stream", kNonce);
  const bool sent = send_raw(std::as_bytes(std::span{websocket_->request()}));
  if (!sent) not_opened("the server closed the connection");
  while (!websocket_->is_open()) {
    const bool something = fill(kPatienceMs);  // throws NotOpened, which is no failure
    REQUIRE(something);
    if (ended_ && !websocket_->failure()) not_opened("the server closed the connection");
  }
}

void RawClient::not_opened(const std::string& why) {
  close();  // a constructor that throws has no destructor
  throw NotOpened{why};
}

std::vector<std::byte> RawClient::wrapped(std::span<const std::byte> bytes) {
  constexpr std::array kMask{std::byte{0xDE}, std::byte{0xCA}, std::byte{0xDE}, std::byte{0x01}};
  constexpr std::byte kFinal{0x80};
  constexpr std::array<std::size_t, 6> kSizes{0, 1, 7, 125, 126, 100'000};
  std::vector<std::byte> frames;
  while (websocket_->has_control()) websocket_->append_control(frames, kMask);
  bool begins = true;
  do {
    const std::size_t size = std::min(bytes.size(), kSizes[sizes_() % kSizes.size()]);
    const std::size_t head = frames.size();
    websocket::ClientSide::append(frames, bytes.first(size), kMask);
    bytes = bytes.subspan(size);
    const bool ends = bytes.empty() || sizes_() % 2 == 0;
    if (!begins) frames[head] = kFinal;  // a continuation
    if (!ends) frames[head] &= ~kFinal;
    begins = ends;
  } while (!bytes.empty());
  return frames;
}

RawClient::~RawClient() {
  close();
}

RawClient::RawClient(RawClient&& other) noexcept
    : socket_{std::exchange(other.socket_, -1)},
      websocket_{std::move(other.websocket_)},
      unsent_{std::move(other.unsent_)},
      sizes_{other.sizes_},
      ended_{other.ended_},
      frames_{std::move(other.frames_)},
      whole_{std::move(other.whole_)} {}

void RawClient::end_sending() {
  ::shutdown(socket_, SHUT_WR);
}

void RawClient::close() {
  if (socket_ >= 0) ::close(std::exchange(socket_, -1));
}

void RawClient::reset() {
  const linger at_once{1, 0};
  ::setsockopt(socket_, SOL_SOCKET, SO_LINGER, &at_once, sizeof(at_once));
  close();
}

bool RawClient::send(std::span<const std::byte> bytes) {
  if (!websocket_) return send_raw(bytes);
  return send_raw(std::exchange(unsent_, {})) && send_raw(wrapped(bytes));
}

bool RawClient::send_raw(std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t sent = ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (sent < 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(sent));
  }
  return true;
}

std::optional<std::size_t> RawClient::send_some(std::span<const std::byte> bytes) {
  constexpr std::size_t kMaxMessageBytes = std::size_t{64} * 1024;
  const std::size_t fresh = websocket_ && unsent_.empty() ? std::min(bytes.size(), kMaxMessageBytes) : 0;
  if (fresh > 0) unsent_ = wrapped(bytes.first(fresh));
  if (websocket_) bytes = unsent_;
  ssize_t sent = ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
  if (sent < 0) {
    if (errno != EAGAIN && errno != EWOULDBLOCK) return std::nullopt;
    sent = 0;
  }
  if (!websocket_) return static_cast<std::size_t>(sent);
  unsent_.erase(unsent_.begin(), unsent_.begin() + sent);
  return fresh;  // wrapped, and so on their way
}

void RawClient::drop_received() {
  std::array<std::byte, 65536> dropped;
  while (::recv(socket_, dropped.data(), dropped.size(), MSG_DONTWAIT) > 0) continue;
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
  take(std::span{buffer}.first(static_cast<std::size_t>(got)));
  return true;
}

void RawClient::take(std::span<std::byte> came) {
  if (websocket_) {
    came = came.first(websocket_->take(came));
    ended_ = websocket_->failure().has_value();
    if (ended_ && websocket_->failure()->status == 503) {
      not_opened(websocket_->failure()->text);
    }
    if (ended_ && websocket_->failure()->kind != websocket::Failure::Kind::closed) {
      FAIL(websocket_->failure()->text);
    }
  }
  std::span<const std::byte> bytes{came};
  while (!bytes.empty()) {
    const auto taken = frames_.feed(bytes);
    REQUIRE(taken.has_value());
    bytes = bytes.subspan(*taken);
    if (!frames_.has_frame()) continue;
    if (!says_nothing(frames_.frame())) {
      whole_.emplace_back(frames_.frame().begin(), frames_.frame().end());
    }
    frames_.pop();
  }
}

std::optional<ReceivedFrame> RawClient::receive() {
  while (whole_.empty() && !ended_) {
    const bool something = fill(kPatienceMs);
    REQUIRE(something);
  }
  return receive_within(std::chrono::milliseconds{0});
}

std::optional<ReceivedFrame> RawClient::receive_within(std::chrono::milliseconds patience) {
  if (whole_.empty() && !ended_) (void)fill(static_cast<int>(patience.count()));
  if (whole_.empty()) return std::nullopt;
  ReceivedFrame received{std::move(whole_.front())};
  whole_.pop_front();
  return received;
}

ReceivedFrame RawClient::expect() {
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
