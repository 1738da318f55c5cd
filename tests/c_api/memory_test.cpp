// Memory that runs out becomes a status.
#include <catch2/catch.hpp>

#include "failing_allocations.h"
#include "server_process.h"
#include "test_client.h"

namespace talus::c_api {
namespace {

using namespace testing;

// Where less than this fails, inside an Asio coroutine that begins to wait, Asio ends the process.
constexpr std::size_t kFromBytes = 512;

// Joins, has a View and an answer; the first status that is an error.
talus_status visit(talus_client* client, std::uint16_t port) {
  auto options = sized<talus_connect_options>();
  options.host = "127.0.0.1";
  options.port = port;
  talus_status status = talus_connect(client, &options);
  auto event = sized<talus_event>();
  auto world = sized<talus_world>();
  auto view = sized<talus_view>();
  view.horizontal_radius = 1;
  view.vertical_radius = 1;
  const std::int64_t column[2] = {};
  bool complete = false;
  bool answered = false;
  bool fetched = false;
  while (status >= 0 && !(complete && answered && fetched)) {
    status = talus_poll(client, &event, 10'000);
    if (status != TALUS_OK) return status == TALUS_NO_EVENT ? TALUS_TIMED_OUT : status;
    if (event.type == TALUS_EVENT_JOINED) {
      status = talus_get_world(client, &world);
      view.centre_y = world.spawn_y;
      if (status == TALUS_OK) status = talus_set_view(client, &view);
      if (status == TALUS_OK) status = talus_get_heights(client, column, 1, nullptr);
      if (status == TALUS_OK) status = talus_get_chunk(client, 0, 0, 0, 0, nullptr, nullptr);
    } else if (event.type == TALUS_EVENT_VIEW_COMPLETE) {
      complete = true;
    } else if (event.type == TALUS_EVENT_HEIGHTS) {
      answered = true;
    } else if (event.type == TALUS_EVENT_CHUNK_ANSWER) {
      fetched = true;
    } else if (event.type == TALUS_EVENT_CLOSED) {
      return event.status;
    }
  }
  return status;
}

}  // namespace

TEST_CASE("an allocation that fails ends a talus_client's connection by a status, and it may connect again") {
  const e2e::ServerProcess server;
  TestClient client;
  bool failed = true;
  int visits = 0;
  for (std::size_t allocations = 0; failed; ++allocations) {
    talus_status status = TALUS_OK;
    {
      const test::FailingAllocations failing{allocations, kFromBytes};
      status = visit(client.get(), server.port());
      failed = failing.has_failed();
    }
    INFO("the allocation after " << allocations << ": " << talus_status_name(status) << ", "
                                 << client.error());
    REQUIRE(status == (failed ? TALUS_OUT_OF_MEMORY : TALUS_OK));
    REQUIRE(talus_disconnect(client.get()) == TALUS_OK);
    ++visits;
  }
  CHECK(visits > 10);
  CHECK(visit(client.get(), server.port()) == TALUS_OK);
}

TEST_CASE("talus_create without memory says so") {
  talus_client* client = nullptr;
  talus_status status = TALUS_OK;
  {
    const test::FailingAllocations failing{0};
    status = talus_create(&client);
  }
  CHECK(status == TALUS_OUT_OF_MEMORY);
  CHECK(client == nullptr);
  CHECK(std::string{talus_last_error(nullptr)} == "talus_create: out of memory");
}

}  // namespace talus::c_api
