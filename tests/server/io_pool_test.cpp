#include "net/io_pool.h"

#include <asio/post.hpp>
#include <atomic>
#include <catch2/catch.hpp>
#include <stdexcept>

using namespace talus::server;

TEST_CASE("an exception of a handler ends no thread") {
  constexpr int kThreads = 3;
  IoPool pool{kThreads, make_logger("off", "text")};
  std::atomic<int> still_served = 0;
  for (int thread = 0; thread < kThreads; ++thread) {
    asio::io_context& context = pool.next();
    asio::post(context, [] { throw std::runtime_error{"out of something"}; });
    asio::post(context, [&] {
      if (++still_served == kThreads) pool.stop();
    });
  }
  pool.run();
  CHECK(still_served == kThreads);
}
