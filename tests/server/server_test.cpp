// A whole server in this process.
#include "net/server.h"

#include <signal.h>

#include <catch2/catch.hpp>

#include <talus/terrain/world.h>

#include "access/access_control.h"
#include "log/logger.h"
#include "scratch_directory.h"

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
  const ScratchDirectory scratch;
  AccessControl access{config.access, *load_keys(config.access)};
  {
    Server server{config, std::make_shared<const terrain::World>(terrain::default_world()), access,
                  std::nullopt, make_logger("off", "text")};
    REQUIRE(server.listen().has_value());
    ::raise(SIGTERM);
    server.run();
    // Caches may take long to go from here on.
    CHECK(handler_of(SIGHUP) == SIG_IGN);
    for (const int signal : {SIGTERM, SIGINT}) CHECK(handler_of(signal) != SIG_DFL);
  }
  for (const int signal : {SIGHUP, SIGTERM, SIGINT}) ::signal(signal, SIG_DFL);
}
