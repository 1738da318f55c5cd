// A Stream inside a WebSocket on another stream: bytes in, bytes out, regardless of message boundaries. Pings
// are answered, and the closing handshake is done, between writes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <asio/awaitable.hpp>
#include <asio/buffer.hpp>
#include <asio/compose.hpp>
#include <asio/error.hpp>
#include <asio/post.hpp>
#include <asio/redirect_error.hpp>
#include <asio/steady_timer.hpp>
#include <asio/use_awaitable.hpp>
#include <asio/write.hpp>

#include <talus/websocket/frame_reader.h>
#include <talus/websocket/frame_writer.h>

#include "net/stream.h"

namespace talus::server::websocket {

using talus::websocket::append_close;
using talus::websocket::append_pong;
using talus::websocket::CloseCode;
using talus::websocket::End;
using talus::websocket::FrameReader;
using talus::websocket::kMaxHeadBytes;
using talus::websocket::write_head;

template <Stream S>
class WebSocketStream {
 public:
  using executor_type = typename S::executor_type;
  static constexpr bool kWritesWhole = S::kWritesWhole;
  static constexpr std::size_t kGatherFrom = S::kGatherFrom;

  /// `unread`: bytes received after the handshake's request.
  WebSocketStream(S inner, std::span<const std::byte> unread)
      : state_{std::make_shared<State>(std::move(inner), unread)} {}

  [[nodiscard]] executor_type get_executor() { return state_->inner.get_executor(); }

  /// Gives 0 bytes after control frames alone, which cost time too. Fails with an End if the client closes or
  /// breaks the protocol. Then call say_end(), which sends a Close behind the frame that is being written.
  template <typename Buffers, typename Token>
  auto async_read_some(const Buffers& buffers, Token&& token) {
    return asio::async_compose<Token, void(std::error_code, std::size_t)>(
        Read{state_, asio::mutable_buffer{*asio::buffer_sequence_begin(buffers)}}, token, get_executor());
  }

  template <typename Buffers, typename Token>
  auto async_write_some(const Buffers& buffers, Token&& token) {
    Write write{state_};
    for (auto each = asio::buffer_sequence_begin(buffers);
         each != asio::buffer_sequence_end(buffers) && write.pieces < kMaxPieces; ++each) {
      write.buffers[write.pieces++] = asio::const_buffer{*each};
    }
    return asio::async_compose<Token, void(std::error_code, std::size_t)>(std::move(write), token,
                                                                          get_executor());
  }

  [[nodiscard]] asio::awaitable<void> say_end() {
    const auto state = state_;
    if (!state->close_sent && !state->close_waits) state->close_waits = CloseCode::normal;
    for (state->write_control(state); state->writing; state->write_control(state)) {
      co_await state->wait_for_turn();
    }
    co_await state->inner.say_end();
  }
  [[nodiscard]] static bool answers(std::error_code failed) {
    return failed.category() == make_error_code(End::closed).category();
  }
  [[nodiscard]] bool peer_reset() { return state_->inner.peer_reset(); }
  [[nodiscard]] bool peer_hung_up() { return state_->inner.peer_hung_up(); }
  [[nodiscard]] std::size_t unread() { return state_->inner.unread(); }
  void shutdown() { state_->inner.shutdown(); }
  void close() {
    state_->broken = true;
    state_->inner.close();
    state_->turn.cancel();
  }
  [[nodiscard]] std::size_t write_waits() const { return state_->inner.write_waits(); }
  /// Bytes of the last read that were no payload: heads and control frames.
  [[nodiscard]] std::size_t own_bytes() const { return state_->own_bytes; }

 private:
  static constexpr std::size_t kMaxPieces = 16;
  // In addition to a frame's head, if the inner stream takes one buffer at a time.
  static constexpr std::size_t kMaxStaged = std::size_t{16} * 1024 - kMaxHeadBytes;

  // Owned by operations too: one may end after the stream is destroyed.
  struct State {
    State(S stream, std::span<const std::byte> bytes)
        : inner{std::move(stream)},
          turn{inner.get_executor(), asio::steady_timer::time_point::max()},
          unread(bytes.begin(), bytes.end()) {}

    /// Sends the pending Pong and Close unless a frame is being written.
    static void write_control(const std::shared_ptr<State>& self) {
      if (self->writing || self->frame_left > 0) return;
      self->control.clear();
      if (self->reader.has_ping()) append_pong(self->control, self->reader.ping());
      self->reader.pop_ping();
      if (const auto code = std::exchange(self->close_waits, std::nullopt)) {
        append_close(self->control, *code);
        self->close_sent = true;
      }
      if (self->control.empty()) return;
      self->writing = true;
      asio::async_write(self->inner, asio::buffer(self->control),
                        [self](std::error_code failed, std::size_t) {
                          self->end_turn();
                          if (failed) {
                            self->broken = true;
                          } else {
                            write_control(self);
                          }
                        });
    }
    [[nodiscard]] std::error_code end_of_writing() const {
      if (reader.end() != End::none) return reader.end();
      return asio::error::broken_pipe;
    }
    void end_turn() {
      writing = false;
      turn.cancel();
    }
    [[nodiscard]] asio::awaitable<void> wait_for_turn() {
      std::error_code cancelled;
      co_await turn.async_wait(asio::redirect_error(asio::use_awaitable, cancelled));
    }

    S inner;
    asio::steady_timer turn;  // never expires; cancelled when a write ends; several may wait for it
    FrameReader reader{talus::websocket::Sender::client};
    std::vector<std::byte> unread;
    std::size_t own_bytes = 0;
    bool writing = false;
    bool broken = false;  // nothing more can be written
    std::optional<CloseCode> close_waits;
    bool close_sent = false;
    std::vector<std::byte> control;  // in flight

    std::array<std::byte, kMaxHeadBytes> head{};
    std::size_t head_bytes = 0;
    std::size_t head_sent = 0;
    std::uint64_t frame_left = 0;  // unwritten payload of the current frame
    std::vector<std::byte> staged;
  };
  using StatePtr = std::shared_ptr<State>;

  struct Read {
    StatePtr state;
    asio::mutable_buffer into;
    bool began = false;

    template <typename Self>
    void operator()(Self& self, std::error_code failed = {}, std::size_t bytes = 0) {
      if (failed) return self.complete(failed, 0);
      if (!std::exchange(began, true)) {
        if (state->reader.end() == End::none && state->unread.empty()) {
          return state->inner.async_read_some(into, std::move(self));
        }
        return asio::post(state->inner.get_executor(), std::move(self));  // never from inside the call
      }
      if (!state->unread.empty()) {
        bytes = asio::buffer_copy(into, asio::buffer(state->unread));
        state->unread.erase(state->unread.begin(),
                            state->unread.begin() + static_cast<std::ptrdiff_t>(bytes));
      }
      const std::size_t payload = state->reader.take({static_cast<std::byte*>(into.data()), bytes});
      state->own_bytes = bytes - payload;
      const End why = state->reader.end();
      if (why != End::none && !state->close_sent) state->close_waits = close_code(why);
      State::write_control(state);
      if (payload > 0 || why == End::none) return self.complete({}, payload);
      self.complete(why, 0);
    }
  };

  struct Write {
    StatePtr state;
    std::array<asio::const_buffer, kMaxPieces> buffers{};
    std::size_t pieces = 0;
    enum class Step : std::uint8_t { begin, wait, write } step = Step::begin;

    template <typename Self>
    void operator()(Self& self, std::error_code failed = {}, std::size_t bytes = 0) {
      if (step != Step::write) {
        const bool begins = std::exchange(step, Step::wait) == Step::begin;
        if (state->writing) return state->turn.async_wait(std::move(self));
        if (state->close_sent) {
          if (begins) return asio::post(state->inner.get_executor(), std::move(self));
          return self.complete(state->end_of_writing(), 0);
        }
        state->writing = true;
        step = Step::write;
        if (state->frame_left == 0) begin_frame();
        return write(self);
      }
      const std::size_t of_head = std::min(bytes, state->head_bytes - state->head_sent);
      state->head_sent += of_head;
      bytes -= of_head;
      state->frame_left -= bytes;
      if (!failed && bytes == 0 && state->frame_left > 0) return write(self);
      state->end_turn();
      if (failed) {
        state->broken = true;
      } else {
        State::write_control(state);
      }
      self.complete(failed, bytes);
    }

    void begin_frame() {
      state->frame_left = asio::buffer_size(std::span{buffers}.first(pieces));
      state->head_bytes = write_head(state->head, state->frame_left);
      state->head_sent = 0;
    }

    /// Writes the rest of the head and as much of the frame's payload as the buffers hold.
    template <typename Self>
    void write(Self& self) {
      std::array<asio::const_buffer, kMaxPieces + 1> out{};
      std::size_t count = 0;
      if (state->head_sent < state->head_bytes) {
        out[count++] = asio::buffer(state->head) + state->head_sent;
        out[0] = asio::buffer(out[0], state->head_bytes - state->head_sent);
      }
      std::uint64_t left = state->frame_left;
      for (std::size_t i = 0; i < pieces && left > 0; ++i) {
        const auto piece = static_cast<std::size_t>(std::min<std::uint64_t>(left, buffers[i].size()));
        out[count++] = asio::buffer(buffers[i], piece);
        left -= piece;
      }
      if constexpr (S::kWritesWhole) {
        state->inner.async_write_some(out, std::move(self));
      } else if (count == 1 || state->head_sent == state->head_bytes) {
        state->inner.async_write_some(out[0], std::move(self));
      } else {
        stage(std::span{out}.first(count));
        state->inner.async_write_some(asio::buffer(state->staged), std::move(self));
      }
    }

    void stage(std::span<const asio::const_buffer> out) {
      const std::size_t most = std::min(asio::buffer_size(out), kMaxStaged + kMaxHeadBytes);
      state->staged.resize(most);
      asio::buffer_copy(asio::buffer(state->staged), out);
    }
  };

  StatePtr state_;
};

}  // namespace talus::server::websocket
