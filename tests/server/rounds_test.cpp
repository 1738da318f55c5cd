#include "net/rounds.h"

#include <catch2/catch.hpp>
#include <functional>
#include <memory>
#include <utility>

#include <asio/executor_work_guard.hpp>
#include <asio/io_context.hpp>

using namespace talus::server;

namespace {

struct Reader {
  explicit Reader(std::function<void()> does = [] {}) : meanwhile{std::move(does)} {}
  void read() {
    ++reads;
    meanwhile();
  }
  std::function<void()> meanwhile;
  int reads = 0;
};

struct Bench {
  asio::io_context io{1};
  asio::executor_work_guard<asio::io_context::executor_type> guard{io.get_executor()};
  Rounds<Reader>& rounds = asio::use_service<Rounds<Reader>>(io);

  void enter(const std::shared_ptr<Reader>& reader) { rounds.enter(reader, io.get_executor()); }
};

}  // namespace

TEST_CASE("all readers that have entered run in one handler, and later ones in another") {
  Bench bench;
  const auto reader = std::make_shared<Reader>();
  bench.enter(reader);
  bench.enter(reader);
  CHECK(bench.io.poll() == 1);
  CHECK(reader->reads == 2);
  bench.enter(reader);
  CHECK(bench.io.poll() == 1);
  CHECK(reader->reads == 3);
}

TEST_CASE("a session that enters during a round is read by the same handler") {
  Bench bench;
  const auto late = std::make_shared<Reader>();
  bench.enter(std::make_shared<Reader>([&] { bench.enter(late); }));
  CHECK(bench.io.poll() == 1);
  CHECK(late->reads == 1);
}

TEST_CASE("a handler reads for a limited number of sessions, also for ones that enter meanwhile") {
  Bench bench;
  int left = 3 * static_cast<int>(Rounds<Reader>::kAtOnce);
  const auto again = std::make_shared<Reader>();
  again->meanwhile = [&] {
    if (--left > 0) bench.enter(again);
  };
  bench.enter(again);
  CHECK(bench.io.poll_one() == 1);
  CHECK(again->reads == static_cast<int>(Rounds<Reader>::kAtOnce));
  bench.io.poll();
  CHECK(again->reads == 3 * static_cast<int>(Rounds<Reader>::kAtOnce));
}
