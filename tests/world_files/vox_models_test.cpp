// Models of .vox files, whole and hostile ones.
#include <sys/stat.h>

#include <array>
#include <catch2/catch.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include <talus/world_files/world_files.h>

#include "scratch_directory.h"

#include <rapidcheck.h>

namespace talus::world_files {
namespace {

using terrain::VoxelModel;
using Voxel = std::array<std::uint8_t, 4>;  // x, y, z and colour, as in the file

std::string number(std::uint32_t value) {
  std::string bytes;
  for (int i = 0; i < 4; ++i) bytes += static_cast<char>(value >> 8 * i & 0xFF);
  return bytes;
}

std::string part(const std::string& id, const std::string& content, std::uint32_t children = 0) {
  return id + number(static_cast<std::uint32_t>(content.size())) + number(children) + content;
}

std::string model(const std::array<std::uint32_t, 3>& size, const std::vector<Voxel>& voxels) {
  std::string list = number(static_cast<std::uint32_t>(voxels.size()));
  for (const Voxel& voxel : voxels) list.append(voxel.begin(), voxel.end());
  return part("SIZE", number(size[0]) + number(size[1]) + number(size[2])) + part("XYZI", list);
}

std::string vox(const std::string& models) {
  return "VOX " + number(150) + part("MAIN", "", static_cast<std::uint32_t>(models.size())) + models +
         part("RGBA", std::string(1024, 'c'));
}

tl::expected<std::vector<VoxelModel>, std::string> decoded(const std::string& file) {
  // An exact copy on the heap, so that a read past the end is one past an allocation too.
  const std::vector<char> bytes{file.begin(), file.end()};
  return decode_vox(std::as_bytes(std::span{bytes}));
}

void check_refused(const std::string& file, const std::string& why) {
  const auto models = decoded(file);
  REQUIRE_FALSE(models.has_value());
  CHECK_THAT(models.error(), Catch::Contains(why));
}

TEST_CASE("A file's models come in its order, y up and z south") {
  const auto models =
      decoded(vox(model({3, 4, 5}, {{0, 0, 0, 7}, {2, 3, 4, 9}}) + model({1, 1, 1}, {{0, 0, 0, 1}})));
  REQUIRE(models.has_value());
  REQUIRE(models->size() == 2);
  const VoxelModel& first = models->front();
  CHECK((first.width == 3 && first.depth == 4 && first.height == 5));
  CHECK(first.voxels == std::vector<VoxelModel::Voxel>{{0, 0, 3, 7}, {2, 4, 0, 9}});
  CHECK(models->back().voxels == std::vector<VoxelModel::Voxel>{{0, 0, 0, 1}});
}

TEST_CASE("A hostile .vox file is refused in a line that says what is wrong") {
  const std::string good = vox(model({3, 4, 5}, {{0, 0, 0, 7}}));
  check_refused("", "not a .vox file");
  check_refused("VOX", "not a .vox file");
  check_refused("PNG " + good.substr(4), "not a .vox file");
  check_refused(good.substr(0, 8), "has no model");
  check_refused(good.substr(0, 30), "ends within the part at byte 20");
  check_refused(good.substr(0, good.size() - 1), "ends within the part");
  check_refused(vox(model({22, 4, 5}, {{0, 0, 0, 7}})),
                "model 1 has 22 x 4 voxels, 5 high; at most 21 x 21, 32 high");
  check_refused(vox(model({3, 4, 33}, {{0, 0, 0, 7}})), "33 high");
  check_refused(vox(model({0, 4, 3}, {})), "0 x 4");
  check_refused(vox(model({0xFFFFFFFF, 4, 3}, {})), "4294967295 x 4");
  check_refused(vox(model({3, 4, 5}, {{3, 0, 0, 7}})), "voxel 1 is outside its size or has colour 0");
  check_refused(vox(model({3, 4, 5}, {{0, 0, 0, 0}})), "voxel 1 is outside its size or has colour 0");
  check_refused(vox(part("XYZI", number(0))), "voxels without a SIZE");
  check_refused(vox(part("SIZE", number(1) + number(1) + number(1)) + model({1, 1, 1}, {})),
                "no voxels follow");
  check_refused(vox(part("SIZE", number(1) + number(1) + number(1)) + part("XYZI", number(0xFFFFFFFF))),
                "4294967295 voxels, more than its size or the file holds");
  check_refused(vox(model({1, 1, 1}, {{0, 0, 0, 7}, {0, 0, 0, 7}})), "2 voxels, more than its size");
  std::string many;
  for (int i = 0; i < 33; ++i) many += model({1, 1, 1}, {{0, 0, 0, 7}});
  check_refused(vox(many), "more than 32 models");
}

TEST_CASE("Any .vox file is read or refused") {
  CHECK(rc::check([] {
    std::string file = vox(model({3, 4, 5}, {{0, 0, 0, 7}, {2, 3, 4, 9}}) + model({1, 1, 1}, {{0, 0, 0, 1}}));
    for (int i = 0; i < 3; ++i) {
      file[*rc::gen::inRange<std::size_t>(4, file.size())] = *rc::gen::arbitrary<char>();
    }
    file.resize(*rc::gen::inRange<std::size_t>(0, file.size() + 1));
    const auto models = decoded(file);
    if (!models) return;
    for (const VoxelModel& each : *models) {
      for (const VoxelModel::Voxel& voxel : each.voxels) {
        RC_ASSERT(
            (voxel.x < each.width && voxel.y < each.height && voxel.z < each.depth && voxel.colour > 0));
      }
    }
  }));
}

TEST_CASE("A spec's models are searched for next to the spec") {
  const ScratchDirectory scratch;
  scratch.write("tree.vox", vox(model({1, 1, 1}, {{0, 0, 0, 7}})));
  const auto load = beside(scratch / "world.toml").models;
  REQUIRE(load("tree.vox"));
  CHECK(load("none.vox").error() == "cannot be read: No such file or directory");
  CHECK(load(".").error() == "is a directory");
  CHECK(load("/dev/zero").error() ==
        "is not below the world file's folder; a path from there without .. is needed");
  std::filesystem::create_symlink("/dev/zero", scratch / "zero.vox");
  CHECK(load("zero.vox").error() == "is not a regular file");
  REQUIRE(::mkfifo((scratch / "pipe.vox").c_str(), 0600) == 0);  // which nobody writes to
  CHECK(load("pipe.vox").error() == "is not a regular file");
  CHECK(load(std::string{"tree.vox\0.vox", 13}).error() == "has control characters in its name");
}

}  // namespace
}  // namespace talus::world_files
