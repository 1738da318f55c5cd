#include <talus/files/npy_file.h>

#include <array>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "scratch_directory.h"

using namespace talus::files;

namespace {

// What numpy.lib.format writes for the same array but for the padding, which the format leaves free as
// long as the header ends on a multiple of 64.
std::string expected_header(const std::string& dictionary) {
  std::string header{"\x93NUMPY\x01\x00\x76\x00", 10};
  header += dictionary;
  header.resize(127, ' ');
  return header + "\n";
}

}  // namespace

TEST_CASE("An npy header names type, order and shape") {
  const std::array<std::size_t, 3> three{7, 180, 200};
  CHECK(npy_header(NpyType::int32, three) ==
        expected_header("{'descr': '<i4', 'fortran_order': False, 'shape': (7, 180, 200), }"));
  const std::array<std::size_t, 2> two{1, 2};
  CHECK(npy_header(NpyType::uint8, two) ==
        expected_header("{'descr': '|u1', 'fortran_order': False, 'shape': (1, 2), }"));
  CHECK(npy_header(NpyType::uint16, two) ==
        expected_header("{'descr': '<u2', 'fortran_order': False, 'shape': (1, 2), }"));
}

TEST_CASE("An npy shape of one axis is a tuple") {
  const std::array<std::size_t, 1> one{3};
  CHECK(npy_header(NpyType::int32, one) ==
        expected_header("{'descr': '<i4', 'fortran_order': False, 'shape': (3,), }"));
}

TEST_CASE("The longest header fits") {
  const std::array<std::size_t, 3> longest{std::size_t{1} << 31, std::size_t{1} << 31, std::size_t{1} << 31};
  CHECK(npy_header(NpyType::uint16, longest).size() == kNpyHeaderBytes);
}

TEST_CASE("An npy file holds little-endian items where they were written, and zeros elsewhere") {
  const ScratchDirectory scratch;
  auto file = NpyFile::create(scratch / "a.npy", NpyType::int32);
  REQUIRE(file);
  const std::array<std::int32_t, 2> items{-2, 0x01020304};
  REQUIRE(file->write(1, items));
  const std::array<std::size_t, 2> shape{2, 2};
  REQUIRE(file->finish(shape));
  REQUIRE(file->commit());
  CHECK(read_whole(scratch / "a.npy").substr(kNpyHeaderBytes) ==
        std::string("\0\0\0\0\xFE\xFF\xFF\xFF\x04\x03\x02\x01\0\0\0\0", 16));
}

TEST_CASE("Items past an npy file's shape are cut") {
  const ScratchDirectory scratch;
  auto file = NpyFile::create(scratch / "a.npy", NpyType::uint8);
  REQUIRE(file);
  const std::vector<std::uint8_t> items(100, 9);
  REQUIRE(file->write(0, items));
  const std::array<std::size_t, 1> shape{5};
  REQUIRE(file->finish(shape));
  REQUIRE(file->commit());
  CHECK(read_whole(scratch / "a.npy").substr(kNpyHeaderBytes) == std::string(5, '\x09'));
}
