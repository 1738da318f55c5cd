// A connection's bytes, independent of the transport: TcpStream, TlsStream, WebSocketStream over either, and
// an in-memory stream for tests.
//
// A Stream is an AsyncReadStream and AsyncWriteStream of Asio, and handles its protocol's end by itself: a
// TLS close_notify; a WebSocket's messages, pings and closing handshake. Its user sees bytes in, bytes out,
// and the end. One read and one write may be in flight at a time, on its executor.
#pragma once

#include <concepts>
#include <cstddef>
#include <system_error>

#include <asio/awaitable.hpp>
#include <asio/buffer.hpp>

namespace talus::server {

template <typename S>
concept Stream = std::movable<S> &&
    requires(S stream, const S& seen, asio::mutable_buffer in, asio::const_buffer out,
             void (*done)(std::error_code, std::size_t)) {
  typename S::executor_type;
  { stream.get_executor() } -> std::same_as<typename S::executor_type>;
  // Ends with asio::error::eof if the peer sends no more and may still read.
  stream.async_read_some(in, done);
  stream.async_write_some(out, done);
  // Sends the protocol's end of stream, if it has one. Call shutdown() after it.
  { stream.say_end() } -> std::same_as<asio::awaitable<void>>;
  // Ends writing.
  stream.shutdown();
  // Operations in flight end with an error.
  stream.close();
  // True if the peer has reset the connection, even if unread bytes remain.
  { stream.peer_reset() } -> std::same_as<bool>;
  // True if the peer will send nothing more, even if unread bytes remain.
  { stream.peer_hung_up() } -> std::same_as<bool>;
  // Bytes that wait for a read.
  { stream.unread() } -> std::same_as<std::size_t>;
  // Number of times a write had to wait for the transport since the stream began. For streams whose
  // async_write_some takes only a part of the bytes although the transport would take all.
  { seen.write_waits() } -> std::same_as<std::size_t>;
  // True if async_write_some takes as much as the transport accepts.
  { S::kWritesWhole } -> std::convertible_to<bool>;
  // Minimum size of a piece that is worth its own buffer in a gathered write instead of a copy.
  { S::kGatherFrom } -> std::convertible_to<std::size_t>;
};

}  // namespace talus::server
