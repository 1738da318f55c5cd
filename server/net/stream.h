// A connection's bytes, whatever carries them: TcpStream, TlsStream, WebSocketStream over either, and a
// stream in memory for tests.
//
// A Stream is an AsyncReadStream and AsyncWriteStream of Asio, and says the protocol's end by itself: TLS a
// close_notify; a WebSocket's messages, pings and closing handshake are its stream's business too. Who uses
// one sees bytes in, bytes out, and the end. One read and one write may be in flight at a time, on its
// executor.
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
  // asio::error::eof where the peer has ended well.
  stream.async_read_some(in, done);
  stream.async_write_some(out, done);
  // Says that nothing more is to come, where the protocol has a word for it. shutdown() comes then.
  { stream.say_end() } -> std::same_as<asio::awaitable<void>>;
  // Nothing more is written.
  stream.shutdown();
  // What is in flight ends with an error.
  stream.close();
  // How often a write had to wait until the transport took more, since the stream began: where one
  // async_write_some takes only a part of the bytes although the transport would take all.
  { seen.write_waits() } -> std::same_as<std::size_t>;
  // Whether async_write_some takes all that the transport takes.
  { S::kWritesWhole } -> std::convertible_to<bool>;
  // Pieces of so many bytes and more are worth a place of their own in one write, instead of being copied.
  { S::kGatherFrom } -> std::convertible_to<std::size_t>;
};

}  // namespace talus::server
