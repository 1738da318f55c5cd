// How long a command waits for a server.
#pragma once

#include <chrono>
#include <memory>
#include <string>

#include <asio/any_io_executor.hpp>

#include <talus/client/client.h>

namespace talus::cli {

/// Closes a client, which fails all its requests, when the time is over. The client and `clock` outlive it.
class RequestTimeout {
 public:
  using Seconds = std::chrono::duration<double>;

  RequestTimeout(const asio::any_io_executor& executor, client::Clock& clock, client::Client& client,
                 Seconds time);

  /// An answer to a request has come: the time begins anew. What comes without a request must not call this.
  void restart();

  [[nodiscard]] bool has_expired() const;
  /// One line for a failed request: that the time was over where it was, else the error's message.
  [[nodiscard]] std::string explain(const client::ClientError& error) const;

 private:
  struct State;
  static void wait(const std::shared_ptr<State>& state);
  std::shared_ptr<State> state_;
};

}  // namespace talus::cli
