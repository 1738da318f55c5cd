// What a round trip costs at least: an echo server and its clients in one process, over loopback, one thread
// each side. Beside it stands how many edits a second talusd answers to as many clients (run.sh edits).
//
//   talus-echo CONNECTIONS BYTES SECONDS
#include <array>
#include <charconv>
#include <chrono>
#include <cstdio>
#include <functional>
#include <memory>
#include <string_view>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include <asio/io_context.hpp>
#include <asio/ip/tcp.hpp>
#include <asio/read.hpp>
#include <asio/write.hpp>

#include "measure/histogram.h"

namespace {

using asio::ip::tcp;
using Clock = std::chrono::steady_clock;

/// Sends what comes back where it came from, and where it began it counts.
class End : public std::enable_shared_from_this<End> {
 public:
  using OnEcho = std::function<void(Clock::duration)>;
  End(tcp::socket socket, std::size_t bytes, OnEcho counted)
      : socket_{std::move(socket)}, buffer_(bytes), counted_{std::move(counted)} {
    socket_.set_option(tcp::no_delay{true});
  }
  void send() {
    sent_ = Clock::now();
    asio::async_write(socket_, asio::buffer(buffer_),
                      [self = shared_from_this()](std::error_code error, std::size_t) {
                        if (!error) self->receive();
                      });
  }
  void receive() {
    asio::async_read(socket_, asio::buffer(buffer_),
                     [self = shared_from_this()](std::error_code error, std::size_t) {
                       if (error) return;
                       if (self->counted_) self->counted_(Clock::now() - self->sent_);
                       self->send();
                     });
  }

 private:
  tcp::socket socket_;
  std::vector<char> buffer_;
  OnEcho counted_;
  Clock::time_point sent_{};
};

std::size_t number(const char* text) {
  const std::string_view view{text};
  std::size_t value = 0;
  const auto [stop, error] = std::from_chars(view.data(), view.data() + view.size(), value);
  return error == std::errc{} && stop == view.data() + view.size() ? value : 0;
}

}  // namespace

int main(int argc, char** argv) {
  std::array<std::size_t, 3> given{};
  for (int i = 1; i < argc && i <= 3; ++i) given[static_cast<std::size_t>(i) - 1] = number(argv[i]);
  const auto [connections, bytes, seconds] = given;
  if (argc != 4 || connections == 0 || bytes == 0 || seconds == 0) {
    std::fputs("usage: talus-echo CONNECTIONS BYTES SECONDS\n", stderr);
    return 2;
  }
  asio::io_context server{1};
  asio::io_context clients{1};
  tcp::acceptor acceptor{server, {asio::ip::address_v4::loopback(), 0}};
  talus::measure::Histogram trips;
  for (std::size_t i = 0; i < connections; ++i) {
    tcp::socket near{clients};
    near.connect(acceptor.local_endpoint());
    std::make_shared<End>(acceptor.accept(), bytes, End::OnEcho{})->receive();
    std::make_shared<End>(std::move(near), bytes, [&](Clock::duration time) { trips.record(time); })->send();
  }
  std::thread serving{[&] { server.run(); }};
  const auto began = Clock::now();
  clients.run_for(std::chrono::seconds{seconds});
  const double took = std::chrono::duration<double>(Clock::now() - began).count();
  server.stop();
  serving.join();
  std::printf("echo of %zu bytes, %zu connections: %.0f round trips/s, p50 %.3f ms, p99 %.3f ms\n", bytes,
              connections, static_cast<double>(trips.count()) / took, trips.percentile_ms(0.5),
              trips.percentile_ms(0.99));
  return 0;
}
