#include <talus/voxel/view_shape.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <string>

#include <rapidcheck.h>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

using namespace talus;

namespace {

using Json = nlohmann::json;

Json vectors() {
  std::ifstream in{TALUS_SOURCE_DIR "/core/voxel/vectors/views.json"};
  return Json::parse(in).at("views");
}

std::int64_t chunk_at(const Json& voxel) {
  return floor_div(std::stoll(voxel.get<std::string>()), kChunkSize);
}

ViewExtent extent_of(const Json& view) {
  const Json& centre = view.at("centre");
  ViewExtent extent{{chunk_at(centre.at(0)), chunk_at(centre.at(1)), chunk_at(centre.at(2))},
                    view.at("horizontal_radius"),
                    view.at("vertical_radius"),
                    {}};
  for (const Json& ring : view.at("rings"))
    extent.rings.push_back({Lod::of(ring.at("lod")), ring.at("radius")});
  if (const auto heights = view.find("horizon"); heights != view.end()) {
    const auto row = [&](const char* name) { return std::stoll(heights->at(name).get<std::string>()); };
    extent.horizon = HeightRange{row("min_y"), row("max_y")};
  }
  return extent;
}

Json json_of(ChunkRange range) {
  return range.size() == 0 ? Json{} : Json::array({range.first, range.last});
}

bool has(const std::vector<LevelBox>& boxes, const Json& chunk) {
  for (const LevelBox& box : boxes) {
    if (box.lod == Lod::of(chunk.at(0))) return box.contains({chunk.at(1), chunk.at(2), chunk.at(3)});
  }
  return false;
}

bool has(const std::vector<LevelBox>& boxes, ChunkKey chunk) {
  return std::any_of(boxes.begin(), boxes.end(),
                     [&](const LevelBox& box) { return box.lod == chunk.lod && box.contains(chunk.coord); });
}

ViewExtent random_extent() {
  const auto row = [] { return *rc::gen::inRange<std::int64_t>(-3000, 3000); };
  ViewExtent view{{*rc::gen::inRange<std::int64_t>(-90, 90), *rc::gen::inRange<std::int64_t>(-90, 90),
                   *rc::gen::inRange<std::int64_t>(-90, 90)},
                  *rc::gen::inRange(0, 7),
                  *rc::gen::inRange(0, 4),
                  {}};
  int radius = view.horizontal_radius;
  for (int level = 1; level <= Lod::kMax; ++level) {
    if (*rc::gen::inRange(0, 3) == 0) continue;
    radius += *rc::gen::inRange(1, 12);
    view.rings.push_back({Lod::of(level), radius});
  }
  const std::int64_t low = row();
  view.horizon = HeightRange{low, low + 1 + std::abs(row())};
  return view;
}

}  // namespace

TEST_CASE("the View shapes of the test vectors") {
  const Json views = vectors();
  REQUIRE(views.size() >= 41);
  for (const Json& view : views) {
    INFO(view.at("name"));
    const ViewExtent extent = extent_of(view);
    const auto boxes = level_boxes(extent);
    const Json& levels = view.at("levels");
    REQUIRE(boxes.size() == levels.size());
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      const LevelBox& box = boxes[i];
      const Json& level = levels[i];
      CHECK(box.lod.value() == level.at("lod").get<int>());
      for (const auto& [name, range] : {std::pair{"x", box.x},
                                        {"y", box.y},
                                        {"z", box.z},
                                        {"inner_x", box.inner_x},
                                        {"inner_z", box.inner_z}}) {
        INFO(name << " of level " << box.lod.value());
        CHECK(json_of(range) == level.at(name));
      }
      CHECK(box.count() == level.at("chunks").get<std::uint64_t>());
    }
    CHECK(count_chunks(boxes) == view.at("chunks").get<std::uint64_t>());
    CHECK(count_chunks(level_boxes(extent, WorldEdge::ignored)) ==
          view.at("chunks_without_edge").get<std::uint64_t>());
    for (const Json& chunk : view.at("inside")) CHECK(has(boxes, chunk));
    for (const Json& chunk : view.at("outside")) CHECK_FALSE(has(boxes, chunk));
  }
}

TEST_CASE("the test vectors show Views that the edge cuts, that have empty inner boxes, and that are empty") {
  int cut = 0;
  int without_inner_box = 0;
  int empty = 0;
  int horizons = 0;
  std::size_t samples = 0;
  for (const Json& view : vectors()) {
    cut += view.at("chunks") != view.at("chunks_without_edge") ? 1 : 0;
    empty += view.at("chunks") == 0 ? 1 : 0;
    horizons += view.contains("horizon") ? 1 : 0;
    for (const Json& level : view.at("levels")) {
      without_inner_box += level.at("lod") != 0 && level.at("inner_x").is_null() ? 1 : 0;
    }
    samples += view.at("inside").size() + view.at("outside").size();
  }
  CHECK(cut >= 4);
  CHECK(without_inner_box >= 1);
  CHECK(empty == 1);
  CHECK(horizons >= 13);
  CHECK(samples >= 500);
}

TEST_CASE("a level has as many columns as it visits, each once") {
  CHECK(rc::check([] {
    ViewExtent view{{*rc::gen::inRange<std::int64_t>(-90, 90), 0, *rc::gen::inRange<std::int64_t>(-90, 90)},
                    *rc::gen::inRange(0, 7),
                    0,
                    {}};
    int radius = view.horizontal_radius;
    for (int level = 1; level <= 4; ++level) {
      radius += *rc::gen::inRange(1, 12);
      view.rings.push_back({Lod::of(level), radius});
    }
    for (const LevelBox& box : level_boxes(view)) {
      std::uint64_t columns = 0;
      box.for_each_column([&](std::int64_t x, std::int64_t z) {
        RC_ASSERT(box.has_column(x, z));
        ++columns;
      });
      RC_ASSERT(columns == box.count());
    }
  }));
}

TEST_CASE("a horizon has every voxel row of the world in every column of its rings") {
  CHECK(rc::check([] {
    const ViewExtent view = random_extent();
    const auto boxes = level_boxes(view);
    for (std::size_t i = 1; i < boxes.size(); ++i) {
      const LevelBox& box = boxes[i];
      const int level = box.lod.value();
      // In voxel rows of the level: the ground of row `low` may come down by one, and air begins at `high`.
      const std::int64_t lowest = (view.horizon->low >> level) - 1;
      const std::int64_t highest = (view.horizon->high - 1) >> level;
      RC_ASSERT(box.y.contains(floor_div(lowest, kChunkSize)));
      RC_ASSERT(box.y.contains(floor_div(highest, kChunkSize)));
      RC_ASSERT(!box.y.contains(floor_div(lowest, kChunkSize) - 1));
      RC_ASSERT(!box.y.contains(floor_div(highest, kChunkSize) + 1));
    }
  }));
}

TEST_CASE("a horizon has a column of land wherever the View without it has one, and no level twice") {
  CHECK(rc::check([] {
    const ViewExtent view = random_extent();
    ViewExtent plain = view;
    plain.horizon.reset();
    const auto boxes = level_boxes(view);
    const auto before = level_boxes(plain);
    RC_ASSERT(boxes.size() == before.size());
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      const LevelBox& box = boxes[i];
      RC_ASSERT(box.x == before[i].x);
      RC_ASSERT(box.z == before[i].z);
      if (i == 0) RC_ASSERT(box.y == before[i].y);
      // The first ring lies under level 0, too; all others leave out what the ring before has in all rows.
      for (std::int64_t z = box.z.first; z <= box.z.last; ++z) {
        for (std::int64_t x = box.x.first; x <= box.x.last; ++x) {
          RC_ASSERT(box.has_column(x, z) == (i == 1 || before[i].has_column(x, z)));
        }
      }
    }
  }));
}

TEST_CASE("every place of the world's heights within the last ring is in some chunk of a horizon's rings") {
  CHECK(rc::check([] {
    const ViewExtent view = random_extent();
    if (view.rings.empty()) return;
    const auto boxes = level_boxes(view);
    const int radius = view.rings.back().radius;
    for (int step = 0; step < 50; ++step) {
      const auto aside = [radius] { return *rc::gen::inRange<std::int64_t>(-radius, radius + 1); };
      const std::int64_t row = *rc::gen::inRange(view.horizon->low, view.horizon->high);
      const glm::i64vec3 base{view.centre.x + aside(), floor_div(row, kChunkSize), view.centre.z + aside()};
      bool held = false;
      for (int level = 1; level <= Lod::kMax; ++level) {
        const auto down = [&](std::int64_t at) { return static_cast<std::int32_t>(at >> level); };
        held = held || has(boxes, {{down(base.x), down(base.y), down(base.z)}, Lod::of(level)});
      }
      RC_ASSERT(held);
    }
  }));
}

TEST_CASE("heights beyond the world, or upside down, do not overflow") {
  constexpr std::int64_t kMin = std::numeric_limits<std::int64_t>::min();
  constexpr std::int64_t kMax = std::numeric_limits<std::int64_t>::max();
  ViewExtent view{{0, 0, 0}, 0, 0, {{Lod::of(1), 1}, {Lod::of(6), 65'535}}, HeightRange{kMin, kMax}};
  for (const LevelBox& box : level_boxes(view)) {
    if (box.lod == Lod{}) continue;
    CHECK(box.y == ChunkRange{-chunk_limit(box.lod), chunk_limit(box.lod) - 1});
  }
  view.horizon = HeightRange{kMax, kMin};
  CHECK(count_chunks(level_boxes(view)) == 1);
}
