// What a program may get wrong: each is a status and one line, and nothing else happens.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <limits>

#include "server_process.h"
#include "test_client.h"

namespace talus::c_api {
namespace {

using namespace testing;
using e2e::ServerProcess;

void check_line(const std::string& line, const std::string& function, const std::string& part) {
  CHECK_THAT(line, Catch::StartsWith(function + ": ") && Catch::Contains(part));
  CHECK(std::count(line.begin(), line.end(), '\n') == 0);
}

void check_wrong(talus_status status, const TestClient& client, const std::string& function,
                 const std::string& part) {
  CHECK(status == TALUS_INVALID_ARGUMENT);
  check_line(client.error(), function, part);
}

// A struct of a program that was compiled with a newer header.
template <typename T>
struct Newer {
  T known = [] {
    T fresh{};
    fresh.size = sizeof(Newer);
    return fresh;
  }();
  std::uint64_t added = 0;
};

}  // namespace

TEST_CASE("libtalus without a client says so") {
  auto event = sized<talus_event>();
  auto options = sized<talus_connect_options>();
  auto view = sized<talus_view>();
  auto world = sized<talus_world>();
  auto material = sized<talus_material>();
  auto stats = sized<talus_stats>();
  std::uint64_t count = 0;
  const std::int64_t column[2] = {};
  const auto check = [](talus_status status, const std::string& function) {
    CHECK(status == TALUS_INVALID_ARGUMENT);
    check_line(talus_last_error(nullptr), function, "NULL");
  };
  check(talus_create(nullptr), "talus_create");
  check(talus_connect(nullptr, &options), "talus_connect");
  check(talus_disconnect(nullptr), "talus_disconnect");
  check(talus_poll(nullptr, &event, 0), "talus_poll");
  check(talus_get_world(nullptr, &world), "talus_get_world");
  check(talus_get_material(nullptr, 0, &material), "talus_get_material");
  check(talus_set_view(nullptr, &view), "talus_set_view");
  check(talus_count_view(nullptr, &view, &count), "talus_count_view");
  check(talus_get_chunk(nullptr, 0, 0, 0, 0, nullptr, nullptr), "talus_get_chunk");
  check(talus_get_heights(nullptr, column, 1, nullptr), "talus_get_heights");
  check(talus_get_places(nullptr, column, 1, nullptr, 0, nullptr), "talus_get_places");
  check(talus_ping(nullptr, nullptr), "talus_ping");
  check(talus_cancel(nullptr, 1), "talus_cancel");
  check(talus_get_stats(nullptr, &stats), "talus_get_stats");
  CHECK(talus_look_name(nullptr, 0) == nullptr);
  CHECK(talus_field_name(nullptr, 0) == nullptr);
  talus_destroy(nullptr);
  talus_chunk_retain(nullptr);
  talus_chunk_release(nullptr);
}

TEST_CASE("talus_connect checks its options") {
  const TestClient client;
  const auto connect = [&](const talus_connect_options& options) {
    return talus_connect(client.get(), &options);
  };
  CHECK(client.error().empty());
  check_wrong(talus_connect(client.get(), nullptr), client, "talus_connect", "options is NULL");
  auto options = sized<talus_connect_options>();
  check_wrong(connect(options), client, "talus_connect", "options.host is empty");
  options.host = "127.0.0.1";
  for (const std::uint32_t size : {0U, 4U, 95U, 4097U, UINT32_MAX}) {
    INFO(size);
    options.size = size;
    check_wrong(connect(options), client, "talus_connect", "wrong size");
  }
  options.size = sizeof options;
  options.port = 65536;
  check_wrong(connect(options), client, "talus_connect", "65535");
  options.port = 1;
  options.flags = 8;
  check_wrong(connect(options), client, "talus_connect", "options.flags is 8");
  options.flags = 0;
  options.generate = 3;
  check_wrong(connect(options), client, "talus_connect", "options.generate is 3");
  options.generate = TALUS_GENERATE_NEVER;
  for (const char* wrong : {"here", "a:1,", ",a:1", "a:1 b:2", "a:65536"}) {
    options.more_servers = wrong;
    check_wrong(connect(options), client, "talus_connect", "options.more_servers is");
  }
}

TEST_CASE("a program built against a newer header runs if it sets none of the newer fields") {
  const TestClient client;
  Newer<talus_connect_options> options;
  options.known.host = "127.0.0.1";
  options.known.port = 1;
  options.added = 1;
  check_wrong(talus_connect(client.get(), &options.known), client, "talus_connect",
              "only a newer library can do, this one is 1.0");
  options.added = 0;
  CHECK(talus_connect(client.get(), &options.known) == TALUS_OK);
  Newer<talus_event> event;
  event.added = 1;
  CHECK(talus_poll(client.get(), &event.known, 10'000) == TALUS_OK);
  CHECK(event.known.type == TALUS_EVENT_CLOSED);
  CHECK(event.known.size == sizeof event);
  CHECK(event.added == 0);
}

TEST_CASE("requests before talus_connect say what comes first") {
  const TestClient client;
  auto event = sized<talus_event>();
  auto world = sized<talus_world>();
  auto view = sized<talus_view>();
  auto stats = sized<talus_stats>();
  const std::int64_t column[2] = {};
  for (const talus_status status :
       {talus_poll(client.get(), &event, -1), talus_get_world(client.get(), &world),
        talus_set_view(client.get(), &view), talus_get_chunk(client.get(), 0, 0, 0, 0, nullptr, nullptr),
        talus_get_heights(client.get(), column, 1, nullptr), talus_ping(client.get(), nullptr),
        talus_get_stats(client.get(), &stats)}) {
    CHECK(status == TALUS_NOT_CONNECTED);
    CHECK_THAT(client.error(), Catch::Contains("talus_connect() "));
  }
  CHECK(talus_look_name(client.get(), 0) == nullptr);
  CHECK(talus_disconnect(client.get()) == TALUS_OK);
}

TEST_CASE("talus_fill_rings needs a view, and its rings grow") {
  CHECK(talus_fill_rings(nullptr, 64) == TALUS_INVALID_ARGUMENT);
  check_line(talus_last_error(nullptr), "talus_fill_rings", "view is NULL");
  auto view = sized<talus_view>();
  view.horizontal_radius = 8;
  view.ring_radius[5] = 9;
  REQUIRE(talus_fill_rings(&view, 256) == TALUS_OK);
  CHECK(std::is_sorted(std::begin(view.ring_radius), std::end(view.ring_radius)));
  CHECK(view.ring_radius[5] == 256);
  REQUIRE(talus_fill_rings(&view, 0) == TALUS_OK);
  CHECK(view.ring_radius[5] == 0);
}

TEST_CASE("a client that has joined checks its arguments") {
  const ServerProcess server;
  TestClient client;
  client.join(server.port());
  auto* const c = client.get();

  SECTION("of structs") {
    auto event = sized<talus_event>();
    event.size = 119;
    check_wrong(talus_poll(c, &event, 0), client, "talus_poll", "event");
    check_wrong(talus_poll(c, nullptr, 0), client, "talus_poll", "event");
    check_wrong(talus_get_world(c, nullptr), client, "talus_get_world", "world");
    check_wrong(talus_get_stats(c, nullptr), client, "talus_get_stats", "stats");
    check_wrong(talus_get_material(c, 0, nullptr), client, "talus_get_material", "material");
    auto material = sized<talus_material>();
    check_wrong(talus_get_material(c, 100'000, &material), client, "talus_get_material", "material 100000");
    CHECK(talus_look_name(c, 100'000) == nullptr);
    CHECK(talus_field_name(c, 100'000) == nullptr);
  }
  SECTION("of a View") {
    auto view = client.view(2, 2);
    check_wrong(talus_set_view(c, nullptr), client, "talus_set_view", "view is NULL");
    check_wrong(talus_count_view(c, &view, nullptr), client, "talus_count_view", "chunks is NULL");
    view.flags = 2;
    check_wrong(talus_set_view(c, &view), client, "talus_set_view", "view.flags is 2");
    view.flags = 0;
    view.direction_y = std::numeric_limits<float>::quiet_NaN();
    check_wrong(talus_set_view(c, &view), client, "talus_set_view", "not finite");
    view.direction_y = 0;
    view.reserved = 1;
    check_wrong(talus_set_view(c, &view), client, "talus_set_view", "reserved");
    view.reserved = 0;
    view.horizontal_radius = 60'000;
    CHECK(talus_set_view(c, &view) == TALUS_OUT_OF_RANGE);
    check_line(client.error(), "talus_set_view", "60000 is more than this server allows");
    view.horizontal_radius = 2;
    view.ring_radius[0] = 2;
    CHECK(talus_set_view(c, &view) == TALUS_OUT_OF_RANGE);
    check_line(client.error(), "talus_set_view", "rings must grow");
  }
  SECTION("of requests") {
    const std::int64_t column[2] = {};
    CHECK(talus_get_chunk(c, 0, 0, 0, 7, nullptr, nullptr) == TALUS_OUT_OF_RANGE);
    CHECK(talus_get_chunk(c, INT32_MAX, 0, 0, 1, nullptr, nullptr) == TALUS_OUT_OF_RANGE);
    check_wrong(talus_get_heights(c, nullptr, 1, nullptr), client, "talus_get_heights", "no columns");
    check_wrong(talus_get_heights(c, column, 0, nullptr), client, "talus_get_heights", "no columns");
    CHECK(talus_get_heights(c, column, SIZE_MAX, nullptr) == TALUS_OUT_OF_RANGE);
    check_line(client.error(), "talus_get_heights", "this server allows 2048");
    check_wrong(talus_get_places(c, column, 1, nullptr, 1, nullptr), client, "talus_get_places", "fields");
    check_wrong(talus_get_places(c, column, 1, nullptr, 17, nullptr), client, "talus_get_places", "17");
    CHECK(talus_cancel(c, 12345) == TALUS_OK);
  }
  SECTION("of a second connection") {
    auto options = sized<talus_connect_options>();
    options.host = "127.0.0.1";
    CHECK(talus_connect(c, &options) == TALUS_ALREADY_CONNECTED);
    check_line(client.error(), "talus_connect", "call talus_disconnect() first");
  }
  SECTION("of talus_decode") {
    REQUIRE(talus_get_chunk(c, 0, 0, 0, 0, nullptr, nullptr) == TALUS_OK);
    const talus_event event = client.await(TALUS_EVENT_CHUNK_ANSWER);
    Voxels voxels(TALUS_CHUNK_VOLUME);
    CHECK(talus_decode(nullptr, voxels.data(), voxels.size()) == TALUS_INVALID_ARGUMENT);
    check_line(talus_last_error(nullptr), "talus_decode", "chunk is NULL");
    CHECK(talus_decode(event.chunk, nullptr, voxels.size()) == TALUS_INVALID_ARGUMENT);
    check_line(talus_last_error(nullptr), "talus_decode", "voxels is NULL");
    CHECK(talus_decode(event.chunk, voxels.data(), voxels.size() - 1) == TALUS_INVALID_ARGUMENT);
    CHECK(talus_decode(event.chunk, voxels.data(), voxels.size() + 1) == TALUS_INVALID_ARGUMENT);
    check_line(talus_last_error(nullptr), "talus_decode", "32768");
  }
}

}  // namespace talus::c_api
