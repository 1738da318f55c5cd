#include "chunks/generation/background_thread.h"

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
