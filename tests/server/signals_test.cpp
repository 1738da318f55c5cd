// Who gets signals.
#include "runtime/signals.h"

#include <signal.h>

#include <catch2/catch.hpp>
#include <thread>

using namespace talus::server;

namespace {

bool blocks(int signal) {
  sigset_t blocked;
  ::pthread_sigmask(SIG_BLOCK, nullptr, &blocked);
  return ::sigismember(&blocked, signal) == 1;
}

}  // namespace

TEST_CASE("a thread that blocks signals does not receive them, and the others still do") {
  const bool before = blocks(SIGTERM);
  bool term = false;
  bool hangup = false;
  std::thread{[&] {
    block_signals();
    term = blocks(SIGTERM);
    hangup = blocks(SIGHUP);
  }}.join();
  CHECK(term);
  CHECK(hangup);
  CHECK(blocks(SIGTERM) == before);
}

TEST_CASE("threads that are started while signals are blocked never get them, and the starter does again") {
  const bool before = blocks(SIGTERM);
  bool term = false;
  std::thread started;
  {
    const SignalBlocker blocked;
    started = std::thread{[&] { term = blocks(SIGTERM); }};
  }
  started.join();
  CHECK(term);
  CHECK(blocks(SIGTERM) == before);
}
