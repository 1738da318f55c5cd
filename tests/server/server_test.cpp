// A whole server in this process.
#include "app/server.h"

#include <signal.h>
#include <sys/resource.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <new>
#include <string>

#include <talus/terrain/world.h>

#include "app/settings.h"
#include "config/access/access_control.h"
#include "in_child.h"
#include "logged_lines.h"
#include "runtime/log/logger.h"

using namespace talus;
using namespace talus::server;

namespace {

auto handler_of(int signal) {
  struct sigaction now {};
  REQUIRE(::sigaction(signal, nullptr, &now) == 0);
  return now.sa_handler;
}

Config on_any_port() {
  Config config;
  config.listen = {"127.0.0.1", 0};
  config.admin = protocol::Endpoint{"127.0.0.1", 0};
  return config;
}

/// What a server logs that gets SIGHUP, and SIGTERM while it reads its settings again.
std::string log_of_reload(const Config& config, const ReadSettings& read_settings) {
  AccessControl access{config.access, *load_keys(config.access)};
  const SystemClock clock;
  const auto log = std::make_shared<LoggedLines>();
  {
    auto listeners = open_listeners(config, clock, log);
    REQUIRE(listeners.has_value());
    Server server{config,
                  ServedWorld{std::make_shared<const terrain::World>(terrain::default_world()), {}, {}},
                  ContentHash{},
                  access,
                  std::nullopt,
                  *std::move(listeners),
                  clock,
                  log,
                  [&] {
                    ::raise(SIGTERM);
                    return read_settings();
                  }};
    ::raise(SIGHUP);
    REQUIRE_NOTHROW(server.run());
  }
  for (const int signal : {SIGHUP, SIGTERM, SIGINT}) ::signal(signal, SIG_DFL);
  return log->text();
}

}  // namespace

TEST_CASE("an error while settings are read again does not end the server") {
  const auto lines =
      log_of_reload(on_any_port(), []() -> tl::expected<Config, std::string> { throw std::bad_alloc{}; });
  CHECK_THAT(lines, Catch::Contains("SIGHUP: std::bad_alloc; the old settings stay in use") &&
                        Catch::Contains("SIGTERM: no new connections"));
}

TEST_CASE("a list of revoked tokens that SIGHUP finds without any key is the error that it is at a start") {
  Config revoked = on_any_port();
  revoked.access.revoked_file = "revoked";
  CHECK_THAT(log_of_reload(on_any_port(), [&] { return revoked; }),
             Catch::Contains("SIGHUP: " + load_keys(revoked.access).error() + "; the old list stays"));
}

TEST_CASE("fewer connections by SIGHUP leave the limit of open files as it is") {
  const int wrong = in_child([] {
    Config fewer = on_any_port();
    const auto before = descriptors_wanted(fewer);
    fewer.limits.connections = 1;
    if (log_of_reload(on_any_port(), [&] { return fewer; }).find("2048 -> 1,") == std::string::npos) return 1;
    rlimit limit{};
    if (::getrlimit(RLIMIT_NOFILE, &limit) != 0) return 2;
    return limit.rlim_cur == std::min<rlim_t>(before, limit.rlim_max) ? 0 : 3;
  });
  CHECK(wrong == 0);
}

TEST_CASE("signals after the last client has left do not make the end a failure") {
  const Config config = on_any_port();
  AccessControl access{config.access, *load_keys(config.access)};
  const SystemClock clock;
  const Logger log = make_logger("off", "text");
  {
    auto listeners = open_listeners(config, clock, log);
    REQUIRE(listeners.has_value());
    Server server{
        config,        ServedWorld{std::make_shared<const terrain::World>(terrain::default_world()), {}, {}},
        ContentHash{}, access,
        std::nullopt,  *std::move(listeners),
        clock,         log};
    ::raise(SIGTERM);
    server.run();
    // Caches may take long to go from here on.
    CHECK(handler_of(SIGHUP) == SIG_IGN);
    for (const int signal : {SIGTERM, SIGINT}) CHECK(handler_of(signal) != SIG_DFL);
  }
  for (const int signal : {SIGHUP, SIGTERM, SIGINT}) ::signal(signal, SIG_DFL);
}
