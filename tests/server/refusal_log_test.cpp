#include "net/refusal_log.h"

#include <spdlog/sinks/ostream_sink.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <sstream>

#include "runtime/manual_clock.h"

using namespace talus::server;
using namespace std::chrono_literals;

TEST_CASE("refusals within a second share one line, with how many and the last") {
  std::ostringstream out;
  ManualClock clock;
  RefusalLog log{
      std::make_shared<spdlog::logger>("test", std::make_shared<spdlog::sinks::ostream_sink_st>(out)), clock};
  const auto lines = [&] {
    const std::string text = out.str();
    return std::count(text.begin(), text.end(), '\n');
  };
  log.note("192.0.2.1", "full");
  CHECK(lines() == 1);
  CHECK_THAT(out.str(), Catch::Contains("refused 192.0.2.1: full (1 refused since the last such line)"));
  log.note("192.0.2.2", "full");
  log.note("192.0.2.3", "too fast");
  clock.advance(999ms);
  log.flush();
  CHECK(lines() == 1);
  clock.advance(1ms);
  log.flush();
  CHECK(lines() == 2);
  CHECK_THAT(out.str(), Catch::Contains("refused 192.0.2.3: too fast (2 refused since the last such line)"));
  clock.advance(1s);
  log.flush();
  CHECK(lines() == 2);
}
