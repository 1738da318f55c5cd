#include "runtime/signals.h"

#include <signal.h>

namespace talus::server {
namespace {

sigset_t all_signals() {
  sigset_t all;
  ::sigfillset(&all);
  return all;
}

}  // namespace

void block_signals() {
  const sigset_t all = all_signals();
  ::pthread_sigmask(SIG_BLOCK, &all, nullptr);
}

SignalBlocker::SignalBlocker() {
  const sigset_t all = all_signals();
  ::pthread_sigmask(SIG_BLOCK, &all, &before_);
}

SignalBlocker::~SignalBlocker() {
  ::pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

}  // namespace talus::server
