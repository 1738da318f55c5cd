#include "net/refusal_log.h"

#include <algorithm>
#include <catch2/catch.hpp>

#include "logged_lines.h"
#include "runtime/manual_clock.h"

using namespace talus::server;
using namespace std::chrono_literals;

TEST_CASE("refusals within a second share one line, with how many and the last") {
  const auto lines = std::make_shared<LoggedLines>();
  ManualClock clock;
  RefusalLog log{lines, clock};
  log.note("192.0.2.1", "full");
  CHECK(lines->count() == 1);
  CHECK_THAT(lines->text(), Catch::Contains("refused 192.0.2.1: full (1 refused since the last such line)"));
  log.note("192.0.2.2", "full");
  log.note("192.0.2.3", "too fast");
  clock.advance(999ms);
  log.flush();
  CHECK(lines->count() == 1);
  clock.advance(1ms);
  log.flush();
  CHECK(lines->count() == 2);
  CHECK_THAT(lines->text(),
             Catch::Contains("refused 192.0.2.3: too fast (2 refused since the last such line)"));
  clock.advance(1s);
  log.flush();
  CHECK(lines->count() == 2);
}
