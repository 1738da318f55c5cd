// Limits how long a command waits for a server.
#pragma once

#include <chrono>
#include <memory>
#include <string>

#include <asio/any_io_executor.hpp>

#include <talus/client/client.h>

namespace talus::cli {

/// Closes a client after the time, failing its requests. The client and `clock` must outlive this.
class RequestTimeout {
 public:
  using Seconds = std::chrono::duration<double>;

  RequestTimeout(const asio::any_io_executor& executor, client::Clock& clock, client::Client& client,
                 Seconds time);

  /// Restarts the time after an answer to a request. Must not be called for unsolicited messages.
  void restart();

  [[nodiscard]] bool has_expired() const;
  /// One line for a failed request: the timeout if it expired, otherwise the error's message.
  [[nodiscard]] std::string explain(const client::ClientError& error) const;

 private:
  struct State;
  static void wait(const std::shared_ptr<State>& state);
  std::shared_ptr<State> state_;
};

}  // namespace talus::cli
