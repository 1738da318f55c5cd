#include "player/view/view_stream.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <map>
#include <set>

#include <rapidcheck.h>

#include "views.h"

using namespace talus;
using namespace talus::server;

namespace {

AreaOfInterest only(int x) {
  return AreaOfInterest{View{{x, 0, 0}, {}, 0, 0, {}}};
}

ChunkKey at(int x) {
  return {{x, 0, 0}, Lod{}};
}

/// The nearest chunk, in flight from here on.
std::optional<ChunkKey> next(ViewStream& stream) {
  const auto nearest = stream.nearest();
  if (nearest) stream.start(*nearest);
  return nearest;
}

/// Few chunks, in boxes, holes and levels that overlap from one View to the next.
View small_view() {
  const auto coordinate = [] { return *rc::gen::inRange<std::int64_t>(-4, 5); };
  View view{{coordinate(), coordinate() / 4, coordinate()}, {1, 0, 0}, *rc::gen::inRange(0, 3), 0, {}};
  view.vertical_radius = *rc::gen::inRange(0, 2);
  int radius = view.horizontal_radius;
  for (int level = 1; level <= 2; ++level) {
    if (*rc::gen::inRange(0, 2) == 0) continue;
    radius += *rc::gen::inRange(1, 5);
    view.rings.push_back({Lod::of(level), radius});
  }
  if (*rc::gen::inRange(0, 2) == 0) view.horizon = HeightRange{-40, *rc::gen::inRange<std::int64_t>(1, 200)};
  return view;
}

}  // namespace

TEST_CASE("a chunk that could not be had comes again, in its place") {
  ViewStream stream;
  stream.replace(AreaOfInterest{View{{0, 0, 0}, {}, 1, 0, {}}});
  const ChunkKey first = *next(stream);
  const ChunkKey second = *next(stream);
  stream.put_back(first);
  CHECK(next(stream) == first);
  CHECK(next(stream) != second);
}

TEST_CASE("a sent chunk that is still wanted is not sent again") {
  ViewStream stream;
  stream.replace(only(1));
  stream.done(*next(stream));
  stream.replace(only(1));
  CHECK(next(stream) == std::nullopt);
}

TEST_CASE("a chunk that left and returns is sent again") {
  ViewStream stream;
  stream.replace(only(1));
  stream.done(*next(stream));
  stream.replace(only(2));
  stream.replace(only(1));
  CHECK(next(stream) == at(1));
}

TEST_CASE("without a View nothing is wanted") {
  ViewStream stream;
  stream.replace(only(1));
  (void)next(stream);
  stream.replace({});
  CHECK_FALSE(stream.in_flight(at(1)));
  CHECK(next(stream) == std::nullopt);
}

TEST_CASE("a small View after a large one holds little memory") {
  ViewStream stream;
  stream.replace(AreaOfInterest{View{{0, 0, 0}, {}, 40, 10, {}}});
  CHECK(stream.bytes() > 100'000);
  stream.replace(only(1));
  CHECK(stream.bytes() < 1000);
}

TEST_CASE("a View stream does what sets would do") {
  enum class State { in_flight, done };
  CHECK(rc::check([] {
    ViewStream stream;
    std::vector<ChunkKey> wanted;
    std::map<ChunkKey, State> states;
    const auto steps = *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 12));
    for (const int step : steps) {
      const auto open = std::find_if(states.begin(), states.end(),
                                     [](const auto& each) { return each.second == State::in_flight; });
      if (step == 0) {
        const View view = small_view();
        wanted = chunks_in_view(view);
        stream.replace(AreaOfInterest{view});
        for (const auto& [key, state] : std::map{states}) {
          if (std::find(wanted.begin(), wanted.end(), key) != wanted.end()) continue;
          RC_ASSERT_FALSE(stream.in_flight(key));
          states.erase(key);
        }
      } else if (step < 8) {
        const auto due =
            std::find_if(wanted.begin(), wanted.end(), [&](ChunkKey key) { return !states.contains(key); });
        const auto got = next(stream);
        RC_ASSERT(got.has_value() == (due != wanted.end()));
        if (got) RC_ASSERT(*got == *due);
        if (got) states[*got] = State::in_flight;
      } else if (open != states.end() && step < 11) {
        stream.done(open->first);
        open->second = State::done;
      } else if (open != states.end()) {
        stream.put_back(open->first);
        states.erase(open);
      }
      RC_ASSERT(stream.in_flight_count() ==
                static_cast<std::size_t>(std::count_if(states.begin(), states.end(), [](const auto& each) {
                  return each.second == State::in_flight;
                })));
    }
  }));
}
