// talus-gen encode, decode and explain: what goes in comes out, and what is no chunk is refused.
#include "chunk_files.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include <talus/files/npy_file.h>
#include <talus/voxel/codec.h>
#include <talus/voxel/content_hash.h>

#include "scratch_directory.h"
#include "talus_gen.h"

using namespace talus;
using namespace talus::tools;
using talus::test::Outcome;
using talus::test::talus_gen;

namespace {

Chunk lamp(std::uint16_t lamp_id) {
  const auto voxels = std::make_unique<DenseVoxels>();
  std::fill_n(voxels->begin(), 12 * kChunkArea, MaterialId{1});
  (*voxels)[voxel_index({5, 20, 7})] = MaterialId{lamp_id};
  return Chunk::from_dense(*voxels);
}

std::string bytes_in(const std::filesystem::path& path) {
  std::ifstream file{path, std::ios::binary};
  return {std::istreambuf_iterator<char>{file}, {}};
}

void put_bytes(const std::filesystem::path& path, const std::string& bytes) {
  std::ofstream{path, std::ios::binary} << bytes;
}

std::string number(std::uint32_t value) {
  std::string bytes(4, ' ');
  std::memcpy(bytes.data(), &value, 4);
  return bytes;
}

std::string part(const std::string& id, const std::string& content, const std::string& children = "") {
  return id + number(static_cast<std::uint32_t>(content.size())) +
         number(static_cast<std::uint32_t>(children.size())) + content + children;
}

std::string vox_file(std::array<std::uint32_t, 3> size, const std::vector<std::array<char, 4>>& voxels) {
  std::string list = number(static_cast<std::uint32_t>(voxels.size()));
  for (const auto& voxel : voxels) list.append(voxel.data(), voxel.size());
  return "VOX " + number(150) +
         part("MAIN", "",
              part("SIZE", number(size[0]) + number(size[1]) + number(size[2])) + part("XYZI", list));
}

}  // namespace

TEST_CASE("Voxels come back from an array, of bytes and of words") {
  const ScratchDirectory scratch;
  for (const std::uint16_t id : {std::uint16_t{200}, std::uint16_t{300}}) {
    REQUIRE(write_voxels(lamp(id), scratch / "a.npy").has_value());
    CHECK(bytes_in(scratch / "a.npy").size() == files::kNpyHeaderBytes + kChunkVolume * (id > 255 ? 2 : 1));
    const auto chunk = read_voxels(scratch / "a.npy");
    REQUIRE(chunk.has_value());
    CHECK(*chunk == lamp(id));
  }
}

TEST_CASE("Encode and decode give an array back and say how large the payload is") {
  const ScratchDirectory scratch;
  const std::string at = "'" + (scratch / "").string();
  REQUIRE(write_voxels(lamp(300), scratch / "a.npy").has_value());
  const Outcome encoded = talus_gen("encode " + at + "a.npy' -o " + at + "a.chunk'");
  CHECK(encoded.exit_code == 0);
  CHECK_THAT(encoded.output, Catch::StartsWith("50 bytes; zstd -3: "));
  CHECK_THAT(encoded.output, Catch::Contains(to_string(content_hash(lamp(300)))));
  CHECK(bytes_in(scratch / "a.chunk").size() == 50);
  CHECK(talus_gen("decode " + at + "a.chunk' -o " + at + "b.npy'").exit_code == 0);
  CHECK(bytes_in(scratch / "a.npy") == bytes_in(scratch / "b.npy"));
  const Outcome explained = talus_gen("explain " + at + "a.chunk' --symbols 40");
  CHECK(explained.exit_code == 0);
  CHECK_THAT(explained.output, Catch::Contains("count of exceptions       17"));
  CHECK_THAT(explained.output, Catch::Contains("voxel (1, 12, 0)          context 252, symbol 0"));
}

TEST_CASE("A MagicaVoxel model stands in the chunk with its z up and its y north") {
  const ScratchDirectory scratch;
  put_bytes(scratch / "a.vox", vox_file({3, 4, 5}, {{0, 0, 0, 7}, {2, 3, 4, 9}}));
  const auto chunk = read_voxels(scratch / "a.vox");
  REQUIRE(chunk.has_value());
  CHECK(chunk->at({0, 0, 3}) == MaterialId{7});
  CHECK(chunk->at({2, 4, 0}) == MaterialId{9});
  CHECK(chunk->at({1, 1, 1}) == kAir);
}

TEST_CASE("A file that is not a chunk is one line that names it, and nothing is written") {
  const ScratchDirectory scratch;
  const auto refused = [&](const std::string& bytes, const std::string& command, const std::string& why) {
    put_bytes(scratch / "in", bytes);
    const Outcome outcome =
        talus_gen(command + " '" + (scratch / "in").string() + "'" +
                  (command == "explain" ? "" : " -o '" + (scratch / "out").string() + "'"));
    INFO(outcome.errors);
    CHECK(outcome.exit_code == 1);
    CHECK_THAT(outcome.errors, Catch::Contains("talus-gen " + command + ": " + (scratch / "in").string()));
    CHECK_THAT(outcome.errors, Catch::Contains(why));
    CHECK_FALSE(std::filesystem::exists(scratch / "out"));
  };
  REQUIRE(write_voxels(lamp(200), scratch / "a.npy").has_value());
  const std::string array = bytes_in(scratch / "a.npy");
  refused("", "encode", "32 x 32 x 32");
  refused("some text", "encode", "no chunk of voxels");
  refused(array.substr(0, array.size() - 1), "encode", "32 x 32 x 32");
  refused(array + "x", "encode", "32 x 32 x 32");
  refused(array.substr(0, 40), "encode", "ends in its header");
  std::string other = array;
  other.replace(other.find("(32, 32, 32)"), 12, "(32, 16, 64)");
  refused(other, "encode", "32 x 32 x 32");
  refused(vox_file({33, 4, 5}, {{0, 0, 0, 7}}), "encode", "33 x 4 voxels, 5 high; at most 32 x 32, 32 high");
  refused(vox_file({3, 4, 5}, {{3, 0, 0, 7}}), "encode", "voxel 1 is outside its size");
  refused(vox_file({3, 4, 5}, {{0, 0, 0, 7}}).substr(0, 50), "encode", "ends within the part at byte");
  refused("", "decode", "the chunk payload is empty");
  refused("\x02\x01", "decode", "versions 3 and 4");
  refused(std::string(70'000, '\x04'), "decode", "goes on after the chunk's end");
  refused(std::string{"\x04\x01\x01", 3}, "explain", "ends before the chunk does");
  CHECK(talus_gen("encode /nowhere.npy -o '" + (scratch / "out").string() + "'").exit_code == 1);
  CHECK(talus_gen("encode").exit_code == 2);
}
