#include "player/view/area_of_interest.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include <rapidcheck.h>

#include "views.h"

using namespace talus;
using namespace talus::server;

namespace {

View random_view() {
  View view;
  view.centre = {*rc::gen::inRange<std::int64_t>(-40, 40), *rc::gen::inRange<std::int64_t>(-40, 40),
                 *rc::gen::inRange<std::int64_t>(-40, 40)};
  view.direction = {static_cast<float>(*rc::gen::inRange(-3, 4)), 0.0F,
                    static_cast<float>(*rc::gen::inRange(-3, 4))};
  view.horizontal_radius = *rc::gen::inRange(0, 6);
  view.vertical_radius = *rc::gen::inRange(0, 4);
  int radius = view.horizontal_radius;
  for (int level = 1; level <= 3; ++level) {
    if (*rc::gen::inRange(0, 3) == 0) continue;
    radius += *rc::gen::inRange(1, 8);
    view.rings.push_back({Lod::of(level), radius});
  }
  return view;
}

/// Perhaps with a horizon, of heights near and far.
View random_view_or_horizon() {
  View view = random_view();
  if (*rc::gen::inRange(0, 3) == 0) return view;
  const std::int64_t low = *rc::gen::inRange<std::int64_t>(-2000, 2000);
  view.horizon = HeightRange{low, low + *rc::gen::inRange<std::int64_t>(1, 3000)};
  return view;
}

/// From the centre of the view's chunk to that of another, in base chunks; exact.
glm::dvec3 way_to(const View& view, ChunkKey key) {
  const double size = std::exp2(key.lod.value());
  const auto along = [&](std::int32_t at, std::int64_t centre) {
    return (at + 0.5) * size - (static_cast<double>(centre) + 0.5);
  };
  return {along(key.coord.x, view.centre.x), along(key.coord.y, view.centre.y),
          along(key.coord.z, view.centre.z)};
}

double ring_of(const View& view, ChunkKey key) {
  return std::floor(glm::length(way_to(view, key)));
}

/// The chunk of `lod` in which a base chunk lies.
ChunkKey holding(glm::i64vec3 base, Lod lod) {
  const auto down = [&](std::int64_t at) { return static_cast<std::int32_t>(at >> lod.value()); };
  return {{down(base.x), down(base.y), down(base.z)}, lod};
}

/// Whether every base column of the chunk lies in a finer chunk of the set, at the view's own height.
bool covered_by_finer(const View& view, const std::set<ChunkKey>& wanted, ChunkKey key) {
  const std::int64_t size = std::int64_t{1} << key.lod.value();
  for (std::int64_t z = 0; z < size; ++z) {
    for (std::int64_t x = 0; x < size; ++x) {
      const glm::i64vec3 base{key.coord.x * size + x, view.centre.y, key.coord.z * size + z};
      bool held = false;
      for (int level = 0; level < key.lod.value(); ++level) {
        held = held || wanted.contains(holding(base, Lod::of(level)));
      }
      if (!held) return false;
    }
  }
  return true;
}

}  // namespace

TEST_CASE("a View's chunks come by distance, each once") {
  CHECK(rc::check([] {
    const View view = random_view_or_horizon();
    const auto keys = chunks_in_view(view);
    RC_ASSERT(std::set(keys.begin(), keys.end()).size() == keys.size());
    RC_ASSERT(std::is_sorted(keys.begin(), keys.end(),
                             [&](ChunkKey a, ChunkKey b) { return ring_of(view, a) < ring_of(view, b); }));
  }));
}

TEST_CASE("a large View, too, comes ring by ring, and each ring from ahead to behind") {
  const View view{{5, -3, 70}, {3, 1, -2}, 25, 6, {{Lod::of(1), 60}, {Lod::of(3), 200}}};
  const auto keys = chunks_in_view(view);
  CHECK(keys.size() == count_chunks(view));
  const auto ahead = [&](ChunkKey key) {
    const glm::dvec3 way = way_to(view, key);
    return glm::length(way) > 0 ? glm::dot(glm::normalize(way), glm::normalize(glm::dvec3{view.direction}))
                                : 1;
  };
  constexpr double kAngleStep = 1.0 / 16'384;
  CHECK(std::is_sorted(keys.begin(), keys.end(), [&](ChunkKey a, ChunkKey b) {
    const double ring_a = ring_of(view, a);
    const double ring_b = ring_of(view, b);
    return ring_a < ring_b || (ring_a == ring_b && ahead(a) > ahead(b) + kAngleStep);
  }));
}

TEST_CASE("at one distance what lies ahead comes first") {
  const View view{{0, 0, 0}, {1, 0, 0}, 4, 0, {}};
  const auto keys = chunks_in_view(view);
  const auto place = [&](ChunkCoord coord) {
    return std::find(keys.begin(), keys.end(), ChunkKey{coord, {}});
  };
  CHECK(place({3, 0, 0}) < place({0, 0, 3}));
  CHECK(place({0, 0, 3}) < place({-3, 0, 0}));
}

TEST_CASE("the chunks are as many as counted before") {
  CHECK(rc::check([] {
    const View view = random_view_or_horizon();
    RC_ASSERT(chunks_in_view(view).size() == count_chunks(view));
  }));
}

TEST_CASE("level 0 is exactly the box") {
  CHECK(rc::check([] {
    View view = random_view();
    view.rings.clear();
    const auto keys = chunks_in_view(view);
    for (const ChunkKey key : keys) {
      const glm::i64vec3 offset = to_vec(key.coord) - view.centre;
      RC_ASSERT(std::max(std::abs(offset.x), std::abs(offset.z)) <= view.horizontal_radius);
      RC_ASSERT(std::abs(offset.y) <= view.vertical_radius);
    }
    const auto side = static_cast<std::size_t>(2 * view.horizontal_radius + 1);
    RC_ASSERT(keys.size() == side * side * static_cast<std::size_t>(2 * view.vertical_radius + 1));
  }));
}

TEST_CASE("everything out to the last ring is covered") {
  CHECK(rc::check([] {
    const View view = random_view();
    const auto keys = chunks_in_view(view);
    const std::set<ChunkKey> wanted(keys.begin(), keys.end());
    const int radius = view.rings.empty() ? view.horizontal_radius : view.rings.back().radius;
    for (int step = 0; step < 50; ++step) {
      const auto offset = [](int most) { return *rc::gen::inRange<std::int64_t>(-most, most + 1); };
      const glm::i64vec3 base =
          view.centre + glm::i64vec3{offset(radius), offset(view.vertical_radius), offset(radius)};
      bool held = false;
      for (int level = 0; level <= Lod::kMax; ++level) {
        held = held || wanted.contains(holding(base, Lod::of(level)));
      }
      RC_ASSERT(held);
    }
  }));
}

TEST_CASE("no coarse chunk is in a View if finer ones cover it completely") {
  CHECK(rc::check([] {
    const View view = random_view();
    const auto keys = chunks_in_view(view);
    const std::set<ChunkKey> wanted(keys.begin(), keys.end());
    for (const ChunkKey key : keys) {
      if (key.lod != Lod{}) RC_ASSERT(!covered_by_finer(view, wanted, key));
    }
  }));
}

TEST_CASE("the world's end cuts a View off") {
  const std::int64_t limit = chunk_limit(Lod{});
  CHECK(chunks_in_view({{limit - 1, 0, 0}, {}, 1, 0, {}}).size() == 2 * 3);
  CHECK(chunks_in_view({{-limit - 1, 0, 0}, {}, 1, 0, {}}).size() == 1 * 3);
}

TEST_CASE("a View far outside the world is empty, not undefined") {
  const std::int64_t farthest = floor_div(std::numeric_limits<std::int64_t>::max(), kChunkSize);
  CHECK(chunks_in_view({{farthest, -farthest, farthest}, {}, 3, 3, {{Lod::of(6), 100}}}).empty());
}

TEST_CASE("an invalid direction is no preference") {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinite = std::numeric_limits<float>::infinity();
  const View plain{{0, 0, 0}, {}, 2, 1, {}};
  View odd = plain;
  odd.direction = {nan, infinite, 1};
  CHECK(chunks_in_view(odd) == chunks_in_view(plain));
}

TEST_CASE("next_column gives every column once, level by level, the nearest squares first") {
  CHECK(rc::check([] {
    View view = random_view_or_horizon();
    // At the end of the world too, where squares are cut off.
    if (*rc::gen::inRange(0, 3) == 0) view.centre.x += chunk_limit(Lod{});
    const AreaOfInterest area{view};
    std::set<ChunkKey> left;
    area.for_each([&](ChunkKey key, AreaOfInterest::Place) {
      left.insert({{key.coord.x, static_cast<std::int32_t>(area.rows_of(key).first), key.coord.z}, key.lod});
    });
    AreaOfInterest::ColumnCursor cursor;
    std::pair<int, std::int64_t> before{0, 0};
    while (const auto column = area.next_column(cursor)) {
      RC_ASSERT(left.erase(*column) == 1);
      const int level = column->lod.value();
      const std::int64_t square = std::max(std::abs(column->coord.x - (view.centre.x >> level)),
                                           std::abs(column->coord.z - (view.centre.z >> level)));
      RC_ASSERT((before <= std::pair{level, square}));
      before = {level, square};
    }
    RC_ASSERT(left.empty());
  }));
}

TEST_CASE("each chunk has a place of its own, and places are at most twice as many") {
  CHECK(rc::check([] {
    const AreaOfInterest area{random_view_or_horizon()};
    std::set<AreaOfInterest::Place> places;
    area.for_each([&](ChunkKey key, AreaOfInterest::Place place) {
      RC_ASSERT(places.insert(place).second);
      RC_ASSERT(area.place_of(key) == place);
      RC_ASSERT((area.ranked(area.rank(key, place)) == std::pair{key, place}));
      RC_ASSERT((area.ranked(area.coarse_priority(key, place)) == std::pair{key, place}));
    });
    RC_ASSERT(area.places() <= 2 * places.size());
  }));
}

TEST_CASE("for_each_shared visits what all Views have, each chunk once, as place by place would") {
  CHECK(rc::check([] {
    const AreaOfInterest mine{random_view_or_horizon()};
    const AreaOfInterest theirs{random_view_or_horizon()};
    std::vector<AreaOfInterest> between;
    for (int more = *rc::gen::inRange(0, 3); more > 0; --more) between.emplace_back(random_view_or_horizon());
    std::map<AreaOfInterest::Place, AreaOfInterest::Place> shared;
    mine.for_each_shared(theirs, between, [&](std::size_t place, std::size_t other, std::size_t count) {
      for (std::size_t i = 0; i < count; ++i) {
        const auto narrow = [i](std::size_t at) { return static_cast<AreaOfInterest::Place>(at + i); };
        RC_ASSERT(shared.emplace(narrow(place), narrow(other)).second);
      }
    });
    std::map<AreaOfInterest::Place, AreaOfInterest::Place> expected;
    mine.for_each([&](ChunkKey key, AreaOfInterest::Place place) {
      const auto other = theirs.place_of(key);
      const bool in_all = std::all_of(between.begin(), between.end(), [&](const AreaOfInterest& each) {
        return each.place_of(key).has_value();
      });
      if (other && in_all) expected.emplace(place, *other);
    });
    RC_ASSERT(shared == expected);
  }));
}

TEST_CASE("a horizon's chunks come by distance from wherever the player is") {
  const std::int64_t high =
      GENERATE(std::int64_t{30}, std::int64_t{20'000}, std::int64_t{1} << 40, -(std::int64_t{1} << 58));
  const View view{{3, high, 3}, {}, 2, 1, {{Lod::of(1), 9}, {Lod::of(6), 200}}, 0, HeightRange{0, 500}};
  const auto keys = chunks_in_view(view);
  CHECK(std::set(keys.begin(), keys.end()).size() == keys.size());
  const auto in_rings =
      std::count_if(keys.begin(), keys.end(), [](ChunkKey key) { return key.lod != Lod{}; });
  CHECK(in_rings == 10 * 10 * 9 + 8 * 8 * 2);
  const bool exact = std::abs(high) < 30'000;
  CHECK(std::is_sorted(keys.begin(), keys.end(), [&](ChunkKey a, ChunkKey b) {
    if (exact) return ring_of(view, a) < ring_of(view, b);
    // From as far as 2^15 chunks, within what the 256th part of a chunk leaves open.
    const auto aside = [&](ChunkKey key) {
      const glm::dvec3 way = way_to(view, key);
      return way.x * way.x + way.z * way.z;
    };
    return aside(a) + 600 < aside(b);
  }));
}
