// The client by TLS, against a server that a test writes down.
#include <asio/ssl.hpp>
#include <asio/use_awaitable.hpp>
#include <asio/write.hpp>
#include <catch2/catch.hpp>

#include "certificates.h"
#include "peer.h"
#include "scratch_directory.h"

namespace talus::client {
namespace {

using namespace testing;

struct Secure {
  asio::io_context io;
  asio::ip::tcp::acceptor acceptor{io, {asio::ip::address_v4::loopback(), 0}};
  TestCertificate own;
  ScratchDirectory scratch;
  asio::ssl::context context{asio::ssl::context::tls_server};
  Options options;

  explicit Secure(const TestCertificate& certificate = make_certificate(1)) : own{certificate} {
    context.use_certificate(asio::buffer(own.certificate), asio::ssl::context::pem);
    context.use_private_key(asio::buffer(own.key), asio::ssl::context::pem);
    options.tls.on = true;
    options.tls.ca_file = scratch.write("ca.pem", own.certificate);
  }

  /// Shakes hands if the client does, and welcomes it.
  asio::awaitable<void> serve() {
    auto socket = co_await acceptor.async_accept(asio::use_awaitable);
    asio::ssl::stream<asio::ip::tcp::socket> stream{std::move(socket), context};
    try {
      co_await stream.async_handshake(asio::ssl::stream_base::server, asio::use_awaitable);
      const auto welcome = welcome_frame(42, 1U << 20, 64, 60'000);
      co_await asio::async_write(stream, asio::buffer(welcome), asio::use_awaitable);
      std::array<std::byte, 256> unread{};
      for (;;) co_await stream.async_read_some(asio::buffer(unread), asio::use_awaitable);
    } catch (const std::system_error&) {
      // The client left.
    }
  }

  Result<WorldInfo> visited(const std::string& host = "127.0.0.1") {
    return visited_while([this] { return serve(); }, host);
  }
  Result<WorldInfo> visited_while(const Script& server, const std::string& host = "127.0.0.1") {
    std::optional<Result<WorldInfo>> joined;
    io.restart();
    run(io, {[&]() -> asio::awaitable<void> {
               Client client{io.get_executor(), options};
               joined = co_await client.connect(host, std::to_string(acceptor.local_endpoint().port()));
             },
             server});
    return *joined;
  }
};

void check_failed(const Result<WorldInfo>& world, ErrorKind kind, const std::string& part) {
  REQUIRE_FALSE(world.has_value());
  INFO(world.error().message);
  CHECK(world.error().kind == kind);
  CHECK_THAT(world.error().message, Catch::Contains(part));
}

}  // namespace

TEST_CASE("a client by TLS joins a server that proves who it is") {
  Secure secure;
  const auto world = secure.visited();
  REQUIRE(world.has_value());
  CHECK(world->fingerprint == ContentHash{42, 0});
}

TEST_CASE("a client by TLS does not trust a server with an untrusted certificate") {
  Secure secure;
  secure.options.tls.ca_file = secure.scratch.write("other.pem", make_certificate(2).certificate);
  check_failed(secure.visited(), ErrorKind::untrusted, "certificate verify failed: self-signed certificate");
  secure.options.tls.ca_file.clear();  // those that the system trusts
  check_failed(secure.visited(), ErrorKind::untrusted, "--ca FILE");
}

TEST_CASE("a client by TLS does not trust a server with another name, unless it expects that name") {
  Secure secure{make_certificate(1, "talus.example")};
  check_failed(secure.visited(), ErrorKind::untrusted, "--tls-name NAME");
  check_failed(secure.visited("localhost"), ErrorKind::untrusted, "--tls-name NAME");
  secure.options.tls.server_name = "talus.example";
  CHECK(secure.visited().has_value());
}

TEST_CASE("a client by TLS does not trust a certificate that has ended") {
  Secure secure{make_certificate(1, "localhost", -1)};
  check_failed(secure.visited(), ErrorKind::untrusted, "certificate has expired");
}

TEST_CASE("a client without verification joins any server") {
  Secure secure{make_certificate(1, "talus.example", -1)};
  secure.options.tls.ca_file.clear();
  secure.options.tls.verify = false;
  CHECK(secure.visited().has_value());
}

TEST_CASE("an invalid file of authorities is named") {
  Secure secure;
  secure.options.tls.ca_file = secure.scratch.write("garbage", "no PEM\n");
  check_failed(secure.visited(), ErrorKind::untrusted, secure.options.tls.ca_file);
}

TEST_CASE("a client by TLS says so where the server does not speak it") {
  Secure secure;
  const auto answer_plainly = [&]() -> asio::awaitable<void> {
    auto socket = co_await secure.acceptor.async_accept(asio::use_awaitable);
    std::array<std::byte, 4096> hello{};
    (void)co_await socket.async_read_some(asio::buffer(hello), asio::use_awaitable);
    const auto error = error_frame(wire::ErrorCode::malformed, "no frame");
    co_await asio::async_write(socket, asio::buffer(error), asio::use_awaitable);
  };
  check_failed(secure.visited_while(answer_plainly), ErrorKind::unreachable, "does not speak TLS");
}

TEST_CASE("a client by TLS gives up on a server that says nothing") {
  Secure secure;
  secure.options.connect_timeout = std::chrono::milliseconds{50};
  const auto say_nothing = [&]() -> asio::awaitable<void> {
    auto socket = co_await secure.acceptor.async_accept(asio::use_awaitable);
    std::array<std::byte, 4096> unread{};
    try {
      for (;;) (void)co_await socket.async_read_some(asio::buffer(unread), asio::use_awaitable);
    } catch (const std::system_error&) {
      // The client left.
    }
  };
  check_failed(secure.visited_while(say_nothing), ErrorKind::timed_out, "in time");
}

TEST_CASE("a plain client hints at TLS where the server ends without a word") {
  Secure secure;
  secure.options.tls = {};
  check_failed(secure.visited(), ErrorKind::disconnected, "--tls");
}

}  // namespace talus::client
