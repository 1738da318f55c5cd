#include "stream/view_stream.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <map>
#include <set>

#include <rapidcheck.h>

using namespace talus;
using namespace talus::server;

namespace {

ChunkKey at(int x) {
  return {{x, 0, 0}, Lod{}};
}

}  // namespace

TEST_CASE("chunks come in the wanted order") {
  ViewStream stream;
  CHECK(stream.replace({at(3), at(1), at(2)}).empty());
  CHECK(stream.next() == at(3));
  CHECK(stream.next() == at(1));
  CHECK(stream.next() == at(2));
  CHECK(stream.next() == std::nullopt);
}

TEST_CASE("a chunk that could not be had comes again, in its place") {
  ViewStream stream;
  (void)stream.replace({at(1), at(2), at(3)});
  (void)stream.next();
  (void)stream.next();
  stream.put_back(at(1));
  CHECK(stream.next() == at(1));
  CHECK(stream.next() == at(3));
}

TEST_CASE("what was sent and is still wanted is not sent again") {
  ViewStream stream;
  (void)stream.replace({at(1), at(2)});
  (void)stream.next();
  stream.done(at(1));
  CHECK(stream.replace({at(1), at(2)}).empty());
  CHECK(stream.next() == at(2));
  CHECK(stream.next() == std::nullopt);
}

TEST_CASE("what left and comes back is sent again") {
  ViewStream stream;
  (void)stream.replace({at(1)});
  (void)stream.next();
  stream.done(at(1));
  (void)stream.replace({at(2)});
  (void)stream.replace({at(1)});
  CHECK(stream.next() == at(1));
}

TEST_CASE("a View stream does what sets would do") {
  enum class State { under_way, done };
  CHECK(rc::check([] {
    ViewStream stream;
    std::vector<ChunkKey> wanted;
    std::map<ChunkKey, State> states;
    const auto steps = *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 8));
    for (const int step : steps) {
      if (step == 0) {
        const auto places = *rc::gen::unique<std::vector<int>>(rc::gen::inRange(0, 20));
        std::vector<ChunkKey> next;
        for (const int place : places) next.push_back(at(place));
        const auto dropped = stream.replace(next);
        std::set<ChunkKey> expected;
        for (const auto& [key, state] : std::map{states}) {
          if (std::find(next.begin(), next.end(), key) != next.end()) continue;
          if (state == State::under_way) expected.insert(key);
          states.erase(key);
        }
        RC_ASSERT(std::set(dropped.begin(), dropped.end()) == expected);
        wanted = next;
      } else if (step < 5) {
        const auto due =
            std::find_if(wanted.begin(), wanted.end(), [&](ChunkKey key) { return !states.contains(key); });
        const auto got = stream.next();
        RC_ASSERT(got.has_value() == (due != wanted.end()));
        if (got) RC_ASSERT(*got == *due);
        if (got) states[*got] = State::under_way;
      } else {
        const auto open = std::find_if(states.begin(), states.end(),
                                       [](const auto& each) { return each.second == State::under_way; });
        if (open == states.end()) continue;
        stream.done(open->first);
        open->second = State::done;
      }
      RC_ASSERT(stream.under_way_count() ==
                static_cast<std::size_t>(std::count_if(states.begin(), states.end(), [](const auto& each) {
                  return each.second == State::under_way;
                })));
    }
  }));
}
