// Refusals over real sockets, in the test's own thread.
#include "net/refusals.h"

#include <asio/io_context.hpp>
#include <asio/ip/tcp.hpp>
#include <asio/write.hpp>
#include <catch2/catch.hpp>
#include <new>
#include <utility>
#include <vector>

#include "descriptors_left.h"
#include "failing_allocations.h"
#include "net/descriptors.h"

using namespace talus::server;
using asio::ip::tcp;
using talus::test::FailingAllocations;

namespace {

const std::vector<std::byte> kMessage(40, std::byte{7});

struct Bench {
  Refusals refusals;
  asio::io_context io{1};
  tcp::acceptor acceptor{io, {asio::ip::address_v4::loopback(), 0}};

  void refuse(tcp::socket socket, FlowId flow = FlowId{1}) {
    refusals.refuse(std::move(socket), kMessage, flow, Clock::time_point{});
  }
  /// The client's end and the server's.
  [[nodiscard]] std::pair<tcp::socket, tcp::socket> connect() {
    tcp::socket client{io};
    client.connect(acceptor.local_endpoint());
    return {std::move(client), acceptor.accept()};
  }
  /// Returns `count` clients that have been refused and read nothing.
  [[nodiscard]] std::vector<tcp::socket> refused(std::size_t count) {
    std::vector<tcp::socket> clients;
    for (std::size_t i = 0; i < count; ++i) {
      auto [client, socket] = connect();
      refuse(std::move(socket));
      clients.push_back(std::move(client));
    }
    io.poll();
    return clients;
  }
  /// Bytes that a client is sent before the end.
  [[nodiscard]] std::size_t bytes_of_refusal(FlowId flow = FlowId{1}) {
    auto [client, socket] = connect();
    refuse(std::move(socket), flow);
    io.restart();
    io.poll();
    client.shutdown(tcp::socket::shutdown_send);
    std::vector<std::byte> said(1024);
    std::error_code ended;
    const std::size_t bytes = client.read_some(asio::buffer(said), ended);
    while (io.run_one() > 0) continue;  // until the server has seen the end
    return bytes;
  }
};

}  // namespace

TEST_CASE("a refused client gets the reason") {
  Bench bench;
  for (std::size_t i = 0; i < 2 * Refusals::kMax; ++i) REQUIRE(bench.bytes_of_refusal() > 0);
}

TEST_CASE("more refusals than may be in flight are closed without a word, until one has ended") {
  Bench bench;
  auto clients = bench.refused(Refusals::kMax);
  CHECK(bench.bytes_of_refusal() == 0);
  clients.clear();
  bench.io.restart();
  bench.io.run();
  CHECK(bench.bytes_of_refusal() > 0);
}

TEST_CASE("refusals of one flow leave room for those of others") {
  Bench bench;
  const auto clients = bench.refused(Refusals::kMax);
  CHECK(bench.bytes_of_refusal(FlowId{2}) > 0);
}

TEST_CASE("on spare descriptors only a few clients get a reason, and others are closed at once") {
  Bench bench;
  const DescriptorsLeft few{kSpareDescriptors};
  auto clients = bench.refused(Refusals::kMaxSpare);
  CHECK(bench.bytes_of_refusal() == 0);
  clients.clear();
  bench.io.restart();
  bench.io.run();
  CHECK(bench.bytes_of_refusal() > 0);
}

TEST_CASE("a refusal that finds no memory takes no place from the next") {
  Bench bench;
  bool failed = true;
  for (std::size_t allocations = 0; failed; ++allocations) {
    failed = false;
    for (std::size_t i = 0; i < Refusals::kMax; ++i) {
      auto [client, socket] = bench.connect();
      const FailingAllocations failing{allocations};
      try {
        bench.refuse(std::move(socket));
        bench.io.restart();
        bench.io.poll();
      } catch (const std::bad_alloc&) {
        // seen below
      }
      failed = failed || failing.has_failed();
    }
    bench.io.restart();
    bench.io.run();  // those that found memory end
    CAPTURE(allocations);
    REQUIRE(bench.bytes_of_refusal() > 0);
  }
}
