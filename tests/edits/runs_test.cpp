#include <talus/edits/runs.h>

#include <algorithm>
#include <initializer_list>
#include <map>
#include <optional>
#include <string_view>
#include <vector>

#include <rapidcheck.h>
#include <catch2/catch.hpp>

namespace talus::edits {
namespace {

using Bytes = std::vector<std::byte>;

Bytes bytes(std::initializer_list<int> values) {
  Bytes made;
  for (const int value : values) made.push_back(static_cast<std::byte>(value));
  return made;
}

Bytes encoded(const std::vector<Override>& voxels) {
  Bytes out;
  encode_runs(voxels, out);
  return out;
}

std::optional<RunsError> fault(const Bytes& block, std::size_t most = kChunkVolume) {
  const auto read = decode_runs(block, most);
  return read ? std::nullopt : std::optional{read.error()};
}

/// Boxes of a few materials, single voxels, large ids, the chunk's ends.
std::vector<Override> any_voxels() {
  std::map<std::uint16_t, MaterialId> voxels;
  for (int left = *rc::gen::inRange(0, 12); left > 0; --left) {
    const int first = *rc::gen::element(0, 1, 32, 1000, 32700, *rc::gen::inRange(0, kChunkVolume));
    const int length = *rc::gen::element(1, 2, 32, 70, 3000);
    const auto id = *rc::gen::element<std::uint16_t>(0, 1, 2, 127, 128, 300, 65535);
    for (int index = first; index < std::min(first + length, kChunkVolume); ++index) {
      voxels[static_cast<std::uint16_t>(index)] = MaterialId{id};
    }
  }
  std::vector<Override> list;
  for (const auto& [index, material] : voxels) list.push_back({index, material});
  return list;
}

}  // namespace

TEST_CASE("the bytes of runs are as in FORMAT.md") {
  const MaterialId three{3};
  const MaterialId large{300};
  const std::vector<Override> voxels{{5, three}, {6, three}, {7, three}, {8, large}, {40, large}};
  CHECK(encoded(voxels) == bytes({0x02, 0x03, 0xAC, 0x02, 0x03, 0x05, 0x04, 0x00, 0x01, 0x1F, 0x01}));
  CHECK(encoded({}) == bytes({0, 0}));
  std::vector<Override> whole;
  for (int i = 0; i < kChunkVolume; ++i) whole.push_back({static_cast<std::uint16_t>(i), MaterialId{65535}});
  CHECK(encoded(whole) == bytes({1, 0xFF, 0xFF, 0x03, 1, 0, 0xFF, 0xFF, 0x01}));
  CHECK(decode_runs(encoded(whole)).value() == whole);
}

TEST_CASE("voxels come back from their runs") {
  CHECK(rc::check([] {
    const auto voxels = any_voxels();
    const auto back = decode_runs(encoded(voxels));
    RC_ASSERT(back.has_value());
    RC_ASSERT(*back == voxels);
  }));
}

TEST_CASE("every voxel of a material of its own comes back") {
  std::vector<Override> voxels;
  for (int i = 0; i < kChunkVolume; ++i) {
    voxels.push_back({static_cast<std::uint16_t>(i), MaterialId{static_cast<std::uint16_t>(65535 - i)}});
  }
  CHECK(decode_runs(encoded(voxels)).value() == voxels);
}

TEST_CASE("bytes that are read equal the bytes that would be written: one encoding of each set") {
  CHECK(rc::check([] {
    auto block = encoded(any_voxels());
    for (int flips = *rc::gen::inRange(0, 3); flips > 0; --flips) {
      block[*rc::gen::inRange<std::size_t>(0, block.size())] ^= std::byte{1} << *rc::gen::inRange(0, 8);
    }
    const auto read = decode_runs(block);
    if (read) RC_ASSERT(encoded(*read) == block);
  }));
}

TEST_CASE("cut runs are truncated, runs with more behind them too long") {
  CHECK(rc::check([] {
    auto block = encoded(any_voxels());
    const auto kept = static_cast<std::ptrdiff_t>(*rc::gen::inRange<std::size_t>(0, block.size()));
    RC_ASSERT(fault({block.begin(), block.begin() + kept}) == RunsError::truncated);
    block.push_back(std::byte{0});
    RC_ASSERT(fault(block) == RunsError::too_long);
  }));
}

TEST_CASE("a block that is not canonical is refused by name") {
  CHECK(fault(bytes({1, 5, 1, 0, 0})) == std::nullopt);
  CHECK(fault(bytes({0x81, 0x00, 5, 1, 0, 0})) == RunsError::bad_number);     // 1 in two bytes
  CHECK(fault(bytes({1, 5, 1, 0, 0x80, 0x00})) == RunsError::bad_number);     // 0 in two bytes
  CHECK(fault(bytes({2, 5, 5, 2, 0, 0, 1, 1})) == RunsError::bad_materials);  // an id twice
  CHECK(fault(bytes({2, 6, 5, 2, 0, 0, 1, 1})) == RunsError::bad_materials);  // ids fall
  CHECK(fault(bytes({2, 5, 6, 1, 0, 0})) == RunsError::bad_materials);        // fewer runs than materials
  CHECK(fault(bytes({2, 5, 6, 2, 0, 0, 1, 0})) == RunsError::bad_materials);  // 6 is in no run
  CHECK(fault(bytes({0, 1, 0, 0})) == RunsError::bad_materials);              // a run of none
  CHECK(fault(bytes({1, 5, 2, 0, 0, 0, 0})) == RunsError::split_run);
  CHECK(fault(bytes({1, 5, 2, 0, 0, 1, 0})) == std::nullopt);  // a gap between them
}

TEST_CASE("runs end at the chunk's end") {
  CHECK(fault(bytes({1, 5, 1, 0xFF, 0xFF, 0x01, 0})) == std::nullopt);  // gap 32,767
  CHECK(fault(bytes({1, 5, 1, 0xFF, 0xFF, 0x01, 1})) == RunsError::past_chunk);
  CHECK(fault(bytes({1, 5, 1, 0x80, 0x80, 0x02, 0})) == RunsError::bad_number);  // gap 32,768
  CHECK(fault(bytes({1, 5, 1, 1, 0xFF, 0xFF, 0x01})) == RunsError::past_chunk);
}

TEST_CASE("numbers past their range, and past any, are bad") {
  CHECK(fault(bytes({0x81, 0x80, 0x02})) == RunsError::bad_number);              // 32,769 materials
  CHECK(fault(bytes({1, 0x80, 0x80, 0x04, 1, 0, 0})) == RunsError::bad_number);  // id 65,536
  CHECK(fault(bytes({1, 5, 1, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0x01})) ==
        RunsError::bad_number);
}

TEST_CASE("counts are held against the bytes that are left") {
  CHECK(fault(bytes({0x80, 0x80, 0x02, 1, 2, 3})) == RunsError::truncated);
  CHECK(fault(bytes({1, 5, 0x80, 0x80, 0x02, 0, 0})) == RunsError::truncated);
}

TEST_CASE("more voxels than the caller takes are refused before they are spread out") {
  const auto ten = bytes({1, 5, 1, 0, 9});
  CHECK(fault(ten, 10) == std::nullopt);
  CHECK(fault(ten, 9) == RunsError::too_many);
  CHECK(fault(bytes({0, 0}), 0) == std::nullopt);
}

TEST_CASE("every error of runs says in one line what is wrong and what would be right") {
  for (int i = 0; i <= static_cast<int>(RunsError::too_many); ++i) {
    const auto text = describe(static_cast<RunsError>(i));
    CAPTURE(text);
    CHECK(text.starts_with("runs: "));
    CHECK(text.find(';') != std::string_view::npos);
    CHECK(text.find('\n') == std::string_view::npos);
  }
}

}  // namespace talus::edits
