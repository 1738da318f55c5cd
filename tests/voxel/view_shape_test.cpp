#include <talus/voxel/view_shape.h>

#include <fstream>
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

}  // namespace

TEST_CASE("the View shapes of the test vectors") {
  const Json views = vectors();
  REQUIRE(views.size() >= 28);
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
  std::size_t samples = 0;
  for (const Json& view : vectors()) {
    cut += view.at("chunks") != view.at("chunks_without_edge") ? 1 : 0;
    empty += view.at("chunks") == 0 ? 1 : 0;
    for (const Json& level : view.at("levels")) {
      without_inner_box += level.at("lod") != 0 && level.at("inner_x").is_null() ? 1 : 0;
    }
    samples += view.at("inside").size() + view.at("outside").size();
  }
  CHECK(cut >= 4);
  CHECK(without_inner_box >= 1);
  CHECK(empty == 1);
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
