// Sessions that are told to go away, and those whose client sends no more.
#include "player/session/session.h"

#include <algorithm>
#include <catch2/catch.hpp>

#include "session_bench.h"

using namespace talus;
using namespace talus::server;
using namespace std::chrono_literals;
using Body = wire::Body;
using State = Session::State;

TEST_CASE("a leaving session closes when its last request is answered") {
  SessionBench bench;
  bench.get_chunk(1, chunk_at(5));
  bench.session.go_away("ending", 1ms);
  CHECK(bench.session.state() == State::leaving);
  bench.answer_all();
  CHECK(bench.session.state() == State::leaving);
  CHECK(kinds(bench.output()) == Kinds{Body::GoAway, Body::Chunk});
  CHECK(bench.session.state() == State::closed);
}

TEST_CASE("a leaving session closes when its last request is cancelled") {
  SessionBench bench;
  bench.get_chunk(1, chunk_at(5));
  bench.session.go_away("ending", 1ms);
  bench.cancel(1);
  CHECK(bench.session.state() == State::closed);
  CHECK(kinds(bench.output()) == Kinds{Body::GoAway, Body::Error});
}

TEST_CASE("a session without requests closes as soon as it leaves") {
  SessionBench bench;
  bench.session.go_away("ending", 1ms);
  CHECK(bench.session.state() == State::closed);
  CHECK(kinds(bench.output()) == Kinds{Body::GoAway});
}

TEST_CASE("a leaving session refuses new requests") {
  SessionBench bench;
  bench.get_chunk(1, chunk_at(5));
  bench.session.go_away("ending", 1ms);
  bench.get_chunk(2, chunk_at(6));
  bench.get_heights(3);
  const auto said = bench.output();
  REQUIRE(kinds(said) == Kinds{Body::GoAway, Body::Error, Body::Error});
  CHECK(said[1].code == wire::ErrorCode::overloaded);
  CHECK(said[2].code == wire::ErrorCode::overloaded);
}

TEST_CASE("a leaving session ignores a View") {
  SessionBench bench;
  bench.get_chunk(1, chunk_at(5));
  bench.session.go_away("ending", 1ms);
  bench.say_view(0, 1);
  CHECK_FALSE(bench.session.view_waits());
  CHECK(kinds(bench.output()) == Kinds{Body::GoAway});
}

TEST_CASE("a leaving session answers an Edit as a joined one does") {
  SessionBench bench;
  bench.get_chunk(1, chunk_at(5));
  bench.session.go_away("ending", 1ms);
  bench.edit(9);
  const auto said = bench.output();
  REQUIRE(said.size() == 2);
  CHECK(said[1].code == wire::ErrorCode::forbidden);
  CHECK(said[1].id == 9);
}

TEST_CASE("before Welcome a session that is asked to leave sends an Error instead") {
  SessionBench bench{{.greet = false}};
  bench.session.go_away("ending", 5000ms);
  CHECK(bench.session.state() == State::closed);
  const auto said = bench.output();
  REQUIRE(kinds(said) == Kinds{Body::Error});
  CHECK(said[0].code == wire::ErrorCode::overloaded);
  CHECK(said[0].about == wire::ErrorAbout::connection);
  CHECK(said[0].retry_after_ms == 5000);
}

// ---- a client that sends no more

TEST_CASE("a session whose client sends no more closes at once when nothing is asked") {
  SessionBench bench{{.greet = GENERATE(true, false)}};
  bench.session.input_ended();
  CHECK(bench.session.state() == State::closed);
  CHECK(bench.output().empty());
}

TEST_CASE("a client that sends no more is served its requests and its View, without credit") {
  SessionBench bench{{.greet = false}};
  bench.limits.window_bytes = 1;
  bench.hello();
  (void)bench.output();
  for (std::uint32_t id = 1; id <= 100; ++id) bench.get_chunk(id, chunk_at(500 + static_cast<int>(id)));
  bench.get_heights(101);
  bench.view_number = 9;
  bench.say_view(0, 2);
  bench.session.input_ended();
  CHECK(bench.session.state() == State::finishing);
  bench.apply_view();
  auto said = bench.run_dry();
  CHECK(said.size() == 100 + 25 + 1);
  CHECK(std::count_if(said.begin(), said.end(), [](const SessionFrame& each) { return each.id != 0; }) ==
        100);
  CHECK(bench.session.state() == State::finishing);
  bench.source.answer_heights(bench.source.waiting_heights.begin()->first);
  bench.take_mail();
  CHECK(kinds(bench.output()) == Kinds{Body::Heights});
  CHECK(bench.session.state() == State::closed);
}

TEST_CASE("ViewComplete is the last that a client gets that sends no more") {
  SessionBench bench;
  bench.view_number = 9;
  bench.move_view(0, 0);
  bench.session.input_ended();
  const auto said = bench.run_dry();
  CHECK(kinds(said) == Kinds{Body::Chunk, Body::ViewComplete});
  CHECK(bench.session.state() == State::closed);
}

TEST_CASE("a client that sends no more may be asked to leave") {
  SessionBench bench;
  bench.get_chunk(1, chunk_at(5));
  bench.move_view(0, 1);
  bench.session.input_ended();
  bench.session.go_away("ending", 1ms);
  CHECK(kinds(bench.run_dry()) == Kinds{Body::GoAway, Body::Chunk});
  CHECK(bench.session.state() == State::closed);
}

TEST_CASE("a leaving session drops its View") {
  SessionBench bench;
  bench.get_chunk(1, chunk_at(500));
  bench.move_view(0, 1);
  bench.session.go_away("ending", 1ms);
  CHECK(bench.source.waiting.size() == 1);
}
