// What other tests rely on: the servers are there, and what is done to them happens.
#include <asio/io_context.hpp>
#include <asio/ip/tcp.hpp>
#include <catch2/catch.hpp>

#include "nats_server.h"

using asio::ip::tcp;
using talus::nats_test::NatsServers;

TEST_CASE("three nats-servers know each other when they are handed out, and after one was killed") {
  NatsServers servers;
  REQUIRE(servers.count() == 3);
  CHECK(servers.page(0, "/healthz").find("ok") != std::string::npos);

  servers.kill(1);
  CHECK_FALSE(servers.runs(1));
  CHECK(servers.page(1, "/healthz").empty());
  servers.start(1);
  servers.await_ready();
  CHECK(servers.page(1, "/healthz").find("ok") != std::string::npos);
}

TEST_CASE("a frozen nats-server answers nothing until it goes on") {
  NatsServers servers{{.servers = 1}};
  servers.freeze(0);
  CHECK(servers.page(0, "/varz").empty());
  servers.go_on(0);
  CHECK_FALSE(servers.page(0, "/varz").empty());
}

TEST_CASE("a wrong configuration is reported with nats-server's text") {
  CHECK_THROWS_WITH(NatsServers({.servers = 1, .more = "no_such_key: 1"}), Catch::Contains("no_such_key"));
}

TEST_CASE("a killed nats-server's port is not given out as a free one") {
  NatsServers servers{{.servers = 1}};
  servers.kill(0);
  asio::io_context io;
  tcp::acceptor other{io, tcp::v4()};
  std::error_code taken;
  other.bind({asio::ip::address_v4::loopback(), servers.port(0)}, taken);
  CHECK(taken == asio::error::address_in_use);
  servers.start(0);
  CHECK_FALSE(servers.page(0, "/varz").empty());
}

TEST_CASE("a nats-server that does not start again says why") {
  NatsServers servers{{.servers = 1}};
  servers.kill(0);
  asio::io_context io;
  const tcp::acceptor other{io, {asio::ip::address_v4::loopback(), servers.port(0)}};
  CHECK_THROWS_WITH(servers.start(0), Catch::Contains("address already in use"));
}
