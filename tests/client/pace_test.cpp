// A client keeps to the rates that its server tells, and comes back when a server asks it to.
#include <asio/post.hpp>
#include <asio/use_awaitable.hpp>
#include <catch2/catch.hpp>

#include "manual_clock.h"
#include "peer.h"

namespace talus::client {
namespace {

using namespace testing;
using std::chrono::milliseconds;

constexpr Rates kRates{0, 0, 10, milliseconds{2'000}};

struct PaceBench {
  asio::io_context io;
  ManualClock clock;
  Peer peer{io};
  Events events;
  std::optional<Client> client;
  bool over = false;

  void make_client(int reconnects = 0) {
    Options options;
    options.clock = &clock;
    options.ping_interval = options.silence_timeout = std::chrono::hours{10};
    options.connect_timeout = options.handshake_timeout = std::chrono::hours{10};
    options.reconnect = {reconnects, milliseconds{100}, milliseconds{100}, 1};
    client.emplace(io.get_executor(), options, events);
  }

  asio::awaitable<void> join() { return testing::join(*client, peer); }
  asio::awaitable<void> welcome() { return peer.welcome(1, 1U << 20, 64, 0, kRates); }

  /// Lets the time pass, a little whenever all is quiet for a moment, until `over`.
  asio::awaitable<void> pass_time() {
    while (!over) {
      co_await asio::post(io, asio::use_awaitable);
      clock.advance(milliseconds{1});
    }
  }

  /// Its id.
  asio::awaitable<std::uint32_t> next_request() {
    while (true) {
      const auto* message = co_await peer.receive();
      if (const auto* get = message->body_as_GetChunks()) {
        REQUIRE(get->requests()->size() == 1);
        co_return get->requests()->Get(0)->id();
      }
    }
  }
};

}  // namespace

TEST_CASE("requests, Views and pings beyond the rate wait in the client") {
  PaceBench m;
  m.make_client();
  constexpr int kCount = 40;
  int answered = 0;
  Clock::Time begun{};
  const auto visit = [&]() -> asio::awaitable<void> {
    co_await m.join();
    begun = m.clock.now();
    for (int i = 0; i < kCount; ++i) {
      View view;
      view.centre.x = i * 1000;
      REQUIRE(m.client->set_view(view).has_value());
      (void)m.client->get(key_at(i, 0, 0), std::nullopt, [&](const Result<ReceivedChunk>& chunk) {
        CHECK(chunk.has_value());
        ++answered;
      });
      m.client->ping([&](const auto& time) {
        CHECK(time.has_value());
        ++answered;
      });
    }
    while (answered < 2 * kCount) co_await asio::post(m.io, asio::use_awaitable);
    m.over = true;
  };
  const auto serve = [&]() -> asio::awaitable<void> {
    co_await m.welcome();
    double level = 20;  // of the server's bucket
    Clock::Time filled = m.clock.now();
    for (int left = 2 * kCount; left > 0;) {
      const auto* message = co_await m.peer.receive();
      std::vector<std::pair<std::uint32_t, ChunkKey>> asked;
      std::optional<std::uint64_t> nonce;
      int count = 1;
      if (const auto* get = message->body_as_GetChunks()) {
        for (const auto* r : *get->requests()) asked.emplace_back(r->id(), key_at(r->key().x(), 0, 0));
        count = static_cast<int>(asked.size());
      } else if (const auto* ping = message->body_as_Ping()) {
        nonce = ping->nonce();
      } else {
        REQUIRE(message->body_as_View() != nullptr);
        ++left;
      }
      left -= count;
      const auto now = m.clock.now();
      level = std::min(20.0, level + 10 * std::chrono::duration<double>(now - filled).count()) - count;
      filled = now;
      REQUIRE(level >= 0);
      for (const auto& [id, key] : asked) co_await m.peer.send(chunk_frame(id, key, some_chunk(key)));
      if (nonce)
        co_await m.peer.send(protocol::make_frame([&](auto& b) { return wire::CreatePong(b, *nonce); }));
    }
  };
  run(m.io, {visit, serve, [&] { return m.pass_time(); }});
  CHECK(answered == 2 * kCount);
}

TEST_CASE("a request that the server refuses for now is sent again at the given time") {
  PaceBench m;
  m.make_client();
  const ChunkKey key = key_at(1, 2, 3);
  const auto visit = [&]() -> asio::awaitable<void> {
    co_await m.join();
    const auto chunk = co_await m.client->get(key);
    CHECK(chunk.has_value());
    m.over = true;
  };
  const auto serve = [&]() -> asio::awaitable<void> {
    co_await m.welcome();
    auto id = co_await m.next_request();
    for (int refusals = 0; refusals < 3; ++refusals) {
      const auto told = m.clock.now();
      co_await m.peer.send(refusal_frame(wire::ErrorAbout::request, id, milliseconds{1'500}));
      id = co_await m.next_request();
      CHECK(m.clock.now() >= told + milliseconds{1'500});
    }
    co_await m.peer.send(chunk_frame(id, key, some_chunk(key)));
  };
  run(m.io, {visit, serve, [&] { return m.pass_time(); }});
}

TEST_CASE("a refused request that was cancelled is not asked again") {
  PaceBench m;
  m.make_client();
  std::optional<Result<ReceivedChunk>> answer;
  const auto visit = [&]() -> asio::awaitable<void> {
    co_await m.join();
    const RequestId id =
        m.client->get(key_at(1, 2, 3), std::nullopt, [&](const auto& chunk) { answer = chunk; });
    (void)co_await m.client->ping();
    m.client->cancel(id);
    while (!answer) co_await asio::post(m.io, asio::use_awaitable);
    m.over = true;
  };
  const auto serve = [&]() -> asio::awaitable<void> {
    co_await m.welcome();
    std::uint32_t id = 0;
    while (true) {
      const auto* message = co_await m.peer.receive();
      if (const auto* get = message->body_as_GetChunks()) id = get->requests()->Get(0)->id();
      if (const auto* ping = message->body_as_Ping()) {
        const auto nonce = ping->nonce();
        co_await m.peer.send(protocol::make_frame([&](auto& b) { return wire::CreatePong(b, nonce); }));
      }
      if (message->body_as_Cancel() != nullptr) break;
    }
    co_await m.peer.send(refusal_frame(wire::ErrorAbout::request, id, milliseconds{1}));
  };
  run(m.io, {visit, serve, [&] { return m.pass_time(); }});
  REQUIRE_FALSE(answer->has_value());
  CHECK(answer->error().kind == ErrorKind::overloaded);
}

TEST_CASE("a View that the server refuses for now is sent again, and no other") {
  PaceBench m;
  std::vector<ClientError> errors;
  m.events.on_error = [&](const ClientError& error) { errors.push_back(error); };
  m.make_client();
  const auto visit = [&]() -> asio::awaitable<void> {
    co_await m.join();
    REQUIRE(m.client->set_view(View{}).has_value());
  };
  const auto serve = [&]() -> asio::awaitable<void> {
    co_await m.welcome();
    const auto* message = co_await m.peer.receive();
    const auto number = message->body_as_View()->number();
    const auto told = m.clock.now();
    co_await m.peer.send(refusal_frame(wire::ErrorAbout::view, number + 7, milliseconds{10'000}));  // of none
    co_await m.peer.send(refusal_frame(wire::ErrorAbout::view, number, milliseconds{20'000}));
    message = co_await m.peer.receive();
    CHECK(message->body_as_View()->number() != number);
    CHECK(m.clock.now() >= told + milliseconds{20'000});
    m.over = true;
  };
  run(m.io, {visit, serve, [&] { return m.pass_time(); }});
  CHECK(errors.empty());
}

TEST_CASE("a chunk that comes while a View without it waits to be sent is fetched when the next one has it") {
  PaceBench m;
  const bool alone = GENERATE(true, false);  // or in a column
  std::vector<ChunkKey> came;
  m.events.on_chunk = [&](const ReceivedChunk& chunk) { came.push_back(chunk.key); };
  m.make_client();
  const ChunkKey key = key_at(0, 0, 0);
  View here;
  here.horizontal_radius = here.vertical_radius = 0;
  View there = here;
  there.centre.x = 5000;
  const auto visit = [&]() -> asio::awaitable<void> {
    co_await m.join();
    const client::Stats before = m.client->stats();
    REQUIRE(m.client->set_view(here).has_value());
    while (m.client->stats().sent_bytes == before.sent_bytes) co_await asio::post(m.io, asio::use_awaitable);
    // The first View took the one request that may go: this one waits.
    REQUIRE(m.client->set_view(there).has_value());
    while (m.client->stats().received_bytes == before.received_bytes)
      co_await asio::post(m.io, asio::use_awaitable);
    // The frame is handled when it has been read whole.
    co_await asio::post(m.io, asio::use_awaitable);
    CHECK(came.empty());
    REQUIRE(m.client->set_view(here).has_value());
    while (came.empty()) {
      co_await asio::post(m.io, asio::use_awaitable);
      m.clock.advance(milliseconds{1});
    }
  };
  const auto serve = [&]() -> asio::awaitable<void> {
    co_await m.peer.welcome(1, 1U << 20, 64, 0, Rates{0, 0, 1, milliseconds{100}});
    const auto* message = co_await m.peer.receive();
    REQUIRE(message->body_as_View() != nullptr);
    const std::vector<wire::UniformRun> runs{{-9, 9, 2}};
    auto frame = chunk_frame(0, key, some_chunk(key));
    if (!alone) {
      frame = protocol::make_frame(
          [&](auto& b) { return wire::CreateUniformColumn(b, 0, 0, 0, 0, b.CreateVectorOfStructs(runs)); });
    }
    co_await m.peer.send(std::move(frame));
    const auto id = co_await m.next_request();
    co_await m.peer.send(chunk_frame(id, key, some_chunk(key)));
  };
  run(m.io, {visit, serve});
  CHECK(came == std::vector{key});
}

TEST_CASE("a refused ping fails, the oldest first") {
  PaceBench m;
  m.make_client();
  std::vector<std::string> answers;
  const auto visit = [&]() -> asio::awaitable<void> {
    co_await m.join();
    m.client->ping([&](const auto& time) { answers.push_back(time ? "first came" : "first refused"); });
    const auto second = co_await m.client->ping();
    answers.push_back(second ? "second came" : "second refused");
    m.over = true;
  };
  const auto serve = [&]() -> asio::awaitable<void> {
    co_await m.welcome();
    (void)co_await m.peer.receive();
    const auto* second = co_await m.peer.receive();
    const auto nonce = second->body_as_Ping()->nonce();
    co_await m.peer.send(refusal_frame(wire::ErrorAbout::ping, 0, milliseconds{1}));
    co_await m.peer.send(protocol::make_frame([&](auto& b) { return wire::CreatePong(b, nonce); }));
  };
  run(m.io, {visit, serve, [&] { return m.pass_time(); }});
  CHECK(answers == std::vector<std::string>{"first refused", "second came"});
}

TEST_CASE(
    "a server that goes away receives no more requests, and the next one receives them after the given "
    "time") {
  PaceBench m;
  m.make_client(3);
  const ChunkKey key = key_at(1, 2, 3);
  const auto visit = [&]() -> asio::awaitable<void> {
    co_await m.join();
    const auto first = co_await m.client->get(key);
    CHECK(first.has_value());
    m.over = true;
  };
  const auto serve = [&]() -> asio::awaitable<void> {
    co_await m.welcome();
    const auto refused = co_await m.next_request();
    co_await m.peer.send(protocol::make_frame(
        [](auto& b) { return wire::CreateGoAway(b, b.CreateString("an update"), 30'000); }));
    co_await m.peer.send(refusal_frame(wire::ErrorAbout::request, refused, milliseconds{100}));
    const auto told = m.clock.now();
    while (m.clock.now() < told + milliseconds{1'000}) co_await asio::post(m.io, asio::use_awaitable);
    m.peer.hang_up();
    co_await m.welcome();
    CHECK(m.clock.now() >= told + milliseconds{30'000});
    const auto id = co_await m.next_request();
    co_await m.peer.send(chunk_frame(id, key, some_chunk(key)));
  };
  run(m.io, {visit, serve, [&] { return m.pass_time(); }});
}

}  // namespace talus::client
