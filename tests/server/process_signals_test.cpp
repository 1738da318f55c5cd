#include "app/process_signals.h"

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>

#include "runtime/signals.h"

using namespace talus::server;

namespace {

/// How a child ends that does `what` and then sends itself `number`: 128 + number where the signal ended it,
/// its exit status, or 77 where it went on.
int ended_by(int number, void (*what)()) {
  const pid_t child = ::fork();
  if (child == 0) {
    ::signal(number, SIG_DFL);
    what();
    ::raise(number);
    ::_exit(77);
  }
  int status = 0;
  REQUIRE(::waitpid(child, &status, 0) == child);
  return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

}  // namespace

TEST_CASE("before the server serves, signals end the process as done, and SIGHUP does nothing") {
  CHECK(ended_by(SIGTERM, end_at_once_on_signals) == 0);
  CHECK(ended_by(SIGINT, end_at_once_on_signals) == 0);
  CHECK(ended_by(SIGHUP, end_at_once_on_signals) == 77);
}

TEST_CASE("commands without clients end by a signal as other programs do") {
  const auto both = [] {
    end_at_once_on_signals();
    end_by_default_on_signals();
  };
  CHECK(ended_by(SIGTERM, both) == 128 + SIGTERM);
  CHECK(ended_by(SIGINT, both) == 128 + SIGINT);
}

TEST_CASE("a signal ends the process while work is done that no signal reaches") {
  const auto works = [] {
    end_at_once_on_signals();
    without_signals([] {
      ::kill(::getpid(), SIGTERM);
      for (;;) ::pause();
    });
  };
  CHECK(ended_by(SIGTERM, works) == 0);
  CHECK(without_signals([] { return 7; }) == 7);
}
