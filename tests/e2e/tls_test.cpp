// talusd by TLS: what a client gets over it, and what an operator does with its files.
#include "tls_client.h"

#include <signal.h>

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <list>

#include <talus/protocol/limits.h>
#include <talus/tls/context.h>
#include <talus/tls/session.h>

#include "certificates.h"
#include "messages.h"
#include "raw_client.h"
#include "scratch_directory.h"
#include "server_process.h"
#include "worked_for.h"

using namespace talus;
using namespace talus::e2e;

namespace {

/// A server with a certificate of serial 1, in files that a test may write anew.
struct Secure {
  ScratchDirectory scratch;
  std::string certificate;
  std::string key;

  Secure() { write(make_certificate(1)); }
  void write(const TestCertificate& own) {
    certificate = scratch.write("certificate.pem", own.certificate);
    key = scratch.write("key.pem", own.key);
  }
  [[nodiscard]] Settings settings(Settings more = {}) const {
    more.insert({{"TALUS_TLS_CERTIFICATE", certificate}, {"TALUS_TLS_KEY", key}});
    return more;
  }
};

void greet(TlsClient& client) {
  REQUIRE_FALSE(client.failure());
  client.send(hello());
  (void)client.expect_kind<wire::Welcome>();
}

void ask_for_chunk(TlsClient& client) {
  client.send(get_chunks({chunk_request(1, at(0, 0, 0))}));
  (void)client.expect_kind<wire::Chunk>();
}

long serial_now(const ServerProcess& server) {
  TlsClient client{server.port()};
  REQUIRE_FALSE(client.failure());
  return client.serial();
}

}  // namespace

TEST_CASE("by TLS a client is welcomed and gets chunks") {
  const Secure secure;
  const ServerProcess server{secure.settings()};
  TlsClient client{server.port()};
  greet(client);
  ask_for_chunk(client);
}

TEST_CASE("by TLS work for a client that is gone while its reading is paused is given up") {
  if (kSanitized) return;  // a column takes too long; session_gone_test has the same cases
  const Secure secure;
  ServerProcess server{secure.settings(kDearColumns), {"--admin", "127.0.0.1:0"}};
  const std::uint16_t admin = server.admin_port();
  std::list<TlsClient> clients;
  for (std::uint32_t client = 0; client < kDearClients; ++client) {
    greet(clients.emplace_back(server.port()));
    for (std::uint32_t id = 1; id <= kDearRequests; ++id) {
      clients.back().send(get_heights(id, far_columns(client * kDearRequests + id)));
    }
  }
  const double before = await_pauses(admin);
  for (TlsClient& each : clients) each.reset();
  check_given_up(admin, before);
}

TEST_CASE("by TLS a View comes whole, through many records") {
  const Secure secure;
  const ServerProcess server{secure.settings()};
  TlsClient client{server.port()};
  client.send(hello({.window_bytes = 4U << 20}));
  (void)client.expect_kind<wire::Welcome>();
  client.send(view({.centre = {0, 0, 0}, .horizontal_radius = 6, .vertical_radius = 0}));
  int columns = 0;
  std::size_t bytes = 0;
  while (columns < 13 * 13) {
    const auto received = client.receive();
    REQUIRE(received.has_value());
    columns += received->kind() == wire::Body::Chunk || received->kind() == wire::Body::UniformColumn ? 1 : 0;
    bytes += received->bytes();
    client.send(credit(bytes));
  }
}

TEST_CASE("by TLS a client that says close_notify gets all that it asked for, and then the end") {
  const Secure secure;
  const ServerProcess server{secure.settings()};
  asio::io_context io;
  asio::ip::tcp::socket socket{io};
  socket.connect({asio::ip::address_v4::loopback(), server.port()});
  const tls::Context context = tls::new_context(tls::Role::client);
  tls::Session session{context, tls::Role::client, socket.native_handle()};  // each step blocks
  REQUIRE(session.handshake().result == tls::Step::Result::done);
  const auto send = [&](const protocol::Frame& frame) {
    REQUIRE(session.write(frame).bytes == frame.size());
  };
  send(hello({.window_bytes = 1000}));
  std::vector<wire::ChunkRequest> requests;
  for (std::uint32_t id = 1; id <= 50; ++id) {
    requests.push_back(chunk_request(id, at(static_cast<std::int32_t>(id), 1, -700)));
  }
  send(get_chunks(requests));
  REQUIRE(session.close_notify().result == tls::Step::Result::done);
  protocol::FrameReader frames{protocol::kServerFrameBytes};
  std::array<std::byte, 4096> buffer{};
  int chunks = 0;
  for (;;) {
    const tls::Step step = session.read(buffer);
    if (step.result == tls::Step::Result::closed) break;
    REQUIRE(step.result == tls::Step::Result::done);
    for (std::span<const std::byte> bytes = std::span{buffer}.first(step.bytes); !bytes.empty();) {
      bytes = bytes.subspan(frames.feed(bytes).value());
      if (!frames.has_frame()) continue;
      chunks += (*protocol::read_message(frames.frame()))->body_type() == wire::Body::Chunk ? 1 : 0;
      frames.pop();
    }
  }
  CHECK(chunks == 50);
}

TEST_CASE("a TLS 1.2 client is refused") {
  const Secure secure;
  const ServerProcess server{secure.settings()};
  const TlsClient client{server.port(), "", TLS1_2_VERSION};
  CHECK_THAT(client.failure().message(), Catch::Contains("protocol version"));
}

TEST_CASE("after SIGHUP new connections get the new certificate, and older ones continue") {
  Secure secure;
  ServerProcess server{secure.settings()};
  TlsClient before{server.port()};
  greet(before);
  CHECK(before.serial() == 1);
  secure.write(make_certificate(2));
  server.signal(SIGHUP);
  (void)server.await_line("SIGHUP: TLS with certificate of " + secure.certificate);
  CHECK(serial_now(server) == 2);
  ask_for_chunk(before);
}

TEST_CASE("a certificate that cannot be read again is one line, and the old one stays") {
  Secure secure;
  ServerProcess server{secure.settings()};
  secure.write({make_certificate(2).certificate, make_certificate(3).key});
  server.signal(SIGHUP);
  CHECK_THAT(server.await_line("SIGHUP: "), Catch::Contains("error") && Catch::Contains(secure.key) &&
                                                Catch::Contains("is not the key of the certificate in"));
  secure.scratch.write("certificate.pem", "garbage");
  server.signal(SIGHUP);
  CHECK_THAT(server.await_line("SIGHUP: "), Catch::Contains("holds no certificate"));
  std::filesystem::remove(secure.certificate);
  server.signal(SIGHUP);
  CHECK_THAT(server.await_line("SIGHUP: "), Catch::Contains("No such file"));
  CHECK(serial_now(server) == 1);
}

TEST_CASE("SIGHUP to a plain server is a line, and it goes on") {
  ServerProcess server;
  server.signal(SIGHUP);
  (void)server.await_line("SIGHUP: nothing to read again");
  (void)greeted(server.port());
}

TEST_CASE("a start and --check-config end with one line where key and certificate do not fit") {
  Secure secure;
  secure.write({make_certificate(2).certificate, make_certificate(3).key});
  const std::vector<std::string> start{"--listen", "127.0.0.1:0"};
  for (const auto& flags : {start, std::vector<std::string>{"--check-config"}}) {
    const ProgramResult ended = run_talusd(flags, secure.settings());
    CHECK(ended.status == 1);
    CHECK(std::count(ended.err.begin(), ended.err.end(), '\n') == 1);
    CHECK_THAT(ended.err, Catch::StartsWith("talusd: TALUS_TLS_KEY: tls.key " + secure.key));
  }
}

TEST_CASE("a client that does not answer the end of TLS cannot hold its connection") {
  const Secure secure;
  const ServerProcess server{secure.settings()};
  TlsClient client{server.port()};
  REQUIRE_FALSE(client.failure());
  client.send(protocol::Frame(64, std::byte{0xFF}));  // no frame
  (void)client.expect_kind<wire::Error>();
  CHECK_FALSE(client.receive().has_value());
  CHECK(client.ended() == asio::error::eof);
  client.await_close();
}

TEST_CASE("a client by TLS through a proxy counts and is logged under the address from the proxy") {
  const Secure secure;
  ServerProcess server{secure.settings({{"TALUS_PROXIES", "127.0.0.1"}})};
  const std::string header{"\r\n\r\n\0\r\nQUIT\n\x21\x11\0\x0C\xCB\0\x71\x07\x7F\0\0\x01\xC0\x01\x12\xAC",
                           28};
  TlsClient client{server.port(), header};
  greet(client);
  CHECK_THAT(server.await_line("hello from"), Catch::Contains("203.0.113.7:49153"));
}

TEST_CASE("one of the proxies that sends no PROXY header is refused in one line") {
  ServerProcess server{{{"TALUS_PROXIES", "127.0.0.0/8"}}};
  RawClient client{server.port()};
  REQUIRE(client.send(hello()));
  CHECK(client.closed());
  CHECK_THAT(server.await_line("refused 127.0.0.1:"), Catch::Contains("sent no PROXY header of version 2"));
}

TEST_CASE("a PROXY header from an address outside proxies is a broken frame") {
  const ServerProcess server;
  RawClient client{server.port()};
  const std::string header{"\r\n\r\n\0\r\nQUIT\n\x21\x11\0\x0C\xCB\0\x71\x07\x7F\0\0\x01\xC0\x01\x12\xAC",
                           28};
  REQUIRE(client.send(std::as_bytes(std::span{header})));
  CHECK(client.expect().as<wire::Error>().code() == wire::ErrorCode::too_large);
}

TEST_CASE("a draining server asks clients by TLS to leave") {
  const Secure secure;
  ServerProcess server{secure.settings()};
  TlsClient client{server.port()};
  greet(client);
  server.signal(SIGTERM);
  (void)client.expect_kind<wire::GoAway>();
  CHECK_FALSE(client.receive().has_value());
  client.await_close();
  CHECK(server.wait().status == 0);
}
