// A session's stream over any transport, so that the code that drives sessions is compiled once.
#pragma once

#include <cstddef>
#include <exception>
#include <memory>
#include <span>
#include <system_error>
#include <utility>

#include <asio/any_io_executor.hpp>
#include <asio/buffer.hpp>
#include <asio/co_spawn.hpp>

#include "net/stream.h"

namespace talus::server {

/// A Stream (net/stream.h) behind virtual functions.
class SessionStream {
 public:
  /// Receives the ends of operations, on the stream's executor and never from within the call that began
  /// them. Operations keep it alive.
  class User {
   public:
    virtual ~User() = default;
    virtual void on_read(std::error_code failed, std::size_t bytes) = 0;
    virtual void on_written(std::error_code failed, std::size_t bytes) = 0;
    virtual void on_end_said() = 0;
  };
  using UserPtr = std::shared_ptr<User>;

  /// Constants of Stream.
  struct Traits {
    bool writes_now = false;  // write_now() may take bytes
    bool writes_whole = false;
    std::size_t gather_from = 0;
  };

  explicit SessionStream(const Traits& traits) : traits_{traits} {}
  virtual ~SessionStream() = default;
  SessionStream(const SessionStream&) = delete;
  SessionStream& operator=(const SessionStream&) = delete;

  [[nodiscard]] const Traits& traits() const { return traits_; }
  [[nodiscard]] virtual asio::any_io_executor get_executor() = 0;
  virtual void read_some(asio::mutable_buffer into, UserPtr user) = 0;
  /// `from`, one buffer or more, and its bytes stay valid until the operation ends.
  virtual void write_some(std::span<const asio::const_buffer> from, UserPtr user) = 0;
  /// Does not wait. Returns the number of bytes that were taken; also 0 on an error, which write_some()
  /// reports.
  [[nodiscard]] virtual std::size_t write_now(asio::const_buffer from) = 0;
  [[nodiscard]] virtual bool peer_reset() = 0;
  /// Returns true if the peer will send nothing more, even if unread bytes remain.
  [[nodiscard]] virtual bool peer_hung_up() = 0;
  /// Bytes that the peer has sent and that wait for a read, as far as the system says.
  [[nodiscard]] virtual std::size_t unread() = 0;
  /// Returns true if the peer waits for say_end() after `failed`, the error of a read.
  [[nodiscard]] virtual bool answers(std::error_code failed) const = 0;
  virtual void say_end(UserPtr user) = 0;
  virtual void shutdown() = 0;
  virtual void close() = 0;
  [[nodiscard]] virtual std::size_t write_waits() const = 0;
  /// Bytes of the last read that the stream's protocol kept to itself.
  [[nodiscard]] virtual std::size_t own_bytes() const = 0;

 private:
  const Traits traits_;
};

template <Stream S>
class SessionStreamOf final : public SessionStream {
 public:
  explicit SessionStreamOf(S stream)
      : SessionStream{{kWritesNow, S::kWritesWhole, S::kGatherFrom}}, stream_{std::move(stream)} {}

  [[nodiscard]] asio::any_io_executor get_executor() override { return stream_.get_executor(); }
  void read_some(asio::mutable_buffer into, UserPtr user) override {
    stream_.async_read_some(into, [user = std::move(user)](std::error_code failed, std::size_t bytes) {
      user->on_read(failed, bytes);
    });
  }
  void write_some(std::span<const asio::const_buffer> from, UserPtr user) override {
    auto done = [user = std::move(user)](std::error_code failed, std::size_t bytes) {
      user->on_written(failed, bytes);
    };
    if (from.size() == 1) {  // a cheaper system call
      stream_.async_write_some(from.front(), std::move(done));
    } else {
      stream_.async_write_some(from, std::move(done));
    }
  }
  [[nodiscard]] std::size_t write_now([[maybe_unused]] asio::const_buffer from) override {
    if constexpr (kWritesNow) return stream_.write_now(from);
    return 0;
  }
  [[nodiscard]] bool peer_reset() override { return stream_.peer_reset(); }
  [[nodiscard]] bool peer_hung_up() override { return stream_.peer_hung_up(); }
  [[nodiscard]] std::size_t unread() override { return stream_.unread(); }
  [[nodiscard]] bool answers([[maybe_unused]] std::error_code failed) const override {
    if constexpr (requires { S::answers(failed); }) return S::answers(failed);
    return false;
  }
  void say_end(UserPtr user) override {
    asio::co_spawn(
        stream_.get_executor(), [this] { return stream_.say_end(); },
        [user = std::move(user)](const std::exception_ptr& /*failed*/) { user->on_end_said(); });
  }
  void shutdown() override { stream_.shutdown(); }
  void close() override { stream_.close(); }
  [[nodiscard]] std::size_t write_waits() const override { return stream_.write_waits(); }
  [[nodiscard]] std::size_t own_bytes() const override {
    if constexpr (requires { stream_.own_bytes(); }) return stream_.own_bytes();
    return 0;
  }

 private:
  static constexpr bool kWritesNow = requires(S & stream) { stream.write_now(asio::const_buffer{}); };

  S stream_;
};

}  // namespace talus::server
