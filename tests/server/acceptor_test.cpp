// The acceptor over real sockets, where what goes wrong goes wrong in the system.
#include "net/acceptor.h"

#include <sys/socket.h>

#include <asio/post.hpp>
#include <catch2/catch.hpp>

#include <algorithm>
#include <cerrno>
#include <functional>
#include <new>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "descriptors_left.h"
#include "failing_allocations.h"
#include "logged_lines.h"
#include "runtime/log/logger.h"
#include "runtime/manual_clock.h"

using namespace talus::server;
using asio::ip::tcp;

namespace {

struct Bench {
  asio::io_context io{1};
  ManualClock clock;
  std::shared_ptr<LoggedLines> log = std::make_shared<LoggedLines>();
  Acceptor acceptor{io, log, clock};
  std::vector<tcp::socket> accepted;
  tcp::endpoint address;

  Bench() {
    const auto listening = acceptor.listen({"127.0.0.1", 0});
    REQUIRE(listening.has_value());
    const auto port = std::stoi(listening->substr(listening->rfind(':') + 1));
    address = {asio::ip::address_v4::loopback(), static_cast<std::uint16_t>(port)};
    acceptor.start([this]() -> asio::io_context& { return next_context(); },
                   [this](tcp::socket socket) { accepted.push_back(std::move(socket)); },
                   [this] { return make_room(); });
  }

  std::function<asio::io_context&()> next_context = [this]() -> asio::io_context& { return io; };
  std::function<bool()> make_room = [] { return false; };

  [[nodiscard]] tcp::socket connect() {
    tcp::socket client{io};
    client.connect(address);
    return client;
  }
  void run_until_accepted(std::size_t count) {
    while (accepted.size() < count) io.run_one();
  }
};

}  // namespace

TEST_CASE("connections that are reset before they are accepted take nothing from later ones") {
  Bench bench;
  for (int i = 0; i < 100; ++i) {
    tcp::socket gone = bench.connect();
    gone.set_option(asio::socket_base::linger{true, 0});
    gone.close();
  }
  const tcp::socket client = bench.connect();
  const tcp::endpoint own = client.local_endpoint();
  const auto came = [&] {
    for (const tcp::socket& socket : bench.accepted) {
      std::error_code gone;
      if (socket.remote_endpoint(gone) == own && !gone) return true;
    }
    return false;
  };
  while (!came()) bench.io.run_one();
}

TEST_CASE("without descriptors connections wait until there is one") {
  Bench bench;
  const tcp::socket client = bench.connect();
  {
    const DescriptorsLeft none{0};
    bench.io.poll();
    bench.io.poll();
    CHECK(bench.accepted.empty());
  }
  bench.run_until_accepted(1);
}

TEST_CASE("without descriptors a connection that is closed makes room for the next") {
  Bench bench;
  bench.make_room = [&] {
    if (bench.accepted.empty()) return false;
    bench.accepted.front().close();
    return true;
  };
  const tcp::socket first = bench.connect();
  bench.run_until_accepted(1);
  const tcp::socket second = bench.connect();
  const DescriptorsLeft none{0};
  bench.run_until_accepted(2);
  CHECK_FALSE(bench.accepted.front().is_open());
}

TEST_CASE("failed accepts share one log line in five seconds, even if some succeed between them") {
  Bench bench;
  int failures = 0;
  bench.next_context = [&]() -> asio::io_context& {
    if (++failures % 2 == 1) throw std::bad_alloc{};
    return bench.io;
  };
  std::vector<tcp::socket> clients;
  for (int i = 0; i < 4; ++i) clients.push_back(bench.connect());
  bench.run_until_accepted(3);
  CHECK(bench.log->count() == 1);
  bench.clock.advance(std::chrono::seconds{5});
  bench.run_until_accepted(4);
  CHECK(bench.log->count() == 2);
  CHECK_THAT(bench.log->text(),
             Catch::Contains("1 accept failed in the last 1 s, the last one: std::bad_alloc"));
  CHECK_THAT(bench.log->text(),
             Catch::Contains("3 accepts failed in the last 5 s, the last one: std::bad_alloc"));
}

TEST_CASE("the acceptor goes on after an accept that fails, whichever allocation fails then") {
  bool failed = true;
  for (std::size_t allocations = 0; failed; ++allocations) {
    CAPTURE(allocations);
    Bench bench;
    bool first = true;
    bench.next_context = [&]() -> asio::io_context& {
      if (std::exchange(first, false)) throw std::system_error{ENOMEM, std::system_category()};
      return bench.io;
    };
    std::vector<tcp::socket> clients;  // one of them may be lost
    for (int i = 0; i < 2; ++i) clients.push_back(bench.connect());
    bool goes_on = true;
    {
      const talus::test::FailingAllocations failing{allocations};
      while (goes_on && bench.accepted.empty()) goes_on = bench.io.run_one() > 0;
      failed = failing.has_failed();
    }
    REQUIRE(goes_on);
    bench.run_until_accepted(failed ? 1 : 2);
    clients.push_back(bench.connect());
    bench.run_until_accepted(bench.accepted.size() + 1);
  }
}

TEST_CASE("an acceptor that finds no memory for anything leaves its thread to others, until it finds some") {
  Bench bench;
  bool memory = false;
  bench.next_context = [&]() -> asio::io_context& {
    if (!memory) throw std::bad_alloc{};
    return bench.io;
  };
  const tcp::socket client = bench.connect();
  int others = 0;
  for (int i = 0; i < 3; ++i) {
    asio::post(bench.io, [&] { ++others; });
    while (others <= i) {
      const talus::test::FailingAllocations failing{0};
      bench.io.run_one();
    }
  }
  CHECK(bench.accepted.empty());
  memory = true;
  bench.run_until_accepted(1);
}

TEST_CASE("an exception of a new connection's handler does not end the acceptor") {
  asio::io_context io{1};
  const ManualClock clock;
  Acceptor acceptor{io, make_logger("off", "text"), clock};
  const auto listening = acceptor.listen({"127.0.0.1", 0});
  REQUIRE(listening.has_value());
  int came = 0;
  acceptor.start([&]() -> asio::io_context& { return io; },
                 [&](const tcp::socket&) {
                   ++came;
                   throw std::bad_alloc{};
                 });
  std::vector<tcp::socket> clients;
  const auto port = static_cast<std::uint16_t>(std::stoi(listening->substr(listening->rfind(':') + 1)));
  for (int i = 0; i < 2; ++i) {
    clients.emplace_back(io).connect({asio::ip::address_v4::loopback(), port});
  }
  while (came < 2) io.run_one();
}

TEST_CASE("an address in use is an error, and so is a foreign address") {
  Bench bench;
  asio::io_context io;
  Acceptor other{io, make_logger("off", "text"), bench.clock};
  CHECK_FALSE(other.listen({"127.0.0.1", bench.address.port()}).has_value());
  Acceptor nowhere{io, make_logger("off", "text"), bench.clock};
  CHECK_FALSE(nowhere.listen({"nowhere.invalid", 1}).has_value());
}

TEST_CASE("a closed acceptor ends") {
  Bench bench;
  bench.acceptor.close();
  bench.io.run();
  CHECK(bench.accepted.empty());
}
