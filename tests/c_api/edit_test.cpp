// Edits through the C interface, against a real talusd: stored, seen, once over a killed server.
#include <csignal>
#include <map>
#include <memory>

#include <catch2/catch.hpp>

#include "scratch_directory.h"
#include "server_process.h"
#include "test_client.h"

namespace talus::c_api {
namespace {

using namespace testing;
using e2e::ServerProcess;
using e2e::Settings;

Settings editable(const ScratchDirectory& scratch) {
  return {e2e::kClassicWorld,
          {"TALUS_DATA", (scratch / "data").string()},
          {"TALUS_ACCESS_WITHOUT_TOKEN", "read,edit"}};
}

/// One voxel; the lists live as long as this.
struct OneWrite {
  std::int64_t voxel[3];
  std::uint16_t material;
  std::int64_t guard_voxel[3]{};
  std::uint16_t guard_material = 0;
  talus_edit edit = sized<talus_edit>();

  OneWrite(std::int64_t x, std::int64_t y, std::int64_t z, std::uint16_t to) : voxel{x, y, z}, material{to} {
    edit.write_voxels = voxel;
    edit.write_materials = &material;
    edit.write_count = 1;
  }
  OneWrite(const OneWrite&) = delete;
  OneWrite& operator=(const OneWrite&) = delete;
  void guard(std::int64_t x, std::int64_t y, std::int64_t z, std::uint16_t is) {
    guard_voxel[0] = x;
    guard_voxel[1] = y;
    guard_voxel[2] = z;
    guard_material = is;
    edit.guard_voxels = guard_voxel;
    edit.guard_materials = &guard_material;
    edit.guard_count = 1;
  }
};

std::uint32_t send(const TestClient& client, const talus_edit& edit) {
  std::uint32_t request = 0;
  const talus_status status = talus_send_edit(client.get(), &edit, &request);
  INFO(client.error());
  REQUIRE(status == TALUS_OK);
  return request;
}

std::uint16_t voxel_of(const Voxels& voxels, std::int64_t x, std::int64_t y, std::int64_t z) {
  return voxels[static_cast<std::size_t>(TALUS_VOXEL_INDEX(x & 31, y & 31, z & 31))];
}

}  // namespace

TEST_CASE(
    "an edit is answered when it is stored, and seen; a guard that does not hold keeps it from happening") {
  const ScratchDirectory scratch;
  const ServerProcess server{editable(scratch)};
  TestClient client;
  client.join(server.port());
  const talus_world world = client.world();
  const std::int64_t x = world.spawn_x;
  const std::int64_t y = world.spawn_y + 40;
  const std::int64_t z = world.spawn_z;
  client.set_view(client.view(1, 4));
  (void)client.until_complete();

  OneWrite write{x, y, z, 2};
  const std::uint32_t request = send(client, write.edit);
  std::uint16_t seen = 0;
  const auto note = [&](const talus_event& event) {
    if (event.type == TALUS_EVENT_CHUNK && event.level == 0 && event.x == x >> 5 && event.y == y >> 5 &&
        event.z == z >> 5)
      seen = voxel_of(decode(event.chunk), x, y, z);
  };
  const talus_event done = client.await(TALUS_EVENT_EDITED, note);
  CHECK(done.request == request);
  CHECK(done.status == TALUS_OK);
  CHECK(done.revision == 1);
  CHECK(done.changed_voxels == 1);
  if (seen == 0) note(client.await(TALUS_EVENT_CHUNK));
  CHECK(seen == 2);

  OneWrite guarded{x, y, z, 3};
  guarded.guard(x, y, z, 0);
  (void)send(client, guarded.edit);
  const talus_event refused = client.await(TALUS_EVENT_EDITED);
  CHECK(refused.status == TALUS_CONFLICT);
  CHECK_THAT(refused.message, Catch::Contains("guard 0"));
  CHECK(refused.changed_voxels == 0);

  // Fills and pastes: a box of stone, of which a paste without air changes one voxel, then all as generated.
  auto box = sized<talus_edit>();
  const std::int64_t corners[] = {x, y, z, x + 3, y + 3, z + 3};
  const std::int32_t stone = 2;
  box.fill_corners = corners;
  box.fill_materials = &stone;
  box.fill_count = 1;
  (void)send(client, box);
  CHECK(client.await(TALUS_EVENT_EDITED).changed_voxels == 63);
  auto paste = sized<talus_edit>();
  Voxels voxels(TALUS_CHUNK_VOLUME, 0);
  voxels[TALUS_VOXEL_INDEX(1, 1, 1)] = 3;
  paste.paste_voxels = voxels.data();
  paste.paste_x = x;
  paste.paste_y = y;
  paste.paste_z = z;
  (void)send(client, paste);
  CHECK(client.await(TALUS_EVENT_EDITED).changed_voxels == 1);
  const std::int32_t as_generated = TALUS_AS_GENERATED;
  const std::int32_t only = 2;
  box.fill_materials = &as_generated;
  box.fill_only = &only;
  (void)send(client, box);
  CHECK(client.await(TALUS_EVENT_EDITED).changed_voxels == 63);
}

TEST_CASE("edits happen once each, though the server is killed under them") {
  const ScratchDirectory scratch;
  Settings settings = editable(scratch);
  auto server = std::make_unique<ServerProcess>(settings);
  const std::uint16_t port = server->port();
  settings["TALUS_LISTEN"] = "127.0.0.1:" + std::to_string(port);
  TestClient client;
  auto options = sized<talus_connect_options>();
  options.reconnect_attempts = 1000;
  options.reconnect_first_delay_ms = 20;
  options.reconnect_max_delay_ms = 200;
  client.join(port, options);
  const talus_world world = client.world();
  const std::int64_t y = world.spawn_y + 60;
  // A row of voxels, each built only where the one before is: done twice its guard would not hold.
  constexpr int kCount = 40;
  std::map<std::uint32_t, int> asked;
  for (int i = 0; i < kCount; ++i) {
    OneWrite write{world.spawn_x + i, y, world.spawn_z, 2};
    write.guard(world.spawn_x + i, y, world.spawn_z, 0);
    asked[send(client, write.edit)] = i;
  }
  for (int i = 0; i < kCount; ++i) {
    if (i == 5) {
      server->signal(SIGKILL);
      (void)server->wait();
      server = std::make_unique<ServerProcess>(settings);
    }
    const talus_event event = client.await(TALUS_EVENT_EDITED);
    INFO(event.message);
    CHECK(event.status == TALUS_OK);
    CHECK(event.changed_voxels == 1);
    CHECK(asked.erase(event.request) == 1);
  }
  CHECK(asked.empty());
}

TEST_CASE("a client goes to the next of several servers when the first is killed") {
  auto first = std::make_unique<ServerProcess>();
  const ServerProcess second;
  const std::string more = "127.0.0.1:" + std::to_string(second.port());
  TestClient client;
  auto options = sized<talus_connect_options>();
  options.reconnect_attempts = 1000;
  options.reconnect_first_delay_ms = 20;
  options.more_servers = more.c_str();
  client.join(first->port(), options);
  first->signal(SIGKILL);
  (void)first->wait();
  (void)client.await(TALUS_EVENT_RECONNECTED);
  CHECK(client.world().fingerprint_low != 0);
}

TEST_CASE("an edit that was sent when its connection ends for good is of unknown outcome") {
  const ScratchDirectory scratch;
  auto server = std::make_unique<ServerProcess>(editable(scratch));
  TestClient client;
  client.join(server->port());
  const talus_world world = client.world();
  OneWrite first{world.spawn_x, world.spawn_y + 40, world.spawn_z, 2};
  (void)send(client, first.edit);
  CHECK(client.await(TALUS_EVENT_EDITED).status == TALUS_OK);
  server->freeze();
  OneWrite second{world.spawn_x, world.spawn_y + 41, world.spawn_z, 2};
  const std::uint32_t request = send(client, second.edit);
  auto event = sized<talus_event>();
  CHECK(talus_poll(client.get(), &event, 200) == TALUS_NO_EVENT);  // sent, and no answer comes
  server->signal(SIGKILL);
  (void)server->wait();
  const talus_event lost = client.await(TALUS_EVENT_EDITED);
  CHECK(lost.request == request);
  CHECK(lost.status == TALUS_OUTCOME_UNKNOWN);
}

TEST_CASE("an invalid edit is rejected by name, and nothing is sent") {
  const ServerProcess server{{e2e::kClassicWorld}};
  TestClient client;
  auto edit = sized<talus_edit>();
  CHECK(talus_send_edit(client.get(), &edit, nullptr) == TALUS_NOT_CONNECTED);
  client.join(server.port());
  const auto wrong = [&](const talus_edit& given) {
    REQUIRE(talus_send_edit(client.get(), &given, nullptr) == TALUS_INVALID_ARGUMENT);
    return client.error();
  };
  CHECK(talus_send_edit(client.get(), nullptr, nullptr) == TALUS_INVALID_ARGUMENT);
  edit.flags = 8;
  CHECK_THAT(wrong(edit), Catch::Contains("edit.flags"));
  edit = sized<talus_edit>();
  edit.write_count = 1;
  CHECK_THAT(wrong(edit), Catch::Contains("NULL"));
  edit.write_count = 1'000'000;
  CHECK_THAT(wrong(edit), Catch::Contains("edit.write_count is 1000000"));
  edit = sized<talus_edit>();
  const std::int64_t corners[6]{};
  const std::int32_t material = 70'000;
  edit.fill_corners = corners;
  edit.fill_materials = &material;
  edit.fill_count = 1;
  CHECK_THAT(wrong(edit), Catch::Contains("material 70000"));
  // A server without a directory stores nothing.
  OneWrite write{0, 0, 0, 2};
  (void)send(client, write.edit);
  CHECK(client.await(TALUS_EVENT_EDITED).status == TALUS_REFUSED);
}

}  // namespace talus::c_api
