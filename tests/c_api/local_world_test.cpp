#include <talus_local.h>

#include <algorithm>
#include <atomic>
#include <cstring>
#include <string>
#include <thread>
#include <vector>

#include <catch2/catch.hpp>

#include "local_world.h"
#include "scratch_directory.h"

namespace {

std::uint16_t voxel_at(const Workspace& workspace, std::int64_t x, std::int64_t y, std::int64_t z,
                       std::uint32_t flags = 0) {
  const talus_chunk_key key{static_cast<std::int32_t>(x >> 5), static_cast<std::int32_t>(y >> 5),
                            static_cast<std::int32_t>(z >> 5), 0};
  std::vector<std::uint16_t> voxels(TALUS_CHUNK_VOLUME);
  REQUIRE(talus_generate(workspace.get(), &key, 1, flags, voxels.data(), nullptr) == TALUS_OK);
  return voxels[static_cast<std::size_t>(TALUS_VOXEL_INDEX(x & 31, y & 31, z & 31))];
}

talus_status write_voxel(const Workspace& workspace, std::int64_t x, std::int64_t y, std::int64_t z,
                         std::uint16_t material, talus_edit_result* result = nullptr) {
  const std::int64_t voxel[]{x, y, z};
  talus_edit edit{};
  edit.size = sizeof edit;
  edit.write_count = 1;
  edit.write_voxels = voxel;
  edit.write_materials = &material;
  return talus_apply_edit(workspace.get(), &edit, result);
}

}  // namespace

TEST_CASE("a world tells what it has") {
  const LocalWorld world = open_world(kFlat);
  const talus_world_info info = info_of(world);
  CHECK(info.material_count == 5);
  CHECK(info.min_y == 0);
  CHECK(info.max_y > 16);
  CHECK(info.spawn_y > 0);
  CHECK(info.flags == 0);
  talus_material material{};
  material.size = sizeof material;
  REQUIRE(talus_world_get_material(world.get(), 4, &material) == TALUS_OK);
  CHECK(material.name == std::string{"planks"});
  CHECK(material.id == 256);
  CHECK(material.colour == 0x8a6b3d);
  CHECK(material.phase == TALUS_SOLID);
  CHECK(talus_world_get_material(world.get(), 5, &material) == TALUS_INVALID_ARGUMENT);
  CHECK_THAT(talus_local_error(), Catch::Equals("talus_world_get_material: index is 5; there are 5"));
}

TEST_CASE("heights are those of the voxels") {
  const LocalWorld world = open_world(kFlat);
  const Workspace workspace = workspace_of(world);
  std::int32_t heights[6];
  REQUIRE(talus_heights(world.get(), -1, 5, 3, 2, 0, heights, 6) == TALUS_OK);
  for (int i = 0; i < 6; ++i) {
    const std::int64_t top = ((heights[i] + 127) >> 8) - 1;
    CHECK(voxel_at(workspace, -1 + i % 3, top, 5 + i / 3) > 1);
    CHECK(voxel_at(workspace, -1 + i % 3, top + 1, 5 + i / 3) == 0);
  }
  CHECK(talus_heights(world.get(), 0, 0, 3, 2, 0, heights, 5) == TALUS_INVALID_ARGUMENT);
  CHECK(talus_heights(world.get(), INT64_MAX, 0, 3, 2, 0, heights, 6) == TALUS_OUT_OF_RANGE);
  CHECK(talus_heights(world.get(), 0, 0, 3, 2, 7, heights, 6) == TALUS_INVALID_ARGUMENT);
}

TEST_CASE("chunks come by array and by callback, each to its place") {
  const LocalWorld world = open_world(kFlat);
  const Workspace workspace = workspace_of(world);
  // Two patches that alternate, one key twice, air.
  const talus_chunk_key keys[]{{0, 0, 0, 0}, {9, 0, 0, 0}, {1, 1, 0, 0}, {0, 0, 0, 0}, {0, 100, 0, 2}};
  std::vector<std::uint16_t> voxels(5 * TALUS_CHUNK_VOLUME, 9'999);
  std::int32_t uniform[5];
  REQUIRE(talus_generate(workspace.get(), keys, 5, 0, voxels.data(), uniform) == TALUS_OK);
  CHECK(uniform[4] == 0);
  CHECK(uniform[0] == uniform[3]);
  const auto at = [&](std::size_t i) {
    return voxels.begin() + static_cast<std::ptrdiff_t>(i * TALUS_CHUNK_VOLUME);
  };
  CHECK(std::equal(at(0), at(1), at(3)));
  struct Taken {
    const std::vector<std::uint16_t>* expected;
    int count;
  } taken{&voxels, 0};
  const auto take = [](void* user, std::size_t index, std::int32_t, const std::uint16_t* given) {
    auto* const own = static_cast<Taken*>(user);
    if (std::memcmp(given, own->expected->data() + index * TALUS_CHUNK_VOLUME, TALUS_CHUNK_VOLUME * 2) == 0)
      ++own->count;
  };
  REQUIRE(talus_generate_each(workspace.get(), keys, 5, 0, take, &taken) == TALUS_OK);
  CHECK(taken.count == 5);

  talus_cancel_generate(workspace.get());
  std::fill(std::begin(uniform), std::end(uniform), 0);
  CHECK(talus_generate(workspace.get(), keys, 5, 0, voxels.data(), uniform) == TALUS_CANCELLED);
  CHECK(std::count(uniform, uniform + 5, -2) == 5);
  CHECK(talus_generate(workspace.get(), keys, 5, 0, voxels.data(), nullptr) == TALUS_OK);
}

TEST_CASE("an edit changes chunks, and a guard keeps it") {
  const LocalWorld world = open_world(kFlat);
  const Workspace workspace = workspace_of(world);
  talus_edit_result result{};
  result.size = sizeof result;
  REQUIRE(write_voxel(workspace, 0, 41, 0, 256, &result) == TALUS_OK);
  CHECK(result.changed_voxels == 1);
  CHECK(result.conflict == -1);
  CHECK(result.revision == 1);
  REQUIRE(result.chunk_count >= 1);
  CHECK(result.chunks[0].y == 1);
  CHECK(voxel_at(workspace, 0, 41, 0) == 256);
  CHECK(voxel_at(workspace, 0, 41, 0, TALUS_WITHOUT_EDITS) == 0);
  CHECK(info_of(world).flags == TALUS_UNSAVED);

  const std::int64_t voxel[]{0, 41, 0};
  const std::uint16_t air = 0;
  talus_edit guarded{};
  guarded.size = sizeof guarded;
  guarded.guard_count = guarded.write_count = 1;
  guarded.guard_voxels = guarded.write_voxels = voxel;
  guarded.guard_materials = guarded.write_materials = &air;
  CHECK(talus_apply_edit(workspace.get(), &guarded, &result) == TALUS_CONFLICT);
  CHECK(result.conflict == 0);
  CHECK(result.chunk_count == 0);
  CHECK(voxel_at(workspace, 0, 41, 0) == 256);
  CHECK(write_voxel(workspace, 0, 41, 0, 999) == TALUS_OUT_OF_RANGE);
  CHECK_THAT(talus_local_error(), Catch::Contains("material 999"));

  std::size_t count = 0;
  talus_chunk_key changed{};
  REQUIRE(talus_get_changed_chunks(world.get(), &changed, 1, &count) == TALUS_OK);
  CHECK(count == 1);
  CHECK(changed.y == 1);
}

TEST_CASE("a save goes on where the game ended") {
  const ScratchDirectory directory;
  const std::string file = (directory / "game.talus").string();
  talus_world_info before{};
  {
    const LocalWorld world = open_world(kFlat, TALUS_SETTLES);
    const Workspace workspace = workspace_of(world);
    CHECK(talus_save_commit(world.get()) == TALUS_INVALID_ARGUMENT);
    REQUIRE(write_voxel(workspace, 0, 41, 0, 256) == TALUS_OK);
    REQUIRE(talus_save_create(world.get(), file.c_str()) == TALUS_OK);
    CHECK(info_of(world).flags == (TALUS_SETTLES | TALUS_HAS_SAVE));
    CHECK(talus_save_create(world.get(), file.c_str()) == TALUS_INVALID_ARGUMENT);
    REQUIRE(write_voxel(workspace, 0, 42, 0, 256) == TALUS_OK);
    CHECK((info_of(world).flags & TALUS_UNSAVED) != 0);
    REQUIRE(talus_save_commit(world.get()) == TALUS_OK);
    before = info_of(world);
    talus_local_world* second = nullptr;
    CHECK(talus_save_open(file.c_str(), 0, &second) == TALUS_FILE_IN_USE);
  }
  talus_local_world* opened = nullptr;
  REQUIRE(talus_save_open(file.c_str(), 0, &opened) == TALUS_OK);
  const LocalWorld world{opened};
  const talus_world_info after = info_of(world);
  CHECK(after.hash_low == before.hash_low);
  CHECK(after.hash_high == before.hash_high);
  CHECK(after.revision == 2);
  CHECK(after.flags == (TALUS_SETTLES | TALUS_HAS_SAVE));
  CHECK(voxel_at(workspace_of(world), 0, 42, 0) == 256);
}

TEST_CASE("threads read a world while edits are saved") {
  const ScratchDirectory directory;
  const LocalWorld world = open_world(kFlat);
  REQUIRE(talus_save_create(world.get(), (directory / "game.talus").string().c_str()) == TALUS_OK);
  std::atomic<bool> ended = false;
  std::thread reader{[&] {
    talus_world_info info{};
    info.size = sizeof info;
    while (!ended) (void)talus_world_get_info(world.get(), &info);
  }};
  const Workspace workspace = workspace_of(world);
  int failures = 0;
  for (int i = 0; i < 10; ++i) {
    if (write_voxel(workspace, i, 41, 0, 256) != TALUS_OK) ++failures;
    if ((info_of(world).flags & TALUS_UNSAVED) == 0) ++failures;
    if (talus_save_commit(world.get()) != TALUS_OK) ++failures;
    if ((info_of(world).flags & TALUS_UNSAVED) != 0) ++failures;
  }
  ended = true;
  reader.join();
  CHECK(failures == 0);
}

TEST_CASE("wrong use is refused by a line that names the call") {
  const ScratchDirectory directory;
  talus_local_world* world = nullptr;
  talus_world_options options{};
  CHECK(talus_world_open(&options, &world) == TALUS_INVALID_ARGUMENT);
  CHECK_THAT(talus_local_error(), Catch::StartsWith("talus_world_open: options is NULL or has a wrong size"));
  options.size = sizeof options;
  options.toml = "seed = 1\nwrong = 2\n";
  options.toml_bytes = 19;
  CHECK(talus_world_open(&options, &world) == TALUS_BAD_WORLD);
  CHECK_THAT(talus_local_error(), Catch::Contains("world.toml:2: wrong"));
  CHECK(world == nullptr);
  CHECK(talus_save_open((directory / "none").string().c_str(), 0, &world) == TALUS_FILE_FAILED);
  CHECK(talus_save_open(directory.write("letter", std::string(5'000, 'a')).c_str(), 0, &world) ==
        TALUS_BAD_SAVE);
  const LocalWorld good = open_world(kFlat);
  const Workspace workspace = workspace_of(good);
  const talus_chunk_key keys[]{{0, 0, 0, 0}, {0, 0, 0, 7}};
  CHECK(talus_generate(workspace.get(), keys, 2, 0, nullptr, nullptr) == TALUS_INVALID_ARGUMENT);
  CHECK_THAT(talus_local_error(), Catch::Contains("keys[1].level"));
  CHECK(talus_generate(workspace.get(), keys, 1, 8, nullptr, nullptr) == TALUS_INVALID_ARGUMENT);
  CHECK(talus_generate(nullptr, keys, 1, 0, nullptr, nullptr) == TALUS_INVALID_ARGUMENT);
  talus_world_close(nullptr);
  talus_workspace_destroy(nullptr);
}

TEST_CASE("a world reads its files by callback or from a folder") {
  const std::string toml = kFlat + R"(
[[object]]
name = "watchtower"
model = "watchtower.vox"
spacing = 60
chance = 1
[object.palette]
1 = { name = "masonry", colour = "#8d8a84" }
2 = { name = "shingles", colour = "#6e4436" }
)";
  talus_world_options options{};
  options.size = sizeof options;
  options.toml = toml.c_str();
  options.toml_bytes = toml.size();
  talus_local_world* world = nullptr;
  CHECK(talus_world_open(&options, &world) == TALUS_BAD_WORLD);
  options.folder = TALUS_SOURCE_DIR "/core/worlds";
  REQUIRE(talus_world_open(&options, &world) == TALUS_OK);
  const LocalWorld by_folder{world};
  options.folder = nullptr;
  const std::string model = read_whole(TALUS_SOURCE_DIR "/core/worlds/watchtower.vox");
  options.user = const_cast<std::string*>(&model);
  options.read_file = [](void* user, const char* name, const void** bytes,
                         std::size_t* count) -> std::int32_t {
    const auto* const text = static_cast<const std::string*>(user);
    *bytes = text->data();
    *count = text->size();
    return std::string{name} == "watchtower.vox" ? 0 : 1;
  };
  REQUIRE(talus_world_open(&options, &world) == TALUS_OK);
  const LocalWorld by_callback{world};
  CHECK(info_of(by_folder).fingerprint_low == info_of(by_callback).fingerprint_low);
}

TEST_CASE("threads generate while another edits and saves") {
  const ScratchDirectory directory;
  const LocalWorld world = open_world(kFlat);
  REQUIRE(talus_save_create(world.get(), (directory / "game.talus").string().c_str()) == TALUS_OK);
  constexpr std::size_t kEdits = 24;
  std::atomic<int> wrong{0};  // a thread must not assert
  std::vector<std::thread> readers;
  for (int i = 0; i < 2; ++i) {
    readers.emplace_back([&world, &wrong, workspace = workspace_of(world)] {
      const talus_chunk_key key{0, 1, 0, 0};
      std::vector<std::uint16_t> voxels(TALUS_CHUNK_VOLUME);
      for (std::size_t last = 0; last < kEdits && wrong == 0;) {
        if (talus_generate(workspace.get(), &key, 1, 0, voxels.data(), nullptr) != TALUS_OK) ++wrong;
        // Edits come in order.
        std::size_t seen = 0;
        while (seen < kEdits && voxels[TALUS_VOXEL_INDEX(seen, 8, 0)] == 256) ++seen;
        if (seen < last) ++wrong;
        last = seen;
      }
    });
  }
  const Workspace workspace = workspace_of(world);
  for (std::size_t x = 0; x < kEdits; ++x) {
    if (write_voxel(workspace, static_cast<std::int64_t>(x), 40, 0, 256) != TALUS_OK) ++wrong;
    if (talus_save_commit(world.get()) != TALUS_OK) ++wrong;
  }
  for (std::thread& reader : readers) reader.join();
  CHECK(wrong == 0);
}
