// The order in which an io thread serves flows, whatever number of connections each has.
#include "net/io_turns.h"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <asio/post.hpp>

#include "loopback_stream.h"
#include "net/http/connection.h"
#include "runtime/manual_clock.h"

namespace talus::server {
namespace {

constexpr auto kTurn = static_cast<std::ptrdiff_t>(IoTurns::kTurn);

/// Connections that have pieces to do, and what was done.
struct Pieces {
  asio::io_context io{1};
  IoTurns& turns = asio::use_service<IoTurns>(io);
  std::vector<FlowId> done;

  struct Connection final : IoTurns::Waiter, std::enable_shared_from_this<Connection> {
    Connection(Pieces& of, FlowId its, std::size_t all, std::uint64_t each)
        : pieces{of}, flow{its}, left{all}, cost{each} {}
    void take_turn() override {
      for (; left > 0; --left) {
        if (!pieces.turns.go_on(flow, cost)) {
          return pieces.turns.wait(flow, shared_from_this(), pieces.io.get_executor());
        }
        pieces.done.push_back(flow);
      }
    }
    Pieces& pieces;
    const FlowId flow;
    std::size_t left;
    const std::uint64_t cost;
  };

  void begin(FlowId flow, std::size_t pieces, std::uint64_t cost = 1) {
    std::make_shared<Connection>(*this, flow, pieces, cost)->take_turn();
  }
  [[nodiscard]] std::ptrdiff_t count(FlowId flow) const { return std::count(done.begin(), done.end(), flow); }
};

constexpr FlowId kGreedy{1};
constexpr FlowId kOther{2};
constexpr FlowId kProbe{3};

}  // namespace

TEST_CASE("a flow goes on at once for a turn, and then waits behind what came meanwhile") {
  Pieces pieces;
  for (int i = 0; i < 250; ++i) pieces.begin(kGreedy, 100);
  CHECK(pieces.count(kGreedy) == kTurn);
  for (std::ptrdiff_t turn = 2; turn <= 20; ++turn) {
    asio::post(pieces.io, [&] { pieces.begin(kProbe, 1); });
    pieces.io.poll_one();  // a turn
    CHECK(pieces.count(kGreedy) == turn * kTurn);
    pieces.io.poll_one();
    CHECK(pieces.done.back() == kProbe);
  }
  pieces.io.poll();
  CHECK(pieces.count(kGreedy) == 250 * 100);
}

TEST_CASE("flows that wait take turns, however many connections each has") {
  Pieces pieces;
  for (int i = 0; i < 250; ++i) pieces.begin(kGreedy, 100);
  pieces.begin(kOther, 10 * static_cast<std::size_t>(kTurn));
  while (pieces.count(kOther) < 10 * kTurn) {
    pieces.io.poll_one();
    CHECK(std::abs(pieces.count(kGreedy) - pieces.count(kOther)) <= kTurn);
  }
}

TEST_CASE("connections of a flow go on in the order in which they began to wait") {
  Pieces pieces;
  std::vector<std::shared_ptr<Pieces::Connection>> all;
  for (int i = 0; i < 4; ++i) {
    all.push_back(std::make_shared<Pieces::Connection>(pieces, kGreedy, 40, 1));
    all.back()->take_turn();
  }
  std::vector<std::size_t> left;
  for (int turn = 0; turn < 4; ++turn) {
    pieces.io.poll_one();
    for (const auto& each : all) left.push_back(each->left);
  }
  CHECK(left == std::vector<std::size_t>{0, 16, 40, 40, 0, 16, 8, 40, 0, 16, 8, 8, 0, 0, 0, 0});
}

TEST_CASE("a connection waits behind those of its flow, also in a round in which it has not had its turn") {
  Pieces pieces;
  pieces.begin(kOther, 100);
  pieces.begin(kGreedy, 100);
  pieces.io.poll_one();  // the other's turn
  const auto late = std::make_shared<Pieces::Connection>(pieces, kGreedy, 1, 1);
  late->take_turn();
  CHECK(late->left == 1);
  pieces.io.poll();
  CHECK(late->left == 0);
}

TEST_CASE("a piece that costs more than a turn is paid in further rounds") {
  Pieces pieces;
  pieces.begin(kGreedy, 20, 4 * IoTurns::kTurn);
  pieces.begin(kOther, 20 * static_cast<std::size_t>(kTurn));
  pieces.io.poll();
  const auto last = std::find(pieces.done.rbegin(), pieces.done.rend(), kOther);
  const auto before = std::count(last, pieces.done.rend(), kGreedy);
  CHECK(before >= 5);
  CHECK(before <= 6);
  CHECK(pieces.count(kGreedy) == 20);
}

TEST_CASE("what waits when the thread ends is dropped") {
  Pieces pieces;
  const auto waits = std::make_shared<Pieces::Connection>(pieces, kGreedy, 100, 1);
  waits->take_turn();
  CHECK(waits.use_count() == 2);
}

// ---- connections

namespace {

/// Answers with the path; the query names the client.
class ByQuery final : public http::Handler {
 public:
  explicit ByQuery(std::vector<char>& answered) : answered_{answered} {}
  std::optional<http::Response> respond_now(const http::Request& request, Clock::time_point) override {
    answered_.push_back(request.query()->front());
    const bool large = request.path() == "/large";
    return http::Response{200, http::kPlainText, std::string(large ? 1U << 20U : 10U, 'x')};
  }
  asio::awaitable<http::Response> respond(const http::Request&) override { co_return http::Response{}; }
  [[nodiscard]] FlowId flow_of(const http::Request& request) const override {
    return FlowId{static_cast<std::uint64_t>(request.query()->front())};
  }

 private:
  std::vector<char>& answered_;
};

template <typename S>
struct Web {
  ManualClock clock;
  asio::io_context io{1};
  asio::executor_work_guard<asio::io_context::executor_type> guard{io.get_executor()};
  http::Service service{clock, make_logger("off", "text")};
  std::vector<char> answered;
  const std::shared_ptr<http::Handler> handler = std::make_shared<ByQuery>(answered);

  std::shared_ptr<Loopback> connect() {
    auto client = std::make_shared<Loopback>(io);
    std::make_shared<http::Connection<S>>(S{client}, service, handler)->start();
    io.poll();
    return client;
  }
};

std::string get(const std::string& target) {
  return "GET " + target + " HTTP/1.1\r\nHost: a\r\n\r\n";
}

}  // namespace

TEMPLATE_TEST_CASE("a request is answered after a turn of another client, whichever connections each uses",
                   "", LoopbackStream, EagerLoopbackStream) {
  Web<TestType> web;
  std::vector<std::shared_ptr<Loopback>> greedy;
  for (int i = 0; i < 20; ++i) greedy.push_back(web.connect());
  const bool shared = GENERATE(false, true);  // a proxy's connection that has carried requests of both
  const auto probe = web.connect();
  if (shared) {
    probe->send(get("/?g"));
    web.io.poll();
  }
  std::string flood;
  for (int i = 0; i < 300; ++i) flood += get("/?g");
  for (const auto& each : greedy) each->send(flood);
  probe->send(get("/?p"));
  web.io.poll();
  CHECK(std::count(web.answered.begin(), web.answered.end(), 'g') == 20 * 300 + (shared ? 1 : 0));
  const auto answered = std::find(web.answered.begin(), web.answered.end(), 'p');
  CHECK(answered - web.answered.begin() <= 2 * kTurn);
}

TEMPLATE_TEST_CASE("requests with large heads cost their client turns by their bytes", "", LoopbackStream,
                   EagerLoopbackStream) {
  Web<TestType> web;
  std::vector<std::shared_ptr<Loopback>> greedy;
  for (int i = 0; i < 20; ++i) greedy.push_back(web.connect());
  const auto probe = web.connect();
  const bool repeated = GENERATE(false, true);  // the parser compares a short head with the one before
  std::string large = get("/?g");
  large.insert(large.size() - 2, "X: " + std::string(repeated ? 900 : 4'000, 'x') + "\r\n");
  const std::ptrdiff_t in_a_turn = repeated ? 5 : 1;
  std::string flood;
  for (int i = 0; i < 20; ++i) flood += large;
  for (const auto& each : greedy) each->send(flood);
  probe->send(get("/?p"));
  web.io.poll();
  CHECK(std::count(web.answered.begin(), web.answered.end(), 'g') == 20 * 20);
  const auto answered = std::find(web.answered.begin(), web.answered.end(), 'p');
  CHECK(answered - web.answered.begin() <= 2 * in_a_turn);
}

TEMPLATE_TEST_CASE("large answers are written in turns of their clients", "", LoopbackStream,
                   EagerLoopbackStream) {
  Web<TestType> web;
  std::vector<std::shared_ptr<Loopback>> greedy;
  for (int i = 0; i < 10; ++i) greedy.push_back(web.connect());
  const auto probe = web.connect();
  for (const auto& each : greedy) each->send(get("/large?g"));
  probe->send(get("/?p"));
  while (probe->received.empty()) REQUIRE(web.io.poll_one() == 1);
  std::size_t written = 0;
  for (const auto& each : greedy) written += each->received.size();
  CHECK(written <= 3 * kTurn * IoTurns::kAnswerBytes);
  web.io.poll();
  for (const auto& each : greedy) CHECK(each->received.size() > 1U << 20U);
}

}  // namespace talus::server
