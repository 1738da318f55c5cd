// Only the main thread handles signals; all other threads block them.
#pragma once

#include <csignal>
#include <future>
#include <utility>

namespace talus::server {

/// Blocks all signals in the calling thread and in the threads that it starts.
void block_signals();

/// Blocks signals in the calling thread during its lifetime, and so for ever in threads that a library starts
/// meanwhile.
class SignalBlocker {
 public:
  SignalBlocker();
  ~SignalBlocker();
  SignalBlocker(const SignalBlocker&) = delete;
  SignalBlocker& operator=(const SignalBlocker&) = delete;

 private:
  sigset_t before_{};
};

/// Runs `work` on a new thread that blocks signals, as do the threads that it starts, and returns its result.
/// A signal that arrives meanwhile goes to the calling thread, which only waits.
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
