// How long a command waits for a server.
#pragma once

#include <chrono>
#include <memory>
#include <string>

#include <asio/any_io_executor.hpp>

#include <talus/client/client.h>

namespace talus::cli {

/// Closes a client, which fails all that it was asked, when its time is over. The client must outlive it.
class Patience {
 public:
  using Seconds = std::chrono::duration<double>;

  Patience(const asio::any_io_executor& executor, client::Client& client, Seconds time);

  /// What was asked for has come: the time begins anew. What comes unasked must not call this.
  void renew();

  [[nodiscard]] bool is_over() const;
  /// One line for a failed answer: that the time was over where it was, else what `error` says.
  [[nodiscard]] std::string explain(const client::ClientError& error) const;

 private:
  struct State;
  static void wait(const std::shared_ptr<State>& state);
  std::shared_ptr<State> state_;
};

}  // namespace talus::cli
