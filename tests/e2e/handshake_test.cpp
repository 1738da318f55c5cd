// Hello, and everything that may come in its place.
#include <catch2/catch.hpp>

#include <talus/terrain/world.h>
#include <talus/voxel/codec.h>

#include "messages.h"
#include "raw_client.h"
#include "served_world.h"
#include "server_process.h"

using namespace talus;
using namespace talus::e2e;

namespace {

/// The next frame is this Error, and after it the connection closes; returns its text.
std::string closing_error(RawClient& client, wire::ErrorCode code) {
  const ReceivedFrame received = client.expect();
  const auto& error = received.as<wire::Error>();
  CHECK(std::string{wire::EnumNameErrorCode(error.code())} == wire::EnumNameErrorCode(code));
  CHECK(client.closed());
  return error.text()->str();
}

}  // namespace

TEST_CASE("Welcome describes the world and the limits") {
  const ServerProcess server{{{"TALUS_LIMITS_REQUESTS_IN_FLIGHT", "77"}}};
  RawClient client{server.port()};
  REQUIRE(client.send(hello({.window_bytes = 5000})));
  const ReceivedFrame received = client.expect();
  const auto& welcome = received.as<wire::Welcome>();

  const terrain::World& world = served_world();
  CHECK(welcome.protocol() == protocol::kProtocolVersion);
  CHECK(welcome.codec() == kCodecVersion);
  CHECK(hash_of(*welcome.fingerprint()) == world.fingerprint());
  CHECK(hash_of(*welcome.store_id()) == ContentHash{});
  CHECK(welcome.chunk_size() == kChunkSize);
  CHECK(welcome.limits()->requests_in_flight() == 77);
  CHECK(welcome.limits()->window_bytes() == 5000);
  REQUIRE(welcome.materials()->size() == world.materials().size());
  CHECK(welcome.materials()->Get(0)->phase() == wire::Phase::gas);
  CHECK(welcome.materials()->Get(1)->phase() == wire::Phase::liquid);
  CHECK(welcome.materials()->Get(2)->name()->str() == world.materials()[2].name);
}

TEST_CASE("a client of another version receives both versions") {
  const ServerProcess server;
  const bool future = GENERATE(true, false);
  RawClient client{server.port()};
  const HelloFields fields =
      future ? HelloFields{.oldest = 7, .newest = 9} : HelloFields{.oldest = 0, .newest = 0};
  REQUIRE(client.send(hello(fields)));
  const std::string text = closing_error(client, wire::ErrorCode::version);
  CHECK_THAT(text, Catch::Contains("speaks protocol version 2,"));
  CHECK_THAT(text, Catch::Contains(future ? "versions 7 to 9" : "version 0"));
}

TEST_CASE("a client without a common codec receives both codecs") {
  const ServerProcess server;
  RawClient client{server.port()};
  REQUIRE(client.send(hello({.codecs = {99, 98}})));
  CHECK_THAT(closing_error(client, wire::ErrorCode::version), Catch::Contains("99, 98"));
}

TEST_CASE("nothing may come before Hello") {
  const ServerProcess server;
  RawClient client{server.port()};
  REQUIRE(client.send(ping(1)));
  CHECK_THAT(closing_error(client, wire::ErrorCode::unexpected), Catch::Contains("Hello"));
}

TEST_CASE("a second Hello closes the connection") {
  const ServerProcess server;
  RawClient client = greeted(server.port());
  REQUIRE(client.send(hello()));
  closing_error(client, wire::ErrorCode::unexpected);
}

TEST_CASE("a message of servers closes the connection") {
  const ServerProcess server;
  RawClient client = greeted(server.port());
  REQUIRE(client.send(protocol::make_frame([](auto& builder) { return wire::CreatePong(builder, 1); })));
  CHECK_THAT(closing_error(client, wire::ErrorCode::unexpected), Catch::Contains("Pong"));
}
