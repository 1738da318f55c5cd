#include "servers.h"

#include <asio/use_awaitable.hpp>
#include <catch2/catch.hpp>
#include <set>
#include <string>

#include "peer.h"

namespace talus::client {
namespace {

using namespace testing;
using namespace std::chrono_literals;
using asio::ip::tcp;

tcp::resolver::results_type found(const std::vector<std::string>& addresses) {
  std::vector<tcp::endpoint> endpoints;
  for (const std::string& address : addresses) endpoints.emplace_back(asio::ip::make_address(address), 4780);
  return tcp::resolver::results_type::create(endpoints.begin(), endpoints.end(), "talus", "4780");
}

std::vector<std::string> in_order(Servers& servers, const std::vector<std::string>& addresses) {
  std::vector<std::string> order;
  for (const auto& endpoint : servers.in_order(found(addresses)))
    order.push_back(endpoint.address().to_string());
  return order;
}

/// Comes back at once, and goes around all servers as often as it needs to.
Options with_more(const Peer& more) {
  Options options;
  options.reconnect.max_attempts = 5;
  options.reconnect.first_delay = 1ms;
  options.reconnect.max_delay = 2ms;
  options.more_servers = {{"127.0.0.1", more.port()}};
  return options;
}

protocol::Frame go_away_frame(std::chrono::milliseconds retry_after) {
  return protocol::make_frame([&](auto& b) {
    return wire::CreateGoAway(b, b.CreateString("an update"),
                              static_cast<std::uint32_t>(retry_after.count()));
  });
}

}  // namespace

TEST_CASE("servers take turns, and each is left alone for as long as it asked") {
  Servers servers{{"a", "1"}, {{"b", "2"}, {"c", "3"}}, 1};
  CHECK(servers.count() == 3);
  CHECK(servers.current().host == "a");
  const Clock::Time start{1s};
  CHECK(servers.leave(start, 5s) == 0ms);
  CHECK(servers.current().host == "b");
  CHECK(servers.leave(start + 1s, 0s) == 0ms);
  CHECK(servers.current().host == "c");
  CHECK(servers.leave(start + 2s, 0s) == 3s);
  CHECK(servers.current().host == "a");
  Servers alone{{"a", "1"}, {}, 1};
  CHECK(alone.leave(start, 5s) == 5s);
  CHECK(alone.current().host == "a");
  CHECK(alone.leave(start, 1h) == kLongestRetryAfter);
}

TEST_CASE("any address of a name may be first, with the system's first family before others") {
  const std::vector<std::string> addresses{"2001:db8::1", "2001:db8::2", "10.0.0.1", "10.0.0.2", "10.0.0.3"};
  std::set<std::string> first;
  std::set<std::string> third;
  for (std::uint64_t seed = 0; seed < 64; ++seed) {
    Servers servers{{"talus", "4780"}, {}, seed};
    const auto order = in_order(servers, addresses);
    CHECK(std::set<std::string>(order.begin(), order.end()) ==
          std::set<std::string>(addresses.begin(), addresses.end()));
    first.insert(order[0]);
    third.insert(order[2]);
  }
  CHECK(first == std::set<std::string>{"2001:db8::1", "2001:db8::2"});
  CHECK(third == std::set<std::string>{"10.0.0.1", "10.0.0.2", "10.0.0.3"});
}

TEST_CASE("the address that was reached before is the last of its family") {
  for (std::uint64_t seed = 0; seed < 16; ++seed) {
    Servers servers{{"talus", "4780"}, {}, seed};
    servers.reached({asio::ip::make_address("10.0.0.2"), 4780});
    CHECK(in_order(servers, {"10.0.0.1", "10.0.0.2", "10.0.0.3"}).back() == "10.0.0.2");
    CHECK(in_order(servers, {"10.0.0.2"}).back() == "10.0.0.2");
  }
}

TEST_CASE("a client asked to leave goes to another server with its View and its unanswered requests") {
  asio::io_context io;
  Peer leaves{io};
  Peer stays{io};
  int back = 0;
  Events events;
  events.on_reconnect = [&](const WorldInfo&) { ++back; };
  Client client{io.get_executor(), with_more(stays), events};
  View view;
  view.centre = {100, 0, 0};
  const auto visit = [&]() -> asio::awaitable<void> {
    co_await join(client, leaves);
    REQUIRE(client.set_view(view).has_value());
    const auto chunk = co_await client.get(key_at(1, 2, 3));
    REQUIRE(chunk.has_value());
  };
  const auto leave = [&]() -> asio::awaitable<void> {
    co_await leaves.welcome();
    while ((co_await leaves.receive())->body_type() != wire::Body::GetChunks) {
    }
    co_await leaves.send(go_away_frame(1h));  // before anybody comes back there: not to the other server
    leaves.hang_up();
  };
  const auto stay = [&]() -> asio::awaitable<void> {
    co_await stays.welcome();
    std::optional<std::uint32_t> id;
    bool view_seen = false;
    while (!id || !view_seen) {
      const auto* message = co_await stays.receive();
      if (const auto* again = message->body_as_View()) view_seen = again->centre()->x() == 100;
      if (const auto* get = message->body_as_GetChunks()) id = get->requests()->Get(0)->id();
    }
    co_await stays.send(chunk_frame(*id, key_at(1, 2, 3), some_chunk(key_at(1, 2, 3))));
  };
  run(io, {visit, leave, stay});
  CHECK(back == 1);
}

TEST_CASE("if the first server cannot be reached the next is tried, once each") {
  asio::io_context io;
  Peer away{io};
  Peer there{io};
  const std::string port = away.port();
  away.stop_listening();
  Client client{io.get_executor(), with_more(there)};
  const auto visit = [&]() -> asio::awaitable<void> {
    const auto world = co_await client.connect("127.0.0.1", port);
    REQUIRE(world.has_value());
    client.close();
    there.stop_listening();
    const auto nowhere = co_await client.connect("127.0.0.1", port);
    REQUIRE_FALSE(nowhere.has_value());
    CHECK(nowhere.error().kind == ErrorKind::unreachable);
  };
  const auto serve = [&]() -> asio::awaitable<void> { co_await there.welcome(); };
  run(io, {visit, serve});
}

TEST_CASE("a server of another world among several is passed over") {
  asio::io_context io;
  Peer own{io};
  Peer other{io};
  Client client{io.get_executor(), with_more(other)};
  const auto visit = [&]() -> asio::awaitable<void> {
    co_await join(client, own);
    const auto chunk = co_await client.get(key_at(1, 2, 3));
    REQUIRE(chunk.has_value());
  };
  const auto serve = [&]() -> asio::awaitable<void> {
    co_await own.welcome(1);
    (void)co_await own.receive();
    own.hang_up();
    co_await other.welcome(2);
    co_await own.welcome(1);
    const auto* message = co_await own.receive();
    while (message->body_type() != wire::Body::GetChunks) message = co_await own.receive();
    const std::uint32_t id = message->body_as_GetChunks()->requests()->Get(0)->id();
    co_await own.send(chunk_frame(id, key_at(1, 2, 3), some_chunk(key_at(1, 2, 3))));
  };
  run(io, {visit, serve});
}

}  // namespace talus::client
