#include <catch2/catch.hpp>

#include "web/forwarded_for.h"
#include "web/routes.h"

using namespace talus;
using namespace talus::server;
using namespace talus::server::web;

namespace {

tl::expected<Route, RouteError> route_of(std::string_view path, std::optional<std::string_view> query = {}) {
  return find_route(path, query, 100);
}

using Places = std::vector<std::pair<std::int64_t, std::int64_t>>;
Places places(const HeightsRoute& route) {
  Places all;
  for (const terrain::BaseColumn& column : route.columns) all.emplace_back(column.x, column.z);
  return all;
}

}  // namespace

TEST_CASE("a chunk has one path") {
  const auto route = route_of("/v1/abc/4/2/-12/4/7");
  REQUIRE(route);
  const auto& chunk = std::get<ChunkRoute>(*route);
  CHECK(chunk.key == ChunkKey{{-12, 4, 7}, Lod::of(2)});
  CHECK(chunk.fingerprint == "abc");
  CHECK(chunk.codec == "4");
  for (const auto* path :
       {"/v1/abc/4/2/-12/4/07", "/v1/abc/4/2/-12/4/-0", "/v1/abc/4/2/-12/4/+7", "/v1/abc/4/2/-12/4/7/",
        "/v1/abc/4/2/-12/4/ 7", "/v1/abc/4/2/-12//7", "/v1/abc/4/7/0/0/0", "/v1/abc/4/-1/0/0/0",
        "/v1/abc/4/0/0/0/2147483648", "/v1/abc/4/6/33554432/0/0", "/v1/abc/4/0/0/0/99999999999999999999",
        "/v1/abc/4/0", "/v1/", "/v1/abc"}) {
    INFO(path);
    const auto wrong = route_of(path);
    REQUIRE_FALSE(wrong);
    CHECK(wrong.error().status == 404);
    CHECK_FALSE(wrong.error().text.empty());
  }
  CHECK(route_of("/v1/abc/4/0/0/0/0", "nocache=1").error().status == 400);
  CHECK(route_of("/v1/abc/4/6/33554431/-33554432/0"));
}

TEST_CASE("a column and squares of columns") {
  CHECK(std::get<ColumnsRoute>(*route_of("/v1/abc/4/2/-12/7")).edge == 1);
  const auto square = std::get<ColumnsRoute>(*route_of("/v1/abc/4/2/-12/8/4x4"));
  CHECK(square.edge == 4);
  CHECK(square.square);
  CHECK(square.corner == ChunkKey{{-12, 0, 8}, Lod::of(2)});
  CHECK(std::get<ColumnsRoute>(*route_of("/v1/abc/4/2/-11/7/1x1")).square);
  for (const auto* path :
       {"/v1/abc/4/2/-11/8/4x4", "/v1/abc/4/2/-12/8/3x3", "/v1/abc/4/2/-12/8/8x8", "/v1/abc/4/2/-12/8/4x2"}) {
    CHECK(route_of(path).error().status == 404);
  }
}

TEST_CASE("a published world has its spec and its files by their names, percent-encoded") {
  const auto file = [](std::string_view path) { return std::get<FileRoute>(*route_of(path)); };
  CHECK(file("/v1/abc/world.toml").name.empty());
  CHECK(file("/v1/abc/world.toml").fingerprint == "abc");
  CHECK(file("/v1/abc/files/a%20b+c.vox").name == "a b+c.vox");
  CHECK(file("/v1/abc/files/1/2/3/4/5/6/7/8/9/rock.vox").name == "1/2/3/4/5/6/7/8/9/rock.vox");
  CHECK(file("/v1/abc/files/edits/").name == "edits/");
  for (const auto* path : {"/v1/abc/files", "/v1/abc/files/", "/v1/abc/files/%", "/v1/abc/files/%4",
                           "/v1/abc/files/%4g", "/v1/abc/world.toml/", "/v1/world.toml"}) {
    INFO(path);
    CHECK(route_of(path).error().status == 404);
  }
  CHECK(route_of("/v1/abc/world.toml", "").error().status == 404);
  CHECK(route_of("/v1/abc/files/a", "x=1").error().status == 400);
}

TEST_CASE("a path of a store without a revision gets an error that asks for it") {
  for (const auto* path : {"/v1/abc/def/4/2/-12/4/7", "/v1/abc/def/4/2/-12/8/4x4"}) {
    const auto wrong = route_of(path);
    REQUIRE_FALSE(wrong);
    CHECK(wrong.error().status == 404);
    CHECK(wrong.error().text.find("@{revision} is missing") == 0);
  }
}

TEST_CASE("a path with edits has the store after the fingerprint, and a revision") {
  const auto chunk = std::get<ChunkRoute>(*route_of("/v1/abc/def/4/2/-12/4/7@31"));
  CHECK(chunk.fingerprint == "abc");
  CHECK(chunk.codec == "4");
  CHECK(chunk.key == ChunkKey{{-12, 4, 7}, Lod::of(2)});
  REQUIRE(chunk.edition);
  CHECK(chunk.edition->store == "def");
  CHECK(chunk.edition->revision == 31);
  CHECK(last_part_of(chunk, 32) == "7@32");
  const auto column = std::get<ColumnsRoute>(*route_of("/v1/abc/def/4/2/-12/7@0"));
  CHECK(column.edition->revision == 0);
  CHECK_FALSE(column.square);
  CHECK(last_part_of(column, 1) == "7@1");
  const auto square = std::get<ColumnsRoute>(*route_of("/v1/abc/def/4/2/-12/8/4x4@9223372036854775807"));
  CHECK(square.edge == 4);
  CHECK(square.edition->revision == 9223372036854775807U);
  CHECK(last_part_of(square, 1) == "4x4@1");
  CHECK_FALSE(std::get<ChunkRoute>(*route_of("/v1/abc/4/0/1/2/3")).edition);
  for (const auto* path :
       {"/v1/abc/4/2/-12/4/7@31", "/v1/abc/def/4/2/-12/4/7", "/v1/abc/def/4/2/-12/4/7@",
        "/v1/abc/def/4/2/-12/4/7@-1", "/v1/abc/def/4/2/-12/4/7@07", "/v1/abc/def/4/2/-12/4/7@7@7",
        "/v1/abc/def/4/2/-12@3/4/7", "/v1/abc/def/4/2/-12/4/7@9223372036854775808",
        "/v1/abc/def/4/2/-12/8@7/4x4", "/v1/@1", "/v1/abc/@1", "/v1/abc/def/4/2/-12/4/7/4x4@1"}) {
    INFO(path);
    const auto wrong = route_of(path);
    REQUIRE_FALSE(wrong);
    CHECK(wrong.error().status == 404);
  }
  CHECK(route_of("/v1/abc/def/4/0/0/0/0@1", "nocache=1").error().status == 400);
}

TEST_CASE("a region's edited columns have one path") {
  const auto route = std::get<EditsRoute>(*route_of("/v1/abc/def/edits/2/-3/4"));
  CHECK(route.fingerprint == "abc");
  CHECK(route.store == "def");
  CHECK(route.region == ChunkKey{{-96, 0, 128}, Lod::of(2)});
  CHECK(route_of("/v1/abc/def/edits/0/-67108864/67108863"));
  for (const auto* path : {"/v1/abc/def/edits/2/-3", "/v1/abc/def/edits/2/-3/4/5", "/v1/abc/def/edits/7/0/0",
                           "/v1/abc/def/edits/0/-0/0", "/v1/abc/def/edits/0/67108864/0",
                           "/v1/abc/def/edits/0/0/-67108865", "/v1/abc/def/edits/6/1048576/0",
                           "/v1/abc/def/edits/0/9223372036854775807/0", "/v1/abc/def/edits/0/0/0@1"}) {
    INFO(path);
    const auto wrong = route_of(path);
    REQUIRE_FALSE(wrong);
    CHECK(wrong.error().status == 404);
  }
}

TEST_CASE("heights of a list and of a grid") {
  const auto list = std::get<HeightsRoute>(*route_of("/v1/heights", "columns=1,-2;3,4&looks=1&fields=a,b"));
  CHECK(places(list) == Places{{1, -2}, {3, 4}});
  CHECK(list.looks);
  CHECK(list.fields == std::vector<std::string>{"a", "b"});
  const auto grid = std::get<HeightsRoute>(*route_of("/v1/heights", "x=-4&z=8&w=2&h=2&step=16"));
  CHECK(places(grid) == Places{{-4, 8}, {12, 8}, {-4, 24}, {12, 24}});
  CHECK(grid.width == 2);
  for (const auto* query :
       {"", "columns=", "columns=1", "columns=1,2;", "columns=1,2&x=3", "x=1&z=2&w=0&h=1",
        "x=1&z=2&w=101&h=1", "x=1&z=2&w=11&h=11", "x=1&z=2&w=1&h=1&step=0", "columns=1,2&looks=yes",
        "columns=1,2&format=csv", "columns=1,2&format=npy&looks=1", "columns=1,2&colums=3,4",
        "columns=1,2&columns=3,4"}) {
    INFO(query);
    const auto wrong = route_of("/v1/heights", query);
    REQUIRE_FALSE(wrong);
    CHECK(wrong.error().status == 400);
  }
}

TEST_CASE("keys and values of a query are percent-decoded") {
  const auto fields_of = [](std::string_view query) {
    const auto route = route_of("/v1/heights", query);
    REQUIRE(route);
    return std::get<HeightsRoute>(*route).fields;
  };
  using Names = std::vector<std::string>;
  CHECK(places(std::get<HeightsRoute>(*route_of("/v1/heights", "columns=0%2C0%3B1%2C-2"))) ==
        Places{{0, 0}, {1, -2}});
  CHECK(std::get<HeightsRoute>(*route_of("/v1/heights", "%78=1&z=2&w=%31&h=1")).width == 1);
  CHECK(fields_of("columns=1,2&fields=red%20rock,H%C3%B6he") == Names{"red rock", "H\xc3\xb6he"});
  CHECK(fields_of("columns=1,2&fields=red+rock") == Names{"red rock"});
  CHECK(fields_of("columns=1,2&fields=a%2Bb,a%26b%3D") == Names{"a+b", "a&b="});
  CHECK(fields_of("columns=1,2&fields=a%2Cb,c") == Names{"a,b", "c"});  // one name or two: the world decides
  for (const auto* query : {"columns=1,2&fields=%", "columns=1,2&fields=a%2", "columns=1,2&fields=%zz",
                            "columns=1,2&fields=%-1", "columns=1,2&%=", "columns=1,2%26looks=1"}) {
    INFO(query);
    CHECK(route_of("/v1/heights", query).error().status == 400);
  }
  // Paths are not decoded: each chunk has a single one.
  for (const auto* path : {"/v1/abc/4/0/%30/0/0", "/v1/abc/4/0/0/0/%2D1", "/v1/heights%3F"}) {
    INFO(path);
    CHECK(route_of(path).error().status == 404);
  }
}

TEST_CASE("an empty query is not a second path of a chunk") {
  for (const auto* path : {"/v1/abc/4/0/0/0/0", "/v1/abc/4/0/0/0", "/v1/abc/4/0/0/0/2x2",
                           "/v1/abc/def/4/0/0/0/0@1", "/v1/abc/def/edits/0/0/0", "/v1/abc/map/8/0/0.png"}) {
    INFO(path);
    CHECK(route_of(path));
    CHECK(route_of(path, "").error().status == 404);
  }
  CHECK(route_of("/v1/world", ""));
  CHECK(route_of("/v1/stream", ""));
}

TEST_CASE("the client behind proxies is the rightmost address that is not a proxy") {
  const Networks proxies = *Networks::parse("10.0.0.0/8, 2001:db8::7");
  const auto client = [&](std::string_view list) {
    const auto address = forwarded_for(list, proxies);
    return address ? address->to_string() : std::string{"none"};
  };
  CHECK(client("192.0.2.1") == "192.0.2.1");
  CHECK(client("203.0.113.9, 192.0.2.1, 10.1.2.3") == "192.0.2.1");
  CHECK(client("192.0.2.1:4711,2001:db8::7") == "192.0.2.1");
  CHECK(client("[2001:db8::1]:80") == "2001:db8::1");
  CHECK(client(" 2001:db8::1 ") == "2001:db8::1");
  CHECK(client("192.0.2.1, unknown, 10.1.2.3") == "none");
  CHECK(client("10.1.2.3") == "none");
  CHECK(client("") == "none");
  CHECK(client(",") == "none");
}

TEST_CASE("a tile of the map has one path") {
  const auto route = route_of("/v1/abc/map/8/-12/7.png");
  REQUIRE(route);
  const auto& map = std::get<MapRoute>(*route);
  CHECK(map.fingerprint == "abc");
  CHECK(map.tile == talus::map::Tile{8, -12, 7});
  for (const auto* path : {"/v1/abc/map/8/-12/7", "/v1/abc/map/8/-12/7.jpg", "/v1/abc/map/13/0/0.png",
                           "/v1/abc/map/-1/0/0.png", "/v1/abc/map/0/65536/0.png", "/v1/abc/map/08/0/0.png",
                           "/v1/abc/map/8/0/.png", "/v1/abc/map/8/0/0.png/", "/v1/abc/map/8/0.png",
                           "/v1/abc/map/8/0/0/0.png", "/v1/abc/map", "/v1/abc/map/8/0/-0.png"}) {
    INFO(path);
    const auto wrong = route_of(path);
    REQUIRE_FALSE(wrong);
    CHECK(wrong.error().status == 404);
  }
  CHECK(route_of("/v1/abc/map/0/-65536/65535.png"));
  CHECK(route_of("/v1/abc/map/8/0/0.png", "t=1").error().status == 400);
}
