// The way in, over real sockets: proxies, places, budgets, TLS.
#include "net/door.h"

#include <signal.h>

#include <catch2/catch.hpp>
#include <thread>

#include <talus/protocol/frame.h>
#include <talus/protocol/message.h>
#include <asio/co_spawn.hpp>
#include <asio/detached.hpp>
#include <asio/read.hpp>
#include <asio/ssl.hpp>
#include <asio/use_awaitable.hpp>
#include <asio/write.hpp>

#include "certificates.h"
#include "scratch_directory.h"

using namespace talus;
using namespace talus::server;
using asio::ip::tcp;

namespace {

const std::string kProxyTcp4{"\r\n\r\n\0\r\nQUIT\n\x21\x11\0\x0C\xCB\0\x71\x07\x7F\0\0\x01\xC0\x01\x12\xAC",
                             28};
const std::string kProxyLocal{"\r\n\r\n\0\r\nQUIT\n\x20\0\0\0", 16};

const Config kDefaults;

template <typename Value>
Config with(Value Limits::*limit, int value, const std::string& proxies = "") {
  Config config;
  config.limits.*limit = Value(value);
  config.proxies = *Networks::parse(proxies);
  return config;
}

Config one_a_second() {
  Config config;
  config.limits.handshakes_per_address_per_second = 1;
  config.limits.handshakes_per_address_burst = 1;
  return config;
}

/// A guest is told its address, and what it says is said again. It stays until it leaves.
asio::awaitable<void> echo(std::shared_ptr<Guest> guest) {
  co_await asio::async_write(guest->wire, asio::buffer(guest->address + "\n"), asio::use_awaitable);
  std::array<char, 256> buffer{};
  for (;;) {
    const auto bytes = co_await guest->wire.async_read_some(asio::buffer(buffer), asio::use_awaitable);
    co_await asio::async_write(guest->wire, asio::buffer(buffer.data(), bytes), asio::use_awaitable);
  }
}

/// A door on loopback, with one thread behind it.
struct House {
  explicit House(const Config& settings = kDefaults, bool by_tls = false)
      : config{settings},
        admission{config.limits.connections, config.limits.connections_per_address},
        door{config,
             admission,
             metrics,
             std::make_shared<spdlog::logger>("silent"),
             [this] { return has_room.load(); },
             [this](Guest guest) {
               auto held = std::make_shared<Guest>(std::move(guest));
               asio::co_spawn(io, echo(held), asio::detached);
             }} {
    ::signal(SIGPIPE, SIG_IGN);
    if (by_tls) {
      const ScratchDirectory scratch;
      const auto loaded = load_tls(scratch.write("c", own.certificate), scratch.write("k", own.key));
      REQUIRE(loaded.has_value());
      tls = loaded->context;
    }
    accept();
    thread = std::thread{[this] { io.run(); }};
  }
  ~House() {
    io.stop();
    thread.join();
  }

  void accept() {
    acceptor.async_accept([this](std::error_code failed, tcp::socket socket) {
      if (failed) return;
      door.knock(std::move(socket), ++last_id, tls);
      accept();
    });
  }

  [[nodiscard]] std::uint64_t refused(Refusal why) { return metrics.refused_for(why).total(); }

  TestCertificate own = make_certificate(1);
  Config config;
  Metrics metrics;
  Admission admission;
  tls::Context tls;
  std::atomic<bool> has_room = true;
  Door door;
  asio::io_context io{1};
  tcp::acceptor acceptor{io, {asio::ip::address_v4::loopback(), 0}};
  ConnectionId last_id = 0;
  std::thread thread;
};

/// What is closed upon is counted a moment later; a test that waits in vain ends by its time limit.
template <typename Holds>
void await(Holds&& holds) {
  while (!holds()) std::this_thread::yield();
}

/// The other side, which blocks.
struct Visitor {
  explicit Visitor(const House& house) { socket.connect(house.acceptor.local_endpoint()); }

  void say(const std::string& bytes) { asio::write(socket, asio::buffer(bytes)); }
  std::string line() {
    std::string text;
    for (char c = 0; asio::read(socket, asio::buffer(&c, 1)) == 1 && c != '\n';) text += c;
    return text;
  }
  /// Everything until the end, however that comes.
  std::string rest() {
    std::string text;
    std::array<char, 256> buffer{};
    std::error_code ended;
    while (!ended) text.append(buffer.data(), socket.read_some(asio::buffer(buffer), ended));
    return text;
  }

  asio::io_context io;
  tcp::socket socket{io};
};

/// A visitor by TLS, once it has shaken hands.
struct TlsVisitor {
  explicit TlsVisitor(Visitor& visitor, const std::string& authority, int version = TLS1_3_VERSION)
      : stream{visitor.socket, context} {
    context.add_certificate_authority(asio::buffer(authority));
    stream.set_verify_mode(asio::ssl::verify_peer);
    SSL_set_min_proto_version(stream.native_handle(), version);
    SSL_set_max_proto_version(stream.native_handle(), version);
    stream.handshake(asio::ssl::stream_base::client, failed);
  }

  std::string echoed(const std::string& text) {
    asio::write(stream, asio::buffer(text));
    std::string back(text.size(), ' ');
    asio::read(stream, asio::buffer(back));
    return back;
  }

  asio::ssl::context context{asio::ssl::context::tls_client};
  asio::ssl::stream<tcp::socket&> stream;
  std::error_code failed;
};

std::string text_of(const protocol::Frame& frame) {
  return (*protocol::read_message(frame))->body_as_Error()->text()->str();
}

/// The one Error that `bytes` hold.
protocol::Frame only_frame(const std::string& bytes) {
  protocol::FrameReader frames{protocol::kServerFrameBytes};
  const auto taken = frames.feed(std::as_bytes(std::span{bytes}));
  REQUIRE(taken.has_value());
  REQUIRE(*taken == bytes.size());
  REQUIRE(frames.has_frame());
  return {frames.frame().begin(), frames.frame().end()};
}

}  // namespace

TEST_CASE("a plain visitor comes in, under its own address") {
  House house;
  Visitor visitor{house};
  CHECK_THAT(visitor.line(), Catch::StartsWith("127.0.0.1:"));
}

TEST_CASE("a visitor by TLS comes in, and bytes go both ways, also many of them") {
  House house{kDefaults, true};
  Visitor visitor{house};
  TlsVisitor secured{visitor, house.own.certificate};
  REQUIRE_FALSE(secured.failed);
  std::string told(256, ' ');
  CHECK_THAT(told.substr(0, secured.stream.read_some(asio::buffer(told))), Catch::StartsWith("127.0.0.1:"));
  // Each is echoed before the next, so neither side's buffers can fill.
  for (const std::size_t bytes : {1U, 255U, 256U, 16'384U, 50'000U}) {
    const std::string text(bytes, static_cast<char>('a' + bytes % 26));
    CHECK(secured.echoed(text) == text);
  }
  CHECK(house.metrics.tls_handshakes.total() == 1);
}

TEST_CASE("a visitor by TLS 1.2 is refused") {
  House house{kDefaults, true};
  Visitor visitor{house};
  const TlsVisitor secured{visitor, house.own.certificate, TLS1_2_VERSION};
  CHECK_THAT(secured.failed.message(), Catch::Contains("protocol version"));
  CHECK(visitor.rest().empty());
  CHECK(house.metrics.tls_failed.total() == 1);
}

TEST_CASE("who does not speak TLS where it is wanted is closed upon") {
  House house{kDefaults, true};
  Visitor visitor{house};
  visitor.say(std::string(64, 'x'));
  CHECK(visitor.rest().empty());
  CHECK(house.metrics.tls_failed.total() == 1);
}

TEST_CASE("who does not finish TLS in time is closed upon, and its place is free") {
  House house{with(&Limits::handshake_timeout, 50), true};
  Visitor visitor{house};
  visitor.say("\x16\x03\x01");  // the beginning of a ClientHello
  CHECK(visitor.rest().empty());
  await([&] { return house.metrics.tls_late.total() == 1 && house.admission.connections() == 0; });
}

TEST_CASE("who begins connections faster than its budget is told so, and when to come again") {
  House house{one_a_second()};
  // However slow this machine is, some time the next comes within a second.
  std::string said;
  while (house.refused(Refusal::pace) == 0) {
    Visitor visitor{house};
    std::error_code ended;
    visitor.socket.shutdown(tcp::socket::shutdown_send, ended);
    said = visitor.rest();
  }
  const auto error = only_frame(said);
  CHECK_THAT(text_of(error), Catch::Contains("faster than 1 a second"));
  const auto* body = (*protocol::read_message(error))->body_as_Error();
  CHECK(body->code() == wire::ErrorCode::overloaded);
  CHECK(body->retry_after_ms() > 0);
  CHECK(body->retry_after_ms() <= 1000);
}

TEST_CASE("where TLS is wanted, who is beyond its budget is closed upon without a word") {
  House house{one_a_second(), true};
  std::error_code failed;
  std::string said;
  while (house.refused(Refusal::pace) == 0) {
    Visitor visitor{house};
    failed = TlsVisitor{visitor, house.own.certificate}.failed;
    if (failed) said = visitor.rest();
  }
  CHECK(failed);
  CHECK(said.empty());
  CHECK(house.metrics.tls_failed.total() == 0);
}

TEST_CASE("where the server's memory is all in use nobody comes in, and is told so") {
  House house{with(&Limits::connections, 10)};
  house.has_room = false;
  Visitor visitor{house};
  CHECK_THAT(text_of(only_frame(visitor.rest())), Catch::Contains("memory"));
  CHECK(house.refused(Refusal::memory) == 1);
}

TEST_CASE("there are only so many handshakes under way") {
  House house{with(&Limits::handshakes_in_flight, 1), true};
  Visitor silent{house};
  Visitor next{house};
  CHECK(next.rest().empty());
  CHECK(house.refused(Refusal::handshakes) == 1);
}

TEST_CASE("a visitor that a proxy speaks for comes in under the address that the proxy gives") {
  House house{with(&Limits::connections, 10, "127.0.0.0/8")};
  Visitor visitor{house};
  visitor.say(kProxyTcp4 + "hello");
  CHECK(visitor.line() == "203.0.113.7:49153");
  std::string said(5, ' ');
  asio::read(visitor.socket, asio::buffer(said));
  CHECK(said == "hello");  // what comes after the header is the visitor's
}

TEST_CASE("a proxy that speaks for itself comes in under its own address") {
  House house{with(&Limits::connections, 10, "127.0.0.1")};
  Visitor visitor{house};
  visitor.say(kProxyLocal);
  CHECK_THAT(visitor.line(), Catch::StartsWith("127.0.0.1:"));
}

TEST_CASE("TLS begins right after a PROXY header") {
  House house{with(&Limits::connections, 10, "127.0.0.1"), true};
  Visitor visitor{house};
  visitor.say(kProxyTcp4);
  TlsVisitor secured{visitor, house.own.certificate};
  REQUIRE_FALSE(secured.failed);
  std::string told(256, ' ');
  CHECK(told.substr(0, secured.stream.read_some(asio::buffer(told))) == "203.0.113.7:49153\n");
}

TEST_CASE("one of the proxies that sends anything but a header is closed upon") {
  House house{with(&Limits::connections, 10, "127.0.0.1")};
  Visitor visitor{house};
  visitor.say("PROXY TCP4 192.0.2.7 198.51.100.1 49153 4780\r\n");
  CHECK(visitor.rest().empty());
  CHECK(house.refused(Refusal::proxy) == 1);
}

TEST_CASE("one of the proxies that sends half a header is closed upon in time") {
  House house{with(&Limits::handshake_timeout, 50, "127.0.0.1")};
  Visitor visitor{house};
  visitor.say(kProxyTcp4.substr(0, 20));
  CHECK(visitor.rest().empty());
  await([&] { return house.refused(Refusal::proxy) == 1; });
}

TEST_CASE("places are counted by the address behind the proxy") {
  House house{with(&Limits::connections_per_address, 1, "127.0.0.1")};
  Visitor first{house};
  first.say(kProxyTcp4);
  (void)first.line();
  Visitor again{house};
  again.say(kProxyTcp4);
  CHECK_THAT(text_of(only_frame(again.rest())), Catch::Contains("your address has 1 connections"));
  Visitor other{house};
  std::string header = kProxyTcp4;
  header[19] = 8;
  other.say(header);
  CHECK(other.line() == "203.0.113.8:49153");
}

TEST_CASE("a PROXY header from anybody else is no header, but what the visitor says") {
  House house{with(&Limits::connections, 10, "192.0.2.1")};
  Visitor visitor{house};
  visitor.say(kProxyTcp4);
  CHECK_THAT(visitor.line(), Catch::StartsWith("127.0.0.1:"));
  std::string said(kProxyTcp4.size(), ' ');
  asio::read(visitor.socket, asio::buffer(said));
  CHECK(said == kProxyTcp4);
}
