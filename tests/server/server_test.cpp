// A whole server in this process.
#include "app/server.h"

#include <signal.h>

#include <catch2/catch.hpp>

#include <talus/terrain/world.h>

#include "access/access_control.h"
#include "log/logger.h"

using namespace talus;
using namespace talus::server;

namespace {

auto handler_of(int signal) {
  struct sigaction now {};
  REQUIRE(::sigaction(signal, nullptr, &now) == 0);
  return now.sa_handler;
}

}  // namespace

TEST_CASE("signals that come when nobody is served any more do not make a failure of the end") {
  Config config;
  config.listen = {"127.0.0.1", 0};
  config.admin = protocol::Endpoint{"127.0.0.1", 0};
  AccessControl access{config.access, *load_keys(config.access)};
  const SystemClock clock;
  const Logger log = make_logger("off", "text");
  {
    auto listeners = open_listeners(config, clock, log);
    REQUIRE(listeners.has_value());
    Server server{config,        std::make_shared<const terrain::World>(terrain::default_world()),
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
