// What a session lets a client do by its token.
#include <asio/io_context.hpp>
#include <asio/write.hpp>
#include <catch2/catch.hpp>
#include <thread>

#include <talus/voxel/codec.h>

#include "access/signed_token.h"
#include "fake_generator.h"
#include "frames.h"
#include "net/connection.h"
#include "scratch_directory.h"
#include "session/session.h"

using namespace talus;
using namespace talus::server;
using asio::ip::tcp;

namespace {

const std::string kKey = "0123456789abcdef0123456789abcdef";

std::chrono::sys_seconds now() {
  return std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now());
}

std::string token(const Claims& claims) {
  return *make_signed_token(Secret{kKey}, claims, now());
}

protocol::Frame hello(const std::string& token) {
  return protocol::make_frame([&](auto& builder) {
    const auto codecs = builder.CreateVector(std::vector{kCodecVersion});
    const auto shown = builder.CreateString(token);
    return wire::CreateHello(builder, 1, 1, codecs, shown);
  });
}

struct SaidError {
  wire::ErrorCode code;
  std::string text;
  std::uint32_t request_id;
};

/// What sessions share, with a signing key.
struct Shared {
  ScratchDirectory scratch;
  Access settings{{}, "read", scratch.write("key", kKey), "auto"};
  AccessControl access{settings, *load_keys(settings)};
  FakeService fake;
  Limits limits;
  WorldInfo world;
  SessionContext context{limits, world, fake.service, fake.memory, fake.metrics, access};
};

struct Bench : Shared {
  Session session{context};

  Bench() {
    session.attach(std::make_shared<Mailbox>(ClientId{1}, [] {}));
  }

  /// Its output, which must be one Error.
  SaidError error() {
    const auto frames = cut(session.take_output(1 << 20));
    REQUIRE(frames.size() == 1);
    const wire::Message& message = **protocol::read_message(frames[0]);
    REQUIRE(message.body_type() == wire::Body::Error);
    const wire::Error& error = *message.body_as_Error();
    return {error.code(), error.text()->str(), error.request_id()};
  }
  void edit() {
    session.receive(protocol::make_frame([](auto& builder) { return wire::CreateEdit(builder, 5); }));
  }
};

}  // namespace

TEST_CASE("without a token a session ends with an Error that asks for one") {
  Bench bench;
  bench.session.receive(hello(""));
  const auto error = bench.error();
  CHECK(error.code == wire::ErrorCode::unauthorized);
  CHECK_THAT(error.text, Catch::Contains("token"));
  CHECK(bench.session.closing());
  CHECK_FALSE(bench.session.greeted());
  CHECK(bench.fake.metrics.denied(AuthFailure::missing).total() == 1);
}

TEST_CASE("a client learns of its token that it expired or is not accepted, and the log learns why") {
  const auto [shown, text, why] = GENERATE(table<std::string, std::string, std::string>(
      {{token({"a", {Right::read}, now() - std::chrono::hours{1}}), "the token has expired", "it expired 36"},
       {token({"a", {Right::read}, now() + std::chrono::hours{1}}) + "A", "the token is not accepted",
        "signature"},
       {"guess", "the token is not accepted", "no signed token"}}));
  Bench bench;
  bench.session.receive(hello(shown));
  const auto error = bench.error();
  CHECK(error.code == wire::ErrorCode::unauthorized);
  CHECK(error.text == text);
  CHECK_THAT(bench.session.failure(), Catch::Contains(text) && Catch::Contains(why));
  const AuthFailure failure = text.ends_with("expired") ? AuthFailure::expired : AuthFailure::not_accepted;
  CHECK(bench.fake.metrics.denied(failure).total() == 1);
}

TEST_CASE("who may not edit is told so, and stays") {
  Bench bench;
  bench.session.receive(hello(token({"a", {Right::read}, now() + std::chrono::hours{1}})));
  (void)bench.session.take_output(1 << 20);
  bench.edit();
  const auto error = bench.error();
  CHECK(error.code == wire::ErrorCode::forbidden);
  CHECK(error.request_id == 5);
  CHECK_FALSE(bench.session.closing());
}

TEST_CASE("who may edit is told what everyone is told who may") {
  Bench bench;
  bench.session.receive(hello(token({"a", {Right::read, Right::edit}, now() + std::chrono::hours{1}})));
  (void)bench.session.take_output(1 << 20);
  bench.edit();
  CHECK(bench.error().code == wire::ErrorCode::unsupported);
}

TEST_CASE("a session ends when its token does") {
  Shared shared;
  asio::io_context io{1};
  Admission admission{1, 1};
  Registry registry;
  tcp::socket client{io};
  tcp::acceptor acceptor{io, {asio::ip::address_v4::loopback(), 0}};
  client.connect(acceptor.local_endpoint());
  const ConnectionContext context{shared.context, registry, std::make_shared<spdlog::logger>("silent")};
  const auto connection = std::make_shared<Connection>(
      Guest{1, Wire{acceptor.accept()}, "test", *admission.enter(asio::ip::address_v4::loopback()),
            std::chrono::steady_clock::now()},
      context);
  registry.add(1, connection);
  connection->start();
  std::thread thread{[&] { io.run(); }};

  // It is good for a second or two: over, but for the difference of clocks that is allowed.
  asio::write(client,
              asio::buffer(hello(token({"a", {Right::read}, now() - kClockSkew + std::chrono::seconds{2}}))));
  protocol::FrameReader frames{protocol::kServerFrameBytes};
  std::vector<wire::Body> kinds;
  std::string last;
  std::error_code ended;
  std::array<std::byte, 4096> buffer{};
  while (!ended) {
    std::span<const std::byte> bytes{buffer.data(), client.read_some(asio::buffer(buffer), ended)};
    while (!bytes.empty()) {
      bytes = bytes.subspan(*frames.feed(bytes));
      if (!frames.has_frame()) continue;
      const wire::Message& message = **protocol::read_message(frames.frame());
      kinds.push_back(message.body_type());
      if (const auto* error = message.body_as_Error()) last = error->text()->str();
      frames.pop();
    }
  }
  client.close();
  thread.join();
  CHECK(kinds == std::vector{wire::Body::Welcome, wire::Body::Error});
  CHECK(last == "the token has expired");
  CHECK(shared.fake.metrics.denied(AuthFailure::expired).total() == 1);
}
