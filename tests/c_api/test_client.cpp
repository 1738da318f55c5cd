#include "test_client.h"

#include <catch2/catch.hpp>
#include <chrono>

namespace talus::c_api::testing {

Voxels decode(const talus_chunk* chunk) {
  Voxels voxels(TALUS_CHUNK_VOLUME, 0xFFFF);
  REQUIRE(talus_decode(chunk, voxels.data(), voxels.size()) == TALUS_OK);
  return voxels;
}

TestClient::TestClient() {
  REQUIRE(talus_create(&client_) == TALUS_OK);
}

void TestClient::connect(std::uint16_t port, talus_connect_options options) {
  if (options.host == nullptr) options.host = "127.0.0.1";
  options.port = port;
  const talus_status status = talus_connect(client_, &options);
  INFO(error());
  REQUIRE(status == TALUS_OK);
}

talus_event TestClient::await(std::uint32_t type, const std::function<void(const talus_event&)>& other,
                              const std::function<void()>& meanwhile) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds{30};
  while (std::chrono::steady_clock::now() < end) {
    auto event = sized<talus_event>();
    const talus_status status = talus_poll(client_, &event, meanwhile ? 1 : 1000);
    if (meanwhile) meanwhile();
    if (status == TALUS_NO_EVENT) continue;
    INFO(error());
    REQUIRE(status == TALUS_OK);
    if (event.type == type) return event;
    INFO(event.message);
    REQUIRE(event.type != TALUS_EVENT_CLOSED);
    if (other) other(event);
  }
  FAIL("no event " << type << " came");
  return {};
}

void TestClient::join(std::uint16_t port, talus_connect_options options) {
  connect(port, options);
  (void)await(TALUS_EVENT_JOINED);
}

talus_world TestClient::world() const {
  auto world = sized<talus_world>();
  REQUIRE(talus_get_world(client_, &world) == TALUS_OK);
  return world;
}

talus_view TestClient::view(std::uint16_t horizontal, std::uint16_t vertical) const {
  const talus_world around = world();
  auto view = sized<talus_view>();
  view.centre_x = around.spawn_x;
  view.centre_y = around.spawn_y;
  view.centre_z = around.spawn_z;
  view.horizontal_radius = horizontal;
  view.vertical_radius = vertical;
  return view;
}

void TestClient::set_view(const talus_view& view) {
  const talus_status status = talus_set_view(client_, &view);
  INFO(error());
  REQUIRE(status == TALUS_OK);
}

std::map<Key, Voxels> TestClient::until_complete() {
  std::map<Key, Voxels> chunks;
  (void)await(TALUS_EVENT_VIEW_COMPLETE, [&](const talus_event& event) {
    if (event.type == TALUS_EVENT_CHUNK) chunks[key_of(event)] = decode(event.chunk);
    if (event.type == TALUS_EVENT_CHUNK_LEFT) chunks.erase(key_of(event));
  });
  return chunks;
}

}  // namespace talus::c_api::testing
