// Handshakes over real sockets: proxies, limits, rates, TLS.
#include "net/handshaker.h"

#include <linux/filter.h>
#include <signal.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <catch2/catch.hpp>
#include <deque>
#include <exception>
#include <semaphore>
#include <thread>

#include <talus/protocol/frame.h>
#include <talus/protocol/limits.h>
#include <talus/protocol/message.h>
#include <talus/tls/session.h>
#include <asio/co_spawn.hpp>
#include <asio/detached.hpp>
#include <asio/read.hpp>
#include <asio/ssl.hpp>
#include <asio/use_awaitable.hpp>
#include <asio/write.hpp>

#include "certificates.h"
#include "descriptors_left.h"
#include "logged_lines.h"
#include "net/descriptors.h"
#include "net/io_turns.h"
#include "net/stream.h"
#include "runtime/manual_clock.h"
#include "scratch_directory.h"

using namespace talus;
using namespace talus::server;
using asio::ip::tcp;

namespace {

const std::string kProxyTcp4{"\r\n\r\n\0\r\nQUIT\n\x21\x11\0\x0C\xCB\0\x71\x07\x7F\0\0\x01\xC0\x01\x12\xAC",
                             28};
const std::string kProxyLocal{"\r\n\r\n\0\r\nQUIT\n\x20\0\0\0", 16};

HandshakeSettings settings(const std::string& proxies = "") {
  return {20, 256, 1024, std::chrono::seconds{10}, *Networks::parse(proxies)};
}

/// What does not come at once comes too late.
HandshakeSettings in_no_time(const std::string& proxies = "") {
  HandshakeSettings changed = settings(proxies);
  changed.timeout = std::chrono::milliseconds{1};
  return changed;
}

HandshakeSettings one_a_second() {
  HandshakeSettings changed = settings();
  changed.per_address_per_second = 1;
  changed.per_address_burst = 1;
  return changed;
}

/// A client is told its address, and what it says is said again. It stays until it leaves.
template <Stream S>
asio::awaitable<void> echo(std::shared_ptr<AcceptedConnection> accepted) {
  S& stream = std::get<S>(accepted->stream);
  co_await asio::async_write(stream, asio::buffer(accepted->info.address + "\n"), asio::use_awaitable);
  std::array<char, 256> buffer{};
  for (;;) {
    const auto bytes = co_await stream.async_read_some(asio::buffer(buffer), asio::use_awaitable);
    co_await asio::async_write(stream, asio::buffer(buffer.data(), bytes), asio::use_awaitable);
  }
}

/// A listening socket on loopback, with one thread behind it, or none. The clock stands still.
struct Bench {
  explicit Bench(const HandshakeSettings& chosen = settings(), bool with_tls = false,
                 std::size_t max_per_address = 256, bool threaded = true,
                 const char* listens_at = "127.0.0.1")
      : admission{{2048, max_per_address}, clock},
        handshaker{chosen,
                   admission,
                   access,
                   flows,
                   metrics,
                   memory,
                   clock,
                   log,
                   [this](AcceptedConnection accepted) {
                     proxy_port = accepted.info.proxy_port ? int{*accepted.info.proxy_port} : -1;
                     const bool secured = std::holds_alternative<TlsStream>(accepted.stream);
                     auto held = std::make_shared<AcceptedConnection>(std::move(accepted));
                     asio::co_spawn(io, secured ? echo<TlsStream>(held) : echo<TcpStream>(held),
                                    [this](const std::exception_ptr&) { left.release(); });
                   }},
        acceptor{io, {asio::ip::make_address(listens_at), 0}} {
    ::signal(SIGPIPE, SIG_IGN);
    if (with_tls) {
      const ScratchDirectory scratch;
      const auto loaded =
          load_tls(scratch.write("c", own.certificate), scratch.write("k", own.key), SystemClock{}.wall());
      REQUIRE(loaded.has_value());
      tls = loaded->context;
    }
    accept();
    if (threaded) thread = std::thread{[this] { io.run(); }};
  }
  ~Bench() {
    io.stop();
    if (thread.joinable()) thread.join();
  }

  void accept() {
    acceptor.async_accept([this](std::error_code failed, tcp::socket socket) {
      if (failed) return;
      handshaker.begin(std::move(socket), ++last_id, tls);
      accept();
    });
  }

  /// Runs what the handshaker does, for a bench without a thread.
  template <typename Condition>
  void poll_until(Condition condition) {
    const auto give_up = std::chrono::steady_clock::now() + std::chrono::minutes{2};
    while (!condition()) {
      REQUIRE(std::chrono::steady_clock::now() < give_up);
      (void)io.poll_one();
    }
  }
  /// One line of access.blocked_file.
  void block(const std::string& who) {
    (void)lists.write("blocked", who + "\n");
    REQUIRE(access.reload(access_settings).has_value());
  }
  std::counting_semaphore<> left{0};  // connections that were accepted and have ended
  std::atomic<int> proxy_port{-2};    // of who was accepted last; -1: it came directly
  [[nodiscard]] std::uint64_t refused(Refusal why) { return metrics.refused_for(why).total(); }

  TestCertificate own = make_certificate(1);
  std::shared_ptr<LoggedLines> log = std::make_shared<LoggedLines>();
  ManualClock clock;
  Metrics metrics;
  Admission admission;
  const ScratchDirectory lists;
  Access access_settings{{}, "read", {}, "auto", {}, {}, lists.write("blocked", "")};
  AccessControl access{access_settings, *load_keys(access_settings)};
  FlowUses flows;
  tls::Context tls;
  MemoryBudget memory{std::uint64_t{256} << 20};
  Handshaker handshaker;
  asio::io_context io{1};
  tcp::acceptor acceptor;
  ConnectionId last_id = 0;
  std::thread thread;
};

/// The other side, which blocks.
struct Client {
  explicit Client(const Bench& bench) { socket.connect(bench.acceptor.local_endpoint()); }

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

/// A client by TLS, once it has shaken hands.
struct TlsClient {
  explicit TlsClient(Client& client, const std::string& authority, int version = TLS1_3_VERSION)
      : stream{client.socket, context} {
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

/// A client by TLS that does not wait for answers.
struct ImpatientTls {
  ImpatientTls(Bench& bench, const char* from) : socket{bench.io, {asio::ip::make_address(from), 0}} {
    socket.connect(bench.acceptor.local_endpoint());
    socket.native_non_blocking(true);
  }
  void say_hello() { REQUIRE(session.handshake().waits()); }
  [[nodiscard]] bool is_answered() const { return socket.available() > 0; }

  tcp::socket socket;
  tls::Session session{tls::new_context(tls::Role::client), tls::Role::client, socket.native_handle()};
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

TEST_CASE("a plain client comes in, under its own address") {
  Bench bench;
  Client client{bench};
  CHECK_THAT(client.line(), Catch::StartsWith("127.0.0.1:"));
}

TEST_CASE("an IPv4 client of an IPv6 listener comes in under its IPv4 address") {
  Bench bench{settings(), false, 256, true, "::ffff:127.0.0.1"};
  Client client{bench};
  REQUIRE(client.socket.local_endpoint().address().is_v6());
  CHECK_THAT(client.line(), Catch::StartsWith("127.0.0.1:"));
}

TEST_CASE("a client whose system no longer answers is given up, though nothing is sent to it") {
  const bool with_tls = GENERATE(false, true);
  HandshakeSettings impatient = settings();
  impatient.silence = std::chrono::seconds{2};
  Bench bench{impatient, with_tls};
  Client honest{bench};
  Client vanished{bench};
  if (with_tls) {
    CHECK_FALSE(TlsClient{honest, bench.own.certificate}.failed);
    CHECK_FALSE(TlsClient{vanished, bench.own.certificate}.failed);
  } else {
    (void)honest.line();
    (void)vanished.line();
  }
  // From here on its system drops what comes.
  sock_filter drop{BPF_RET | BPF_K, 0, 0, 0};
  const sock_fprog filter{1, &drop};
  REQUIRE(::setsockopt(vanished.socket.native_handle(), SOL_SOCKET, SO_ATTACH_FILTER, &filter,
                       sizeof(filter)) == 0);
  CHECK(bench.left.try_acquire_for(std::chrono::seconds{60}));
  CHECK_FALSE(bench.left.try_acquire());
  CHECK(bench.admission.connections() == 1);
}

TEST_CASE("a TLS client is accepted, and bytes pass both ways, including many of them") {
  Bench bench{settings(), true};
  Client client{bench};
  TlsClient secured{client, bench.own.certificate};
  REQUIRE_FALSE(secured.failed);
  std::string told(256, ' ');
  CHECK_THAT(told.substr(0, secured.stream.read_some(asio::buffer(told))), Catch::StartsWith("127.0.0.1:"));
  // Each is echoed before the next, so neither side's buffers can fill.
  for (const std::size_t bytes : {1U, 255U, 256U, 16'384U, 50'000U}) {
    const std::string text(bytes, static_cast<char>('a' + bytes % 26));
    CHECK(secured.echoed(text) == text);
  }
  CHECK(bench.metrics.tls_handshakes.total() == 1);
}

TEST_CASE("a client by TLS 1.2 is refused") {
  Bench bench{settings(), true};
  Client client{bench};
  const TlsClient secured{client, bench.own.certificate, TLS1_2_VERSION};
  CHECK_THAT(secured.failed.message(), Catch::Contains("protocol version"));
  CHECK(client.rest().empty());
  CHECK(bench.metrics.tls_failed.total() == 1);
}

TEST_CASE("a client without TLS is closed if TLS is required") {
  Bench bench{settings(), true};
  Client client{bench};
  client.say(std::string(64, 'x'));
  CHECK(client.rest().empty());
  CHECK(bench.metrics.tls_failed.total() == 1);
}

TEST_CASE("a client that does not finish TLS in time is closed, and its place is free") {
  Bench bench{in_no_time(), true};
  Client client{bench};
  client.say("\x16\x03\x01");  // the beginning of a ClientHello
  CHECK(client.rest().empty());
  CHECK(bench.metrics.tls_late.total() == 1);
  CHECK(bench.admission.connections() == 0);
}

TEST_CASE("a client that is gone during its handshake leaves no handshake, place or memory") {
  HandshakeSettings patient = settings("127.0.0.1");
  patient.timeout = std::chrono::hours{1};
  Bench bench{patient, true};
  for (const std::string& said : {std::string{}, kProxyTcp4.substr(0, 20), kProxyTcp4 + "\x16\x03\x01"}) {
    for (const bool reset : {false, true}) {
      {
        Client client{bench};
        client.say(said);
        while (bench.metrics.handshakes.now() == 0) std::this_thread::yield();
        if (reset) client.socket.set_option(asio::socket_base::linger{true, 0});
      }
      while (bench.metrics.handshakes.now() != 0) std::this_thread::yield();
      CHECK(bench.admission.connections() == 0);
      while (bench.memory.used(MemoryUse::sessions) != 0) std::this_thread::yield();
    }
  }
}

TEST_CASE("a client that connects faster than its rate is refused with a time to retry") {
  Bench bench{one_a_second()};
  Client first{bench};
  (void)first.line();
  Client second{bench};
  const std::string said = second.rest();
  CHECK(bench.refused(Refusal::pace) == 1);
  const auto error = only_frame(said);
  CHECK_THAT(text_of(error), Catch::Contains("faster than 1 a second"));
  const auto* body = (*protocol::read_message(error))->body_as_Error();
  CHECK(body->code() == wire::ErrorCode::overloaded);
  CHECK(body->retry_after_ms() == 1000);
  bench.flows.collect(bench.clock.now());
  CHECK(bench.flows.top(1)[2].top.at(0).name->text == "127.0.0.1");
  bench.clock.advance(std::chrono::seconds{1});
  Client third{bench};
  CHECK_THAT(third.line(), Catch::StartsWith("127.0.0.1:"));
}

TEST_CASE("limits that change count for the next connection") {
  Bench bench{one_a_second()};
  Client first{bench};
  (void)first.line();
  {
    Client second{bench};
    CHECK_FALSE(second.rest().empty());
  }
  HandshakeSettings more = one_a_second();
  more.per_address_burst = 3;
  bench.handshaker.change(more);
  Client third{bench};
  CHECK_THAT(third.line(), Catch::StartsWith("127.0.0.1:"));
}

TEST_CASE("with TLS, a client over its rate is closed without an answer") {
  Bench bench{one_a_second(), true};
  Client first{bench};
  CHECK_FALSE(TlsClient(first, bench.own.certificate).failed);
  Client second{bench};
  CHECK(TlsClient(second, bench.own.certificate).failed);
  CHECK(second.rest().empty());
  CHECK(bench.refused(Refusal::pace) == 1);
  CHECK(bench.metrics.tls_failed.total() == 0);
}

TEST_CASE("a blocked client is refused and counted, whatever proxy names it, and logged once") {
  const bool proxied = GENERATE(true, false);
  Bench bench{settings(proxied ? "127.0.0.1" : "")};
  bench.block(proxied ? "203.0.113.0/24" : "127.0.0.1");
  for (int attempts = 0; attempts < 3; ++attempts) {
    Client client{bench};
    if (proxied) client.say(kProxyTcp4);
    const auto error = only_frame(client.rest());
    const auto* body = (*protocol::read_message(error))->body_as_Error();
    CHECK(body->code() == wire::ErrorCode::unauthorized);
    CHECK_THAT(text_of(error), Catch::Contains("blocked you"));
    CHECK(body->retry_after_ms() == 0);
  }
  CHECK(bench.refused(Refusal::blocked) == 3);
  bench.flows.collect(bench.clock.now());
  CHECK(bench.flows.refusals() == 3);
  CHECK(bench.log->count() == 1);
  bench.block("198.51.100.0/24");
  Client client{bench};
  if (proxied) client.say(kProxyTcp4);
  CHECK_FALSE(client.line().empty());
}

TEST_CASE("a server whose memory is all in use refuses new clients with a reason") {
  Bench bench;
  bench.memory.set(MemoryUse::jobs, bench.memory.limit_bytes());
  Client client{bench};
  CHECK_THAT(text_of(only_frame(client.rest())), Catch::Contains("memory"));
  CHECK(bench.refused(Refusal::memory) == 1);
}

TEST_CASE("a server with only spare descriptors refuses new clients with a reason") {
  for (const char* const proxies : {"", "127.0.0.1"}) {
    Bench bench{settings(proxies)};
    {
      const DescriptorsLeft few{kSpareDescriptors};
      Client client{bench};
      client.socket.shutdown(tcp::socket::shutdown_send);
      CHECK_THAT(text_of(only_frame(client.rest())), Catch::Contains("limit of open files"));
      CHECK(bench.refused(Refusal::descriptors) == 1);
    }
    Client next{bench};
    next.say(kProxyTcp4);
    CHECK_FALSE(next.line().empty());
  }
}

TEST_CASE("the number of handshakes in flight is limited") {
  HandshakeSettings one = settings();
  one.max_in_flight = 1;
  Bench bench{one, true};
  Client silent{bench};
  Client next{bench};
  CHECK(next.rest().empty());
  CHECK(bench.refused(Refusal::handshakes) == 1);
  CHECK(bench.memory.used(MemoryUse::sessions) == Handshaker::kTlsBytes);
}

TEST_CASE("a client that a proxy speaks for comes in under the address that the proxy gives") {
  Bench bench{settings("127.0.0.0/8")};
  Client client{bench};
  client.say(kProxyTcp4 + "hello");
  CHECK(client.line() == "203.0.113.7:49153");
  std::string said(5, ' ');
  asio::read(client.socket, asio::buffer(said));
  CHECK(said == "hello");  // what comes after the header is the client's
  CHECK(bench.proxy_port.load() == 4780);
}

TEST_CASE("a proxy that speaks for itself comes in under its own address") {
  Bench bench{settings("127.0.0.1")};
  Client client{bench};
  client.say(kProxyLocal);
  CHECK_THAT(client.line(), Catch::StartsWith("127.0.0.1:"));
  CHECK(bench.proxy_port.load() == 0);
}

TEST_CASE(
    "a client without a proxy has no port of a proxy, and one through a proxy without a header has port 0") {
  Bench direct{settings("192.0.2.0/24")};
  Client player{direct};
  CHECK_THAT(player.line(), Catch::StartsWith("127.0.0.1:"));
  CHECK(direct.proxy_port.load() == -1);
  HandshakeSettings web = settings("127.0.0.1");
  web.header_optional = true;
  Bench proxied{web};
  Client request{proxied};
  request.say("GET");
  CHECK_THAT(request.line(), Catch::StartsWith("127.0.0.1:"));
  CHECK(proxied.proxy_port.load() == 0);
}

TEST_CASE("TLS begins right after a PROXY header") {
  Bench bench{settings("127.0.0.1"), true};
  Client client{bench};
  client.say(kProxyTcp4);
  TlsClient secured{client, bench.own.certificate};
  REQUIRE_FALSE(secured.failed);
  std::string told(256, ' ');
  CHECK(told.substr(0, secured.stream.read_some(asio::buffer(told))) == "203.0.113.7:49153\n");
}

TEST_CASE("one of the proxies that sends anything but a header is closed") {
  Bench bench{settings("127.0.0.1")};
  Client client{bench};
  client.say("PROXY TCP4 192.0.2.7 198.51.100.1 49153 4780\r\n");
  CHECK(client.rest().empty());
  CHECK(bench.refused(Refusal::proxy) == 1);
}

TEST_CASE("a refusal counts for the client, and never for the proxy that speaks for others") {
  Bench bench{settings("127.0.0.1"), false, 1};
  Client broken{bench};
  broken.say("no header");
  CHECK(broken.rest().empty());
  Client first{bench};
  first.say(kProxyTcp4);
  (void)first.line();
  Client second{bench};
  second.say(kProxyTcp4);
  CHECK_FALSE(second.rest().empty());
  bench.flows.collect(bench.clock.now());
  CHECK(bench.flows.refusals() == 1);
  CHECK(bench.flows.top(1)[2].top.at(0).name->text == "203.0.113.7");
}

TEST_CASE("one of the proxies that sends half a header is closed in time") {
  Bench bench{in_no_time("127.0.0.1")};
  Client client{bench};
  client.say(kProxyTcp4.substr(0, 20));
  CHECK(client.rest().empty());
  CHECK(bench.refused(Refusal::proxy) == 1);
}

TEST_CASE("slots are counted by the address behind the proxy") {
  Bench bench{settings("127.0.0.1"), false, 1};
  Client first{bench};
  first.say(kProxyTcp4);
  (void)first.line();
  Client again{bench};
  again.say(kProxyTcp4);
  CHECK_THAT(text_of(only_frame(again.rest())), Catch::Contains("your address has 1 connections"));
  Client other{bench};
  std::string header = kProxyTcp4;
  header[19] = 8;
  other.say(header);
  CHECK(other.line() == "203.0.113.8:49153");
}

TEST_CASE("a PROXY header from another address is not a header, but the client's own bytes") {
  Bench bench{settings("192.0.2.1")};
  Client client{bench};
  client.say(kProxyTcp4);
  CHECK_THAT(client.line(), Catch::StartsWith("127.0.0.1:"));
  std::string said(kProxyTcp4.size(), ' ');
  asio::read(client.socket, asio::buffer(said));
  CHECK(said == kProxyTcp4);
}

TEST_CASE("a handshake waits for one of another address, however many that begins") {
  Bench bench{settings(), true, 256, false};
  std::deque<ImpatientTls> greedy;
  for (int i = 0; i < 20; ++i) greedy.emplace_back(bench, "127.0.0.2");
  ImpatientTls other{bench, "127.0.0.1"};
  bench.io.poll();
  for (ImpatientTls& each : greedy) each.say_hello();
  other.say_hello();
  const auto answered = [&] { return std::ranges::count_if(greedy, &ImpatientTls::is_answered); };
  bench.poll_until([&] { return other.is_answered(); });
  CHECK(answered() <= 2);
  bench.poll_until([&] { return answered() == 20; });
}

TEST_CASE("a handshake that waits for its turn ends in time, and holds nothing then") {
  HandshakeSettings hasty = settings();
  hasty.timeout = std::chrono::milliseconds{50};
  Bench bench{hasty, true, 256, false};
  const FlowId flow = flow_id_of(asio::ip::make_address("127.0.0.2"), bench.flows.ids());
  asio::use_service<IoTurns>(bench.io).charge(flow, std::uint64_t{1} << 50);
  const auto free_descriptor = [] {
    const int next = ::dup(0);
    ::close(next);
    return next;
  };
  const int before = free_descriptor();
  {
    ImpatientTls client{bench, "127.0.0.2"};
    client.say_hello();
    bench.poll_until([&] { return bench.metrics.tls_late.total() == 1; });
  }
  CHECK(bench.memory.used(MemoryUse::sessions) == 0);
  CHECK(bench.admission.connections() == 0);
  CHECK(free_descriptor() == before);
}
