// How long a Pong waits behind a View's chunks, on a link of a given speed: a client and a slow link in one
// program, against a server that runs already. Prints; judges nothing.
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>

#include <asio/io_context.hpp>
#include <asio/steady_timer.hpp>

#include <talus/client/client.h>

#include "fault_proxy.h"
#include "measure/histogram.h"

namespace {

using namespace talus;
using std::chrono::milliseconds;
using std::chrono::seconds;
using Clock = std::chrono::steady_clock;

constexpr milliseconds kBetweenPings{50};
constexpr seconds kSettling{2};  // in which the first chunks come
constexpr seconds kDuration{15};

struct Measurement {
  talus::measure::Histogram waits;
  std::uint64_t chunk_bytes = 0;
  bool failed = false;
};

Measurement measure_pings(std::uint16_t server_port, std::uint64_t bytes_per_second, std::uint16_t radius) {
  load::Faults link;
  link.bytes_per_second = bytes_per_second;
  link.queue_bytes = 4096;
  const load::FaultProxy proxy{server_port, {}, bytes_per_second == 0 ? load::Faults{} : link};
  Measurement measured;
  asio::io_context io;
  const client::Options options;  // named: of a temporary GCC 12 says that it may be uninitialised
  client::Client client{io.get_executor(), options};
  const auto begin = Clock::now();
  asio::steady_timer next{io};
  std::function<void()> ping = [&] {
    const auto now = Clock::now();
    if (now - begin > kSettling + kDuration) return io.stop();
    const bool counts = now - begin > kSettling;
    client.ping([&, counts](const client::Result<std::chrono::nanoseconds>& wait) {
      if (wait && counts) measured.waits.record(*wait);
    });
    next.expires_at(now + kBetweenPings);
    next.async_wait([&](std::error_code cancelled) {
      if (!cancelled) ping();
    });
  };
  client.connect("127.0.0.1", std::to_string(proxy.port()),
                 [&](const client::Result<client::WorldInfo>& world) {
                   measured.failed = !world || !client.set_view({world->spawn, {}, radius, 8, {}});
                   if (measured.failed) return io.stop();
                   ping();
                 });
  io.run();
  measured.chunk_bytes = client.stats().chunk_bytes;
  return measured;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) {
    std::fputs("usage: talus-pong SERVER_PORT KILOBITS_A_SECOND RADIUS   (0 kilobits: no limit)\n", stderr);
    return 2;
  }
  const auto port = static_cast<std::uint16_t>(std::strtoul(argv[1], nullptr, 10));
  const std::uint64_t kilobits = std::strtoull(argv[2], nullptr, 10);
  const auto radius = static_cast<std::uint16_t>(std::strtoul(argv[3], nullptr, 10));
  const Measurement measured = measure_pings(port, kilobits * 125, radius);
  if (measured.failed) {
    std::fprintf(stderr, "talus-pong: no server answers on 127.0.0.1:%u\n", unsigned{port});
    return 1;
  }
  std::printf(
      "link %llu kbit/s: %llu Pongs, p50 %.1f ms, p99 %.1f ms, max %.1f ms; %llu bytes of chunks in %lld s\n",
      static_cast<unsigned long long>(kilobits), static_cast<unsigned long long>(measured.waits.count()),
      measured.waits.percentile_ms(0.5), measured.waits.percentile_ms(0.99), measured.waits.max_ms(),
      static_cast<unsigned long long>(measured.chunk_bytes),
      static_cast<long long>((kSettling + kDuration).count()));
  return 0;
}
