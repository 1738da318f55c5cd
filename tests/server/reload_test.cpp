#include "app/reload.h"

#include <catch2/catch.hpp>

using namespace talus::server;

TEST_CASE("settings that differ are named with both values, and when they count") {
  Config before;
  Config after;
  CHECK(changes_between(before, after).empty());
  after.limits.connections = 128;
  after.rates.session_bytes = 1000;
  after.rates.burst = milliseconds{500};
  after.access.blocked_file = "/etc/talus/blocked\n";
  after.user = "talus";
  after.limits.memory_bytes = 0;
  std::vector<std::string> lines;
  for (const SettingChange& change : changes_between(before, after)) lines.push_back(change.line);
  CHECK(lines == std::vector<std::string>{
                     "user: \"\" -> \"talus\" needs a restart; until then the old value counts",
                     "access.blocked_file: \"\" -> \"/etc/talus/blocked\\x0a\"",
                     "limits.connections: 2048 -> 128, for new sessions",
                     "limits.memory_bytes: 2147483648 -> 0 needs a restart; until then the old value counts",
                     "rates.session_bytes: 2097152 -> 1000", "rates.burst_ms: 32000 -> 500"});
}

TEST_CASE("a setting that needs a restart stays, and is named again the next time") {
  Config before;
  Config after;
  after.threads.io = 7;
  after.limits.view_chunks = 100;
  after.rates.address_chunks = 0;
  after.shutdown.drain = milliseconds{1};
  const Config changed = changed_while_running(before, after);
  CHECK(changed.threads.io == before.threads.io);
  CHECK(changed.limits.view_chunks == 100);
  CHECK(changed.rates.address_chunks == 0);
  CHECK(changed.shutdown.drain == milliseconds{1});
  REQUIRE(changes_between(changed, after).size() == 1);
  CHECK(changes_between(changed, after).front().counts == Counts::after_restart);
}
