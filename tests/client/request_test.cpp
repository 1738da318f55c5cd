#include <asio/use_awaitable.hpp>
#include <catch2/catch.hpp>

#include "peer.h"

namespace talus::client {
namespace {

using namespace testing;

struct RequestBench {
  asio::io_context io;
  Peer peer{io};
  Client client{io.get_executor()};

  asio::awaitable<void> join() { return testing::join(client, peer); }
};

}  // namespace

TEST_CASE("get brings the chunk that was asked for") {
  RequestBench m;
  const ChunkKey key = key_at(-3, 2, 5, 1);
  const auto visit = [&]() -> asio::awaitable<void> {
    co_await m.join();
    const auto received = co_await m.client.get(key);
    REQUIRE(received.has_value());
    CHECK(received->key == key);
    CHECK(*received->chunk == some_chunk(key));
    CHECK(received->hash == content_hash(some_chunk(key)));
  };
  const auto serve = [&]() -> asio::awaitable<void> {
    co_await m.peer.welcome();
    const auto* get = (co_await m.peer.receive())->body_as_GetChunks();
    REQUIRE(get != nullptr);
    REQUIRE(get->requests()->size() == 1);
    const auto& request = *get->requests()->Get(0);
    CHECK(request.key().x() == -3);
    CHECK(request.key().lod() == 1);
    CHECK_FALSE(request.has_known());
    co_await m.peer.send(chunk_frame(request.id(), key, some_chunk(key)));
  };
  run(m.io, {visit, serve});
}

TEST_CASE("answers in any order reach their callers, requests of one moment share a frame") {
  RequestBench m;
  constexpr int kCount = 20;
  int answered = 0;
  const auto visit = [&]() -> asio::awaitable<void> {
    co_await m.join();
    for (int i = 0; i < kCount; ++i) {
      const ChunkKey key = key_at(i, 0, 0);
      m.client.get(key, std::nullopt, [&, key](const Result<ReceivedChunk>& received) {
        REQUIRE(received.has_value());
        CHECK(received->key == key);
        ++answered;
      });
    }
    const auto last = co_await m.client.get(key_at(99, 0, 0));
    REQUIRE(last.has_value());
  };
  const auto serve = [&]() -> asio::awaitable<void> {
    co_await m.peer.welcome();
    std::vector<std::pair<std::uint32_t, ChunkKey>> asked;
    while (asked.size() < kCount + 1) {
      const auto* message = co_await m.peer.receive();
      for (const auto* request : *message->body_as_GetChunks()->requests()) {
        asked.emplace_back(request->id(), key_at(request->key().x(), 0, 0));
      }
    }
    std::swap(asked.front(), asked.back());
    std::swap(asked[3], asked[11]);
    // The awaited one goes last, so that all have been answered when it has.
    std::swap(asked.front(), asked.back());
    for (const auto& [id, key] : asked) co_await m.peer.send(chunk_frame(id, key, some_chunk(key)));
  };
  run(m.io, {visit, serve});
  CHECK(answered == kCount);
}

TEST_CASE("no more requests are in flight than the server allows") {
  RequestBench m;
  constexpr std::uint32_t kAllowed = 4;
  int answered = 0;
  const auto visit = [&]() -> asio::awaitable<void> {
    co_await m.join();
    for (int i = 0; i < 20; ++i) {
      m.client.get(key_at(i, 0, 0), std::nullopt, [&](const auto&) { ++answered; });
    }
    const auto answer = co_await m.client.get(key_at(50, 0, 0));
    REQUIRE(answer.has_value());
  };
  const auto serve = [&]() -> asio::awaitable<void> {
    co_await m.peer.welcome(1, 1U << 20, kAllowed);
    std::vector<std::pair<std::uint32_t, ChunkKey>> open;
    for (int served = 0; served < 21;) {
      if (open.empty()) {
        const auto* get = (co_await m.peer.receive())->body_as_GetChunks();
        if (get == nullptr) continue;
        for (const auto* r : *get->requests()) open.emplace_back(r->id(), key_at(r->key().x(), 0, 0));
        REQUIRE(open.size() <= kAllowed);
      }
      const auto [id, key] = open.back();
      open.pop_back();
      co_await m.peer.send(chunk_frame(id, key, some_chunk(key)));
      ++served;
    }
  };
  run(m.io, {visit, serve});
  CHECK(answered == 20);
}

TEST_CASE("a known chunk may be answered by Unchanged") {
  RequestBench m;
  const ChunkKey key = key_at(1, 2, 3);
  const ContentHash known{11, 12};
  const auto visit = [&]() -> asio::awaitable<void> {
    co_await m.join();
    const auto received = co_await m.client.get(key, known);
    REQUIRE(received.has_value());
    CHECK(received->unchanged());
    CHECK(received->hash == known);
  };
  const auto serve = [&]() -> asio::awaitable<void> {
    co_await m.peer.welcome();
    const auto request = *(co_await m.peer.receive())->body_as_GetChunks()->requests()->Get(0);
    CHECK(request.has_known());
    CHECK(request.known().high() == 12);
    co_await m.peer.send(protocol::make_frame([&](auto& b) {
      return wire::CreateUnchanged(b, request.id(), &request.key(), 0, &request.known());
    }));
  };
  run(m.io, {visit, serve});
}

TEST_CASE("an Error answers its request and leaves the others alone") {
  RequestBench m;
  const auto visit = [&]() -> asio::awaitable<void> {
    co_await m.join();
    const auto refused = co_await m.client.get(key_at(1, 0, 0));
    REQUIRE_FALSE(refused.has_value());
    CHECK(refused.error().kind == ErrorKind::out_of_range);
    CHECK(refused.error().message == "the server says: too far");
    const auto other = co_await m.client.get(key_at(2, 0, 0));
    CHECK(other.has_value());
  };
  const auto serve = [&]() -> asio::awaitable<void> {
    co_await m.peer.welcome();
    auto id = (co_await m.peer.receive())->body_as_GetChunks()->requests()->Get(0)->id();
    co_await m.peer.send(error_frame(wire::ErrorCode::out_of_range, "too far", id));
    id = (co_await m.peer.receive())->body_as_GetChunks()->requests()->Get(0)->id();
    co_await m.peer.send(chunk_frame(id, key_at(2, 0, 0), some_chunk(key_at(2, 0, 0))));
  };
  run(m.io, {visit, serve});
}

TEST_CASE("a cancelled request is answered once, by the server's confirmation") {
  RequestBench m;
  int answers = 0;
  const auto visit = [&]() -> asio::awaitable<void> {
    co_await m.join();
    const auto id = m.client.get(key_at(1, 0, 0), std::nullopt, [&](const Result<ReceivedChunk>& chunk) {
      ++answers;
      CHECK(chunk.error().kind == ErrorKind::cancelled);
    });
    (void)co_await m.client.ping();  // the request is on its way
    m.client.cancel(id);
    m.client.cancel(id);
    (void)co_await m.client.ping();
    CHECK(answers == 1);
  };
  const auto serve = [&]() -> asio::awaitable<void> {
    co_await m.peer.welcome();
    for (int pongs = 0; pongs < 2;) {
      const auto* message = co_await m.peer.receive();
      if (const auto* cancel = message->body_as_Cancel()) {
        REQUIRE(cancel->ids()->size() == 1);
        co_await m.peer.send(error_frame(wire::ErrorCode::cancelled, "", cancel->ids()->Get(0)));
      } else if (const auto* ping = message->body_as_Ping()) {
        const auto nonce = ping->nonce();
        // The second Pong waits for the Cancel, which may come in the same or the next frame.
        if (pongs == 1 && answers == 0) {
          const auto* next = co_await m.peer.receive();
          co_await m.peer.send(
              error_frame(wire::ErrorCode::cancelled, "", next->body_as_Cancel()->ids()->Get(0)));
        }
        co_await m.peer.send(protocol::make_frame([&](auto& b) { return wire::CreatePong(b, nonce); }));
        ++pongs;
      }
    }
  };
  run(m.io, {visit, serve});
}

TEST_CASE("heights come in the order asked") {
  RequestBench m;
  const std::vector<Column> columns{{1, 2}, {-3, 4}};
  const auto visit = [&]() -> asio::awaitable<void> {
    co_await m.join();
    const auto heights = co_await m.client.get_heights(columns);
    REQUIRE(heights.has_value());
    CHECK(*heights == std::vector<std::int32_t>{100, -200});
  };
  const auto serve = [&]() -> asio::awaitable<void> {
    co_await m.peer.welcome();
    const auto* get = (co_await m.peer.receive())->body_as_GetHeights();
    REQUIRE(get != nullptr);
    CHECK(get->columns()->Get(1)->x() == -3);
    const std::vector<std::int32_t> heights{100, -200};
    const auto id = get->id();
    co_await m.peer.send(
        protocol::make_frame([&](auto& b) { return wire::CreateHeights(b, id, b.CreateVector(heights)); }));
  };
  run(m.io, {visit, serve});
}

TEST_CASE("places have the names of Welcome") {
  RequestBench m;
  const std::vector<Column> one{{1, 2}};
  const std::vector<Column> two{{1, 2}, {-3, 4}};
  const std::vector<std::uint8_t> one_zero{1, 0};
  const std::vector<std::uint8_t> zero_one{0, 1};
  const std::vector<std::string> unknown{"height"};
  const std::vector<std::string> known{"moisture", "temperature"};
  const auto visit = [&]() -> asio::awaitable<void> {
    co_await m.join();
    const auto none = co_await m.client.get_places(one, unknown);
    CHECK(none.error().message == "this world has no field 'height'");
    const auto places = co_await m.client.get_places(two, known);
    REQUIRE(places.has_value());
    CHECK(places->heights_fx == std::vector<std::int32_t>{100, -200});
    CHECK(places->looks == one_zero);
    CHECK(places->values == std::vector<float>{0.5F, 1.5F, -2.5F, 3.5F});
    const auto wrong = co_await m.client.get_places(one, std::vector<std::string>{});
    CHECK(wrong.error().kind == ErrorKind::broken_protocol);
  };
  const auto serve = [&]() -> asio::awaitable<void> {
    co_await m.peer.welcome();
    const auto* get = (co_await m.peer.receive())->body_as_GetHeights();
    REQUIRE(get != nullptr);
    CHECK(get->looks());
    CHECK(std::vector<std::uint8_t>(get->fields()->begin(), get->fields()->end()) == one_zero);
    const auto answer = [&](std::uint32_t id, const std::vector<std::uint8_t>& looks) {
      return protocol::make_frame([&](auto& b) {
        const auto heights = b.CreateVector(std::vector<std::int32_t>{100, -200});
        const auto look_list = b.CreateVector(looks);
        return wire::CreateHeights(b, id, heights, look_list,
                                   b.CreateVector(std::vector<float>{0.5F, 1.5F, -2.5F, 3.5F}));
      });
    };
    const auto first = get->id();
    co_await m.peer.send(answer(first, one_zero));
    get = (co_await m.peer.receive())->body_as_GetHeights();
    const auto second = get->id();
    co_await m.peer.send(answer(second, zero_one));
  };
  run(m.io, {visit, serve});
}

TEST_CASE("a request that the server cannot answer is refused before it is sent") {
  RequestBench m;
  const auto visit = [&]() -> asio::awaitable<void> {
    const auto early = co_await m.client.get(key_at(0, 0, 0));
    CHECK(early.error().kind == ErrorKind::not_connected);
    co_await m.join();
    const auto edge = co_await m.client.get(key_at(1 << 30, 0, 0, 1));
    CHECK(edge.error().kind == ErrorKind::out_of_range);
    const auto heights = co_await m.client.get_heights(std::vector<Column>(5000));
    CHECK(heights.error().kind == ErrorKind::out_of_range);
  };
  run(m.io, {visit, [&]() -> asio::awaitable<void> { co_await m.peer.welcome(); }});
}

TEST_CASE("credit is the running total of chunk frames, sent at half a window") {
  RequestBench m;
  constexpr std::uint64_t kWindow = 2000;
  const auto visit = [&]() -> asio::awaitable<void> {
    co_await m.join();
    (void)co_await m.client.get(key_at(1000, 0, 0));
  };
  const auto serve = [&]() -> asio::awaitable<void> {
    co_await m.peer.welcome(1, kWindow);
    const auto last = (co_await m.peer.receive())->body_as_GetChunks()->requests()->Get(0)->id();
    std::uint64_t sent = 0;
    std::uint64_t credited = 0;
    // Chunks of a View that is not there count as taken all the same.
    for (int i = 0; i < 40; ++i) {
      const auto frame = chunk_frame(0, key_at(i, 0, 0), some_chunk(key_at(i, 0, 0)));
      sent += frame.size();
      co_await m.peer.send(frame);
      while ((sent - credited) * 2 >= kWindow) {
        const auto* credit = (co_await m.peer.receive())->body_as_Credit();
        REQUIRE(credit != nullptr);
        REQUIRE(credit->total_bytes() > credited);
        REQUIRE(credit->total_bytes() <= sent);
        credited = credit->total_bytes();
      }
    }
    REQUIRE(credited > 0);
    co_await m.peer.send(chunk_frame(last, key_at(1000, 0, 0), some_chunk(key_at(1000, 0, 0))));
  };
  run(m.io, {visit, serve});
}

}  // namespace talus::client
