// Signals are the main thread's, which knows what they mean: all others leave them to it.
#pragma once

#include <csignal>
#include <future>
#include <utility>

namespace talus::server {

/// The calling thread gets no signal any more, nor do those that it starts.
void block_signals();

/// While it lives the calling thread gets no signal. So threads that a library starts meanwhile never do.
class SignalsBlocked {
 public:
  SignalsBlocked();
  ~SignalsBlocked();
  SignalsBlocked(const SignalsBlocked&) = delete;
  SignalsBlocked& operator=(const SignalsBlocked&) = delete;

 private:
  sigset_t before_{};
};

/// Does `work` on a thread of its own, which gets no signal, nor do those that it starts, and returns what
/// that returns: a signal that comes meanwhile is the calling thread's, which only waits.
template <typename Work>
auto without_signals(Work&& work) {
  return std::async(std::launch::async,
                    [&] {
                      block_signals();
                      return std::forward<Work>(work)();
                    })
      .get();
}

}  // namespace talus::server
