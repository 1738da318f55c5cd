#include "generation/background_thread.h"

#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <thread>

using namespace talus::server;

namespace {

int niceness() {
  return ::getpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()));
}

bool blocks(int signal) {
  sigset_t blocked;
  ::pthread_sigmask(SIG_BLOCK, nullptr, &blocked);
  return ::sigismember(&blocked, signal) == 1;
}

}  // namespace

TEST_CASE("a thread that lowers its priority gives way to the others, which keep theirs") {
  const int before = niceness();
  int lowered = -100;
  std::thread{[&] {
    lower_priority();
    lowered = niceness();
  }}.join();
  CHECK(lowered == std::max(before, kBackgroundNiceness));
  CHECK(niceness() == before);
}

TEST_CASE("a thread that blocks signals gets none of them, and the others still do") {
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
