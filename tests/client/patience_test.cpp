#include "patience.h"

#include <asio/this_coro.hpp>
#include <asio/use_awaitable.hpp>
#include <catch2/catch.hpp>

#include "peer.h"

namespace talus::cli {
namespace {

using namespace client::testing;

const ChunkKey kKey = key_at(1, 2, 3);

// What get() comes to, with `time` to wait, from a server that does as `serve` says.
std::string outcome_of(Patience::Seconds time, const std::function<asio::awaitable<void>(Peer&)>& serve) {
  asio::io_context io;
  Peer peer{io};
  std::string outcome = "a chunk";
  const auto visit = [&]() -> asio::awaitable<void> {
    client::Client client{io.get_executor()};
    co_await join(client, peer);
    const Patience patience{io.get_executor(), client, time};
    const auto chunk = co_await client.get(kKey);
    if (!chunk) outcome = patience.explain(chunk.error());
  };
  run(io, {visit, [&] { return serve(peer); }});
  return outcome;
}

}  // namespace

TEST_CASE("a server that says nothing more is not waited for without end") {
  const auto outcome = outcome_of(Patience::Seconds{0.05}, [](Peer& peer) -> asio::awaitable<void> {
    co_await peer.welcome();
    co_await peer.until_closed();
  });
  CHECK(outcome == "the server has not answered within 0.05 s");
}

TEST_CASE("chunks that nobody asked for are no answer") {
  const auto outcome = outcome_of(Patience::Seconds{0.05}, [](Peer& peer) -> asio::awaitable<void> {
    co_await peer.welcome();
    try {
      while (true) co_await peer.send(chunk_frame(0, kKey, some_chunk(kKey)));
    } catch (const std::system_error&) {
      // The client has hung up.
    }
  });
  CHECK(outcome == "the server has not answered within 0.05 s");
}

TEST_CASE("an error that comes in time is told as it is") {
  const auto outcome = outcome_of(Patience::Seconds{60}, [](Peer& peer) -> asio::awaitable<void> {
    co_await peer.welcome();
    const auto id = (co_await peer.receive())->body_as_GetChunks()->requests()->Get(0)->id();
    co_await peer.send(error_frame(wire::ErrorCode::internal, "no luck", id));
    co_await peer.until_closed();
  });
  CHECK_THAT(outcome, Catch::Contains("no luck"));
}

TEST_CASE("renewed patience lasts its whole time again") {
  constexpr std::chrono::milliseconds kTime{500};
  asio::io_context io;
  client::Client client{io.get_executor()};
  Patience patience{io.get_executor(), client, kTime};
  io.run_for(kTime / 10);
  const auto renewed = std::chrono::steady_clock::now();
  patience.renew();
  io.run();
  CHECK(patience.is_over());
  CHECK(std::chrono::steady_clock::now() - renewed >= kTime);
}

}  // namespace talus::cli
