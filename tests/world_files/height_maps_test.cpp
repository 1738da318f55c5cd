// Height maps come from outside: what is whole is read to the number, what is not is refused by name.
#include <talus/world_files/world_files.h>

#include <png.h>
#include <rapidcheck.h>
#include <catch2/catch.hpp>

#include <array>
#include <cstring>
#include <string>
#include <vector>

#include <talus/terrain/world.h>

#include "scratch_directory.h"

namespace talus::world_files {
namespace {

using Words = std::vector<std::uint16_t>;

// A PNG of one channel or more by libpng's own writer.
std::string png_of(int width, int depth, int bits, int colour, bool interlaced = false, double gamma = 0) {
  std::string file;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_set_write_fn(
      png, &file,
      [](png_structp p, png_bytep bytes, std::size_t count) {
        static_cast<std::string*>(png_get_io_ptr(p))->append(reinterpret_cast<char*>(bytes), count);
      },
      nullptr);
  png_set_IHDR(png, info, static_cast<png_uint_32>(width), static_cast<png_uint_32>(depth), bits, colour,
               interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
               PNG_FILTER_TYPE_DEFAULT);
  if (gamma > 0) png_set_gAMA(png, info, gamma);
  png_write_info(png, info);
  const std::size_t row_bytes = png_get_rowbytes(png, info);
  std::vector<std::vector<png_byte>> rows;
  for (int z = 0; z < depth; ++z) {
    auto& row = rows.emplace_back(row_bytes);
    for (std::size_t i = 0; i < row_bytes; ++i) {
      const std::size_t sample = static_cast<std::size_t>(z) * 1000 + i / 2;
      row[i] = static_cast<png_byte>(i % 2 == 0 ? sample >> 8 : sample);
    }
  }
  std::vector<png_bytep> pointers;
  for (auto& row : rows) pointers.push_back(row.data());
  png_write_image(png, pointers.data());
  png_write_end(png, nullptr);
  png_destroy_write_struct(&png, &info);
  return file;
}

std::string npy_of(const std::string& type, const std::string& shape, const std::string& data,
                   char version = 1) {
  std::string header = "{'descr': '" + type + "', 'fortran_order': False, 'shape': " + shape + ", }\n";
  std::string file = "\x93NUMPY";
  file += version;
  file += '\0';
  file += static_cast<char>(header.size());
  file += '\0';
  if (version > 1) file += std::string(2, '\0');
  return file + header + data;
}

template <class Sample>
std::string bytes_of(const std::vector<Sample>& samples) {
  return {reinterpret_cast<const char*>(samples.data()), samples.size() * sizeof(Sample)};
}

auto decoded(const std::string& file) {
  return decode_height_map(std::as_bytes(std::span{file}));
}

std::string error_of(const std::string& file) {
  const auto map = decoded(file);
  return map ? "accepted" : map.error();
}

TEST_CASE("A 16-bit grey PNG is read to the number, interlaced or not, whatever its gamma") {
  for (const bool interlaced : {false, true}) {
    const auto map = decoded(png_of(5, 3, 16, PNG_COLOR_TYPE_GRAY, interlaced, interlaced ? 0.45 : 0));
    REQUIRE(map);
    CHECK(map->width == 5);
    CHECK(map->depth == 3);
    CHECK(std::get<Words>(map->samples) ==
          Words{0, 1, 2, 3, 4, 1000, 1001, 1002, 1003, 1004, 2000, 2001, 2002, 2003, 2004});
  }
}

TEST_CASE("An array of two axes is read to the number, in every type") {
  const auto words = decoded(npy_of("<u2", "(2, 3)", bytes_of(Words{1, 2, 3, 4, 5, 65535})));
  REQUIRE(words);
  CHECK(words->width == 3);
  CHECK(words->depth == 2);
  CHECK(std::get<Words>(words->samples) == Words{1, 2, 3, 4, 5, 65535});
  const std::vector<std::int32_t> whole{-2000000000, 7, 0, 3};
  CHECK(std::get<std::vector<std::int32_t>>(decoded(npy_of("<i4", "(2, 2)", bytes_of(whole)))->samples) ==
        whole);
  const std::vector<float> real{-1.5F, 7, 0, 3e30F};
  CHECK(std::get<std::vector<float>>(decoded(npy_of("<f4", "(2, 2,)", bytes_of(real), 2))->samples) == real);
}

TEST_CASE("PNGs of other depths and colours are refused") {
  CHECK(error_of(png_of(4, 4, 8, PNG_COLOR_TYPE_GRAY)) ==
        "has 8 bits a channel; 16 bits of grey alone are needed");
  CHECK_THAT(error_of(png_of(4, 4, 16, PNG_COLOR_TYPE_RGB)), Catch::Contains("in colour"));
  CHECK_THAT(error_of(png_of(4, 4, 16, PNG_COLOR_TYPE_GRAY_ALPHA)), Catch::Contains("transparency"));
  CHECK(error_of(png_of(1, 4, 16, PNG_COLOR_TYPE_GRAY)).starts_with("has 1 x 4 samples; 2 to 32768 a side"));
}

std::uint32_t crc_of(const std::string& bytes) {
  std::uint32_t crc = 0xFFFFFFFFU;
  for (const char c : bytes) {
    crc ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1U) != 0 ? 0xEDB88320U : 0U);
  }
  return ~crc;
}

std::string big_endian(std::uint32_t number) {
  return {static_cast<char>(number >> 24), static_cast<char>(number >> 16), static_cast<char>(number >> 8),
          static_cast<char>(number)};
}

TEST_CASE("A claim of enormous size is refused before memory is asked for") {
  std::string file = png_of(4, 4, 16, PNG_COLOR_TYPE_GRAY);
  file.replace(16, 8, big_endian(30000) + big_endian(30000));
  file.replace(29, 4, big_endian(crc_of(file.substr(12, 17))));
  CHECK(error_of(file).starts_with("has 30000 x 30000 samples; "));
  file.replace(16, 8, big_endian(0x7FFFFFFF) + big_endian(0x7FFFFFFF));
  file.replace(29, 4, big_endian(crc_of(file.substr(12, 17))));
  CHECK(error_of(file) != "accepted");
  CHECK(error_of(npy_of("<f4", "(9999999999, 9999999999)", "")).starts_with("has 9999999999 x 9999999999"));
  CHECK_THAT(error_of(npy_of("<f4", "(99999999999, 2)", "")), Catch::Contains("two axes"));
}

TEST_CASE("No part of a PNG is a PNG, and damage is noticed") {
  const std::string whole = png_of(16, 16, 16, PNG_COLOR_TYPE_GRAY);
  for (std::size_t size = 0; size < whole.size(); ++size)
    CHECK(error_of(whole.substr(0, size)) != "accepted");
  CHECK_THAT(error_of(whole.substr(0, whole.size() / 2)),
             Catch::Contains("is not a whole PNG: the file ends early"));
  CHECK(rc::check([&] {
    std::string damaged = whole;
    const auto at = *rc::gen::inRange<std::size_t>(0, whole.size());
    damaged[at] = static_cast<char>(damaged[at] ^ (1 << *rc::gen::inRange(0, 8)));
    (void)error_of(damaged);  // refused or not, nothing else happens
  }));
}

TEST_CASE("Arrays that are not what is needed are refused") {
  const std::string four(16, '\1');
  CHECK_THAT(error_of(npy_of("<f8", "(2, 2)", four + four)), Catch::Contains("another type than '<u2'"));
  CHECK_THAT(error_of(npy_of(">f4", "(2, 2)", four)), Catch::Contains("another type"));
  CHECK_THAT(error_of(npy_of("<f4", "(4,)", four)), Catch::Contains("without exactly two axes"));
  CHECK_THAT(error_of(npy_of("<f4", "(2, 2, 1)", four)), Catch::Contains("without exactly two axes"));
  CHECK_THAT(error_of(npy_of("<f4", "(2, -2)", four)), Catch::Contains("without exactly two axes"));
  CHECK_THAT(error_of(npy_of("<f4", "(2, 3)", four)),
             Catch::Contains("has 16 bytes of samples; its shape needs 24"));
  CHECK_THAT(error_of(npy_of("<f4", "(2, 2)", four + "x")), Catch::Contains("has 17 bytes"));
  CHECK_THAT(error_of(npy_of("<f4", "(2, 2)", four, 9)), Catch::Contains("of version 9; 1 to 3 are known"));
  CHECK_THAT(error_of("\x93NUMPY"), Catch::Contains("ends in its header"));
  CHECK_THAT(error_of(npy_of("<f4", "(2, 2)", "").substr(0, 40)), Catch::Contains("ends in its header"));
  std::string fortran = npy_of("<f4", "(2, 2)", four);
  fortran.replace(fortran.find("False"), 5, "True ");
  CHECK_THAT(error_of(fortran), Catch::Contains("Fortran"));
  CHECK_THAT(error_of("P5 2 2 65535\n"), Catch::Contains("neither PNG nor .npy"));
  CHECK_THAT(error_of(""), Catch::Contains("neither PNG nor .npy"));
}

TEST_CASE("Any header of an array is read or refused") {
  CHECK(rc::check([] {
    std::string file =
        npy_of("<u2", "(2, 2)", std::string(8, 'x'), static_cast<char>(*rc::gen::inRange(1, 4)));
    for (int i = 0; i < 3; ++i) {
      file[*rc::gen::inRange<std::size_t>(6, file.size())] = *rc::gen::arbitrary<char>();
    }
    (void)error_of(file);
  }));
}

TEST_CASE("A spec's file is searched for next to the spec") {
  const ScratchDirectory scratch;
  std::filesystem::create_directory(scratch / "maps");
  scratch.write("maps/m.png", png_of(4, 4, 16, PNG_COLOR_TYPE_GRAY));
  const auto load = beside(scratch / "world.toml").height_map;
  REQUIRE(load("maps/m.png"));
  REQUIRE(load("./maps/m.png"));
  const std::string outside = "is not below the world file's folder; a path from there without .. is needed";
  for (const std::string& name : {(scratch / "maps/m.png").string(), std::string{"../m.png"},
                                  std::string{"maps/../maps/m.png"}, std::string{".."}}) {
    CHECK(load(name).error() == outside);
  }
  CHECK(load("m.png").error() == "cannot be read: No such file or directory");
  CHECK(load("maps").error() == "is a directory");
}

}  // namespace
}  // namespace talus::world_files
