#include "edits/store_socket/socket_frames.h"

#include <poll.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <system_error>

#include <fmt/format.h>

#include <talus/store/bytes.h>

namespace talus::server {
namespace {

using SteadyClock = std::chrono::steady_clock;
using Status = tl::expected<void, std::string>;

constexpr std::size_t kLengthBytes = 4;
constexpr std::size_t kHeaderBytes = 2;  // version and kind

tl::unexpected<std::string> frame_failure(std::string_view what, int error) {
  return tl::unexpected{fmt::format("{}: {}", what, std::generic_category().message(error))};
}

/// Returns false on timeout.
tl::expected<bool, std::string> wait_for(int socket, short events, SteadyClock::time_point until) {
  for (;;) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(until - SteadyClock::now()).count();
    const int timeout = until == SteadyClock::time_point::max()
                            ? -1
                            : static_cast<int>(std::clamp<std::int64_t>(left, 0, 1 << 30));
    pollfd poll{socket, events, 0};
    const int ready = ::poll(&poll, 1, timeout);
    if (ready > 0) return true;
    if (ready == 0) return false;
    if (errno != EINTR) return frame_failure("waiting for the other side", errno);
  }
}

/// Fills `into`. The error is empty if the stream ended before its first byte.
Status receive(int socket, std::span<std::byte> into, SteadyClock::time_point until) {
  for (std::size_t got = 0; got < into.size();) {
    const auto ready = wait_for(socket, POLLIN, until);
    if (!ready) return tl::unexpected{ready.error()};
    if (!*ready) return tl::unexpected{std::string{"the other side says nothing"}};
    const ssize_t bytes = ::recv(socket, into.data() + got, into.size() - got, MSG_DONTWAIT);
    if (bytes == 0) return tl::unexpected{std::string{got == 0 ? "" : "a frame ends early"}};
    if (bytes > 0) got += static_cast<std::size_t>(bytes);
    if (bytes < 0 && errno != EINTR && errno != EAGAIN) return frame_failure("reading", errno);
  }
  return {};
}

}  // namespace

Status send_frame(int socket, SocketKind kind, std::span<const std::byte> fields) {
  store::Bytes frame;
  store::ByteWriter writer{frame};
  writer.fixed32(static_cast<std::uint32_t>(kHeaderBytes + fields.size()));
  writer.byte(kSocketVersion);
  writer.byte(static_cast<std::uint8_t>(kind));
  writer.bytes(fields);
  const auto until = SteadyClock::now() + kFramePatience;
  for (std::size_t sent = 0; sent < frame.size();) {
    const auto ready = wait_for(socket, POLLOUT, until);
    if (!ready) return tl::unexpected{ready.error()};
    if (!*ready) return tl::unexpected{std::string{"the other side takes nothing"}};
    const ssize_t bytes =
        ::send(socket, frame.data() + sent, frame.size() - sent, MSG_DONTWAIT | MSG_NOSIGNAL);
    if (bytes > 0) sent += static_cast<std::size_t>(bytes);
    if (bytes < 0 && errno != EINTR && errno != EAGAIN) return frame_failure("writing", errno);
  }
  return {};
}

Status send_text(int socket, SocketKind kind, std::string_view text) {
  store::Bytes fields;
  store::ByteWriter{fields}.counted(text);
  return send_frame(socket, kind, fields);
}

tl::expected<SocketFrame, std::string> receive_frame(int socket, std::chrono::milliseconds patience) {
  const auto begins = patience.count() == 0 ? SteadyClock::time_point::max() : SteadyClock::now() + patience;
  std::array<std::byte, kLengthBytes> length{};
  // Only the first byte may take `patience`.
  if (auto done = receive(socket, std::span{length}.first(1), begins); !done) {
    return tl::unexpected{std::move(done.error())};
  }
  const auto until = SteadyClock::now() + kFramePatience;
  const auto early = [](std::string error) {
    return tl::unexpected{error.empty() ? std::string{"a frame ends early"} : std::move(error)};
  };
  if (auto done = receive(socket, std::span{length}.subspan(1), until); !done) return early(done.error());
  const std::uint32_t bytes = store::ByteReader{length}.fixed32();
  if (bytes < kHeaderBytes || bytes > kMaxSocketFrame) {
    return tl::unexpected{fmt::format("a frame of {} bytes; at most {} are taken", bytes, kMaxSocketFrame)};
  }
  std::array<std::byte, kHeaderBytes> header{};
  if (auto done = receive(socket, header, until); !done) return early(done.error());
  const auto version = std::to_integer<std::uint8_t>(header[0]);
  if (version != kSocketVersion) {
    return tl::unexpected{fmt::format(
        "the other side speaks version {} of the store's socket, this one {}; use the talusd that runs",
        version, kSocketVersion)};
  }
  SocketFrame frame{static_cast<SocketKind>(header[1]), store::Bytes(bytes - kHeaderBytes)};
  if (auto done = receive(socket, frame.fields, until); !done) return early(done.error());
  return frame;
}

}  // namespace talus::server
