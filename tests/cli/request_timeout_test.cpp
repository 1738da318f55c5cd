#include "request_timeout.h"

#include <asio/io_context.hpp>

#include <catch2/catch.hpp>

#include "manual_clock.h"

using namespace talus;
using namespace talus::cli;
using std::chrono::seconds;

namespace {

/// A timeout of 30 seconds over a client that waits for nobody.
struct TimeoutBench {
  client::testing::ManualClock clock;
  asio::io_context io;
  client::Client client{io.get_executor()};
  RequestTimeout timeout{io.get_executor(), clock, client, seconds{30}};

  [[nodiscard]] bool expired_after(seconds time) {
    clock.advance(time);
    io.restart();
    io.poll();
    return timeout.has_expired();
  }
};

const client::ClientError kError{client::ErrorKind::server_failed, "the server says: no luck", {}};

}  // namespace

TEST_CASE("a timeout expires after its time and says so") {
  TimeoutBench waiting;
  CHECK_FALSE(waiting.expired_after(seconds{29}));
  CHECK(waiting.timeout.explain(kError) == "the server says: no luck");
  CHECK(waiting.expired_after(seconds{1}));
  CHECK(waiting.timeout.explain(kError) == "the server has not answered within 30 s");
}

TEST_CASE("a timeout that was restarted lasts its whole time again") {
  TimeoutBench waiting;
  CHECK_FALSE(waiting.expired_after(seconds{20}));
  waiting.timeout.restart();
  CHECK_FALSE(waiting.expired_after(seconds{10}));  // the old end
  CHECK_FALSE(waiting.expired_after(seconds{19}));
  CHECK(waiting.expired_after(seconds{1}));
}
