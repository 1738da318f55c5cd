// Signals are the main thread's, which knows what they mean: all others leave them to it.
#pragma once

#include <csignal>

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

}  // namespace talus::server
