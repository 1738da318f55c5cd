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

std::string text(const std::string& value) {
  return number(static_cast<std::uint32_t>(value.size())) + value;
}

std::string dictionary(const std::string& key = "", const std::string& value = "") {
  return key.empty() ? number(0) : number(1) + text(key) + text(value);
}

std::string layer(std::uint32_t id, const std::string& hidden) {
  return part("LAYR", number(id) + dictionary("_hidden", hidden) + number(0xFFFFFFFF));
}

std::string transform(std::uint32_t node, std::uint32_t child, const std::string& rotation = "") {
  return part("nTRN", number(node) + dictionary() + number(child) + number(0xFFFFFFFF) + number(0) +
                          number(1) + (rotation.empty() ? dictionary() : dictionary("_r", rotation)));
}

std::string group(std::uint32_t node, const std::vector<std::uint32_t>& children) {
  std::string list = number(node) + dictionary() + number(static_cast<std::uint32_t>(children.size()));
  for (const std::uint32_t child : children) list += number(child);
  return part("nGRP", list);
}

std::string shape(std::uint32_t node, std::uint32_t model) {
  return part("nSHP", number(node) + dictionary() + number(1) + number(model) + dictionary());
}

// Bits 0-1 and 2-3 are the columns of the first two rows' entries, bits 4 to 6 the rows' signs.
const std::string kZAlongY = "40";      // (x, -z, y)
const std::string kMirroredX = "20";    // (-x, y, z)
const std::string kQuarterTurn = "17";  // (-y, x, z)

TEST_CASE("A model is turned as the scene graph turns it") {
  const std::string pole = model({3, 4, 5}, {{0, 0, 0, 7}, {2, 3, 4, 9}});
  const auto shown = [&](const std::string& graph) {
    const auto models = decoded(vox(pole + graph));
    REQUIRE(models.has_value());
    return models->front();
  };
  const VoxelModel lain = shown(transform(0, 1) + group(1, {2}) + transform(2, 3, kZAlongY) + shape(3, 0));
  CHECK((lain.width == 3 && lain.depth == 5 && lain.height == 4));
  // In the file's axes (0, 4, 0) and (2, 0, 3): z turns into backward y, which points north.
  CHECK(lain.voxels == std::vector<VoxelModel::Voxel>{{0, 0, 0, 7}, {2, 3, 4, 9}});
  // A group's rotation comes after its members'.
  const VoxelModel both =
      shown(shape(3, 0) + transform(2, 3, kMirroredX) + group(1, {2}) + transform(0, 1, kQuarterTurn));
  CHECK((both.width == 4 && both.depth == 3 && both.height == 5));
  // (x, y, z) to (-x, y, z) to (-y, -x, z): (0, 0, 0) lies at (3, 2, 0), (2, 3, 4) at (0, 0, 4).
  CHECK(both.voxels == std::vector<VoxelModel::Voxel>{{3, 0, 0, 7}, {0, 4, 2, 9}});
  // Of two shapes of a model the first counts; a shape of no model, and a graph without shapes, turn nothing.
  CHECK(shown(transform(2, 3, kZAlongY) + shape(3, 0) + transform(4, 5, kMirroredX) + shape(5, 0)).voxels ==
        lain.voxels);
  CHECK(shown(transform(2, 3, kZAlongY) + shape(3, 17)).voxels == decoded(vox(pole))->front().voxels);
  CHECK(shown(transform(2, 3, kZAlongY)).voxels == decoded(vox(pole))->front().voxels);
}

TEST_CASE("A malformed scene graph is refused") {
  const std::string one = model({1, 1, 1}, {{0, 0, 0, 1}});
  check_refused(vox(one + transform(0, 1, "x")), "the nTRN at byte");
  check_refused(vox(one + transform(0, 1, "3")), "a rotation that is not one");
  check_refused(vox(one + transform(0, 1, "5")), "a rotation that is not one");
  check_refused(vox(one + part("nGRP", number(1) + dictionary() + number(0xFFFFFFFF))), "ends early");
  check_refused(vox(one + part("nSHP", "")), "ends early");
  check_refused(vox(one + part("nTRN", number(0) + number(1) + number(0xFFFFFFFF))), "ends early");
  check_refused(vox(one + transform(0, 1) + group(1, {0, 2}) + shape(2, 0)),
                "model 1 is in a scene graph that is a cycle");
}

TEST_CASE("Colours have the numbers of the editor's palette") {
  std::string order;  // as MagicaVoxel writes it: the number 1 + i shows the colour order[i]
  for (int i = 0; i < 256; ++i) order += static_cast<char>(i + 1);
  std::swap(order[0], order[241]);
  const std::string models = model({1, 1, 4}, {{0, 0, 0, 242}, {0, 0, 1, 1}, {0, 0, 2, 7}, {0, 0, 3, 255}});
  const auto shown = decoded(vox(models + part("IMAP", order)));
  REQUIRE(shown.has_value());
  CHECK(shown->front().voxels ==
        std::vector<VoxelModel::Voxel>{{0, 0, 0, 1}, {0, 1, 0, 242}, {0, 2, 0, 7}, {0, 3, 0, 255}});
  check_refused(vox(models + part("IMAP", order.substr(1))), "has an IMAP that is too short");
}

TEST_CASE("A model that MagicaVoxel hides is passed over") {
  const std::string two = model({1, 1, 1}, {{0, 0, 0, 1}}) + model({1, 1, 1}, {{0, 0, 0, 2}});
  const auto hiding = [](std::uint32_t node, std::uint32_t child, std::uint32_t in_layer) {
    return part("nTRN", number(node) + dictionary("_hidden", in_layer == 0 ? "1" : "0") + number(child) +
                            number(0xFFFFFFFF) + number(in_layer) + number(1) + dictionary());
  };
  const auto colours = [&](const std::string& graph) {
    const auto models = decoded(vox(two + graph));
    REQUIRE(models.has_value());
    std::vector<int> found;
    for (const VoxelModel& each : *models) found.push_back(each.voxels.front().colour);
    return found;
  };
  const std::string shapes = shape(3, 0) + shape(5, 1);
  CHECK(colours(hiding(2, 3, 0) + shapes) == std::vector{2});
  CHECK(colours(hiding(2, 3, 7) + shapes + layer(7, "1")) == std::vector{2});
  CHECK(colours(hiding(2, 3, 7) + shapes + layer(7, "0") + layer(6, "1")) == std::vector{1, 2});
  CHECK(colours(hiding(0, 1, 0) + group(1, {3, 8}) + shapes) == std::vector{2});
  // A model is seen where one of its shapes is, and turned as that is.
  CHECK(colours(hiding(2, 3, 0) + shapes + shape(9, 0)) == std::vector{1, 2});
}

TEST_CASE("An empty model is passed over, whatever its size") {
  const auto models =
      decoded(vox(model({200, 40, 40}, {}) + model({1, 1, 1}, {{0, 0, 0, 1}}) + model({3, 3, 3}, {})));
  REQUIRE(models.has_value());
  REQUIRE(models->size() == 1);
  CHECK(models->front().voxels == std::vector<VoxelModel::Voxel>{{0, 0, 0, 1}});
  const auto empty = decoded(vox(model({3, 3, 3}, {})));
  REQUIRE(empty.has_value());
  CHECK(empty->front().voxels.empty());
}

TEST_CASE("A hostile .vox file is refused in a line that says what is wrong") {
  const std::string good = vox(model({3, 4, 5}, {{0, 0, 0, 7}}));
  check_refused("", "not a .vox file");
  check_refused("VOX", "not a .vox file");
  check_refused("PNG " + good.substr(4), "not a .vox file");
  check_refused(good.substr(0, 8), "has no model");
  check_refused(good.substr(0, 30), "ends within the part at byte 20");
  check_refused(good.substr(0, good.size() - 1), "ends within the part");
  check_refused(vox(model({129, 4, 5}, {{0, 0, 0, 7}})),
                "model 1 has 129 x 4 voxels, 5 high; at most 128 x 128, 128 high");
  check_refused(vox(model({3, 4, 129}, {{0, 0, 0, 7}})), "129 high");
  check_refused(vox(model({0, 4, 3}, {})), "0 x 4");
  check_refused(vox(model({0xFFFFFFFF, 4, 3}, {})), "4294967295 x 4");
  check_refused(vox(model({3, 4, 5}, {{3, 0, 0, 7}})), "voxel 1 is outside its size or has colour 0");
  check_refused(vox(model({3, 4, 5}, {{0, 0, 0, 0}})), "voxel 1 is outside its size or has colour 0");
  check_refused(vox(part("XYZI", number(0))), "voxels without a SIZE");
  check_refused(vox(part("SIZE", number(1) + number(1) + number(1)) + part("TDCZ", "..")),
                "as Teardown compresses them");
  check_refused(vox(part("SIZE", number(1) + number(1) + number(1)) + model({1, 1, 1}, {})),
                "no voxels follow");
  check_refused(vox(part("SIZE", number(1) + number(1) + number(1)) + part("XYZI", number(0xFFFFFFFF))),
                "4294967295 voxels, more than its size or the file holds");
  check_refused(vox(model({1, 1, 1}, {{0, 0, 0, 7}, {0, 0, 0, 7}})), "2 voxels, more than its size");
  std::string many;
  for (int i = 0; i < 257; ++i) many += model({1, 1, 1}, {{0, 0, 0, 7}});
  check_refused(vox(many), "more than 256 models");
}

TEST_CASE("Any .vox file is read or refused") {
  CHECK(rc::check([] {
    std::string file = vox(model({3, 4, 5}, {{0, 0, 0, 7}, {2, 3, 4, 9}}) + model({1, 1, 1}, {{0, 0, 0, 1}}) +
                           transform(0, 1) + group(1, {2}) + transform(2, 3, kZAlongY) + shape(3, 0) +
                           part("IMAP", std::string(256, 'i')));
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
