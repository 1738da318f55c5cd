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
  const std::vector<double> doubles{-1.5, 7, 0.1, 3e300};
  CHECK(std::get<std::vector<double>>(decoded(npy_of("<f8", "(2, 2)", bytes_of(doubles)))->samples) ==
        doubles);
  const std::vector<std::int64_t> large{-5'000'000'000, 7, 0, 3};
  CHECK(std::get<std::vector<double>>(decoded(npy_of("<i8", "(2, 2)", bytes_of(large)))->samples) ==
        std::vector<double>{-5e9, 7, 0, 3});
  const std::vector<std::int16_t> small{-32768, 7, 0, 3};
  CHECK(std::get<std::vector<std::int32_t>>(decoded(npy_of("<i2", "(2, 2)", bytes_of(small)))->samples) ==
        std::vector<std::int32_t>{-32768, 7, 0, 3});
  const std::vector<std::uint8_t> bytes{0, 7, 255, 3};
  CHECK(std::get<std::vector<std::uint8_t>>(decoded(npy_of("|u1", "(2, 2)", bytes_of(bytes)))->samples) ==
        bytes);
}

TEST_CASE("Arrays of either order of bytes and axes are read") {
  const std::string big_endian{"\0\1\0\2\0\3\1\4\0\5\0\6", 12};
  CHECK(std::get<Words>(decoded(npy_of(">u2", "(2, 3)", big_endian))->samples) == Words{1, 2, 3, 260, 5, 6});
  std::string by_columns = npy_of("<u2", "(2, 3)", bytes_of(Words{1, 4, 2, 5, 3, 6}));
  by_columns.replace(by_columns.find("False"), 5, "True ");
  CHECK(std::get<Words>(decoded(by_columns)->samples) == Words{1, 2, 3, 4, 5, 6});
}

TEST_CASE("A header is read as Python writes it") {
  const std::string four = bytes_of(Words{1, 2, 3, 4});
  const auto read = [&](const std::string& header) {
    const auto size = static_cast<std::uint16_t>(header.size());
    return error_of("\x93NUMPY\1" + std::string{'\0', static_cast<char>(size), static_cast<char>(size >> 8)} +
                    header + four);
  };
  for (const std::string& header : std::initializer_list<std::string>{
           "{\"descr\": \"<u2\", \"fortran_order\": False, \"shape\": (2, 2)}\n",
           "{'descr' : '<u2', 'fortran_order' : False, 'shape' : (2, 2)}\n",
           "{'descr': '<u2', 'fortran_order': False, 'shape': (2, 2)}" + std::string(50000, ' ') + '\n',
           "{'shape':(2L,2L,),\n'fortran_order':False,\t'descr':'<u2',}"}) {
    CAPTURE(header.substr(0, 70));
    CHECK(read(header) == "accepted");
  }
  CHECK(read("{'descr': [('h', '<u2')], 'fortran_order': False, 'shape': (2, 2)}") ==
        "is an .npy of records; an array of numbers is needed");
  for (const std::string& header : std::initializer_list<std::string>{
           "", "{}", "{'descr': '<u2', 'fortran_order': False}", "{'descr': '<u2\"", "{'shape': (2, 2)",
           "{'descr': '<u2', 'fortran_order': 0, 'shape': (2, 2)}",
           "{'descr': '<u2', 'fortran_order': False, 'shape': [2, 2]}",
           "{'descr': '<u2', 'fortran_order': False, 'shape': (4)}",
           "{'descr': '<u2', 'fortran_order': False, 'shape': (2, -2)}",
           "{'descr': '<u2', 'fortran_order': False, 'shape': (2, 2) 'x': 1}"}) {
    CAPTURE(header);
    CHECK_THAT(read(header), Catch::StartsWith("is an .npy whose header is not {'descr': TYPE,"));
  }
}

TEST_CASE("An 8-bit grey PNG is read exactly") {
  const auto map = decoded(png_of(4, 2, 8, PNG_COLOR_TYPE_GRAY));
  REQUIRE(map);
  CHECK(std::get<std::vector<std::uint8_t>>(map->samples) ==
        std::vector<std::uint8_t>{0, 0, 0, 1, 3, 232, 3, 233});
}

TEST_CASE("A sample that a PNG marks as transparent is missing data") {
  const auto with_transparent = [](std::uint16_t value) {
    std::string file = png_of(5, 3, 16, PNG_COLOR_TYPE_GRAY);
    const std::string mark{'t', 'R', 'N', 'S', static_cast<char>(value >> 8), static_cast<char>(value)};
    return file.insert(file.find("IDAT") - 4, big_endian(2) + mark + big_endian(crc_of(mark)));
  };
  CHECK(
      error_of(with_transparent(1002)) ==
      "has a transparent sample, which marks missing data: 1002, as sample 2 of row 1; fill it, or write the "
      "file without tRNS");
  CHECK(error_of(with_transparent(999)) == "accepted");
}

TEST_CASE("PNGs of other depths and colours are refused") {
  CHECK(error_of(png_of(4, 4, 4, PNG_COLOR_TYPE_GRAY)) ==
        "is a PNG of grey with 4 bits a channel; grey alone of 8 or 16 bits is needed");
  CHECK_THAT(error_of(png_of(4, 4, 16, PNG_COLOR_TYPE_RGB)), Catch::Contains("of RGB with 16 bits"));
  CHECK_THAT(error_of(png_of(4, 4, 8, PNG_COLOR_TYPE_GRAY_ALPHA)),
             Catch::Contains("of grey and alpha with 8 bits"));
  CHECK(error_of(png_of(1, 4, 16, PNG_COLOR_TYPE_GRAY)).starts_with("has 1 x 4 samples; 2 to 32768 a side"));
}

TEST_CASE("A claim of enormous size is refused before memory is asked for") {
  std::string file = png_of(4, 4, 16, PNG_COLOR_TYPE_GRAY);
  file.replace(16, 8, big_endian(30000) + big_endian(30000));
  file.replace(29, 4, big_endian(crc_of(file.substr(12, 17))));
  CHECK(error_of(file).starts_with("has 30000 x 30000 samples; "));
  file.replace(16, 8, big_endian(30000) + big_endian(2000));
  file.replace(29, 4, big_endian(crc_of(file.substr(12, 17))));
  CHECK_THAT(error_of(file), Catch::Contains("bytes cannot hold 30000 x 2000 samples"));
  file.replace(16, 8, big_endian(0x7FFFFFFF) + big_endian(0x7FFFFFFF));
  file.replace(29, 4, big_endian(crc_of(file.substr(12, 17))));
  CHECK(error_of(file) != "accepted");
  CHECK(error_of(npy_of("<f4", "(9999999999, 9999999999)", "")).starts_with("has 9999999999 x 9999999999"));
  CHECK(error_of(npy_of("<f4", "(99999999999, 2)", "")).starts_with("has 2 x 99999999999"));
  CHECK_THAT(error_of(npy_of("<f4", "(9999999999999999999, 2)", "")), Catch::Contains("whose header is not"));
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
  CHECK(error_of(npy_of("<c16", "(2, 2)", four)) ==
        "is an .npy of '<c16'; integers of 8 to 64 bits, or floats of 32 or 64, are needed");
  CHECK_THAT(error_of(npy_of("<f2", "(2, 2)", four)), Catch::Contains("is an .npy of '<f2'"));
  CHECK_THAT(error_of(npy_of("|b1", "(2, 2)", four)), Catch::Contains("is an .npy of '|b1'"));
  CHECK_THAT(error_of(npy_of("\n", "(2, 2)", four)), Catch::Contains("is an .npy of an unknown type"));
  CHECK_THAT(error_of(npy_of("", "(2, 2)", four)), Catch::Contains("is an .npy of ''"));
  CHECK_THAT(error_of(npy_of("<f4", "(4,)", four)), Catch::Contains("of 1 axis; two are needed"));
  CHECK_THAT(error_of(npy_of("<f4", "(2, 2, 1)", four)), Catch::Contains("of 3 axes; two are needed"));
  CHECK_THAT(error_of(npy_of("<f4", "(2, 3)", four)),
             Catch::Contains("has 16 bytes of samples; its shape needs 24"));
  CHECK_THAT(error_of(npy_of("<f4", "(2, 2)", four + "x")), Catch::Contains("has 17 bytes"));
  CHECK_THAT(error_of(npy_of("<f4", "(2, 2)", four, 9)), Catch::Contains("of version 9; 1 to 3 are known"));
  CHECK_THAT(error_of("\x93NUMPY"), Catch::Contains("ends in its header"));
  CHECK_THAT(error_of(npy_of("<f4", "(2, 2)", "").substr(0, 40)), Catch::Contains("ends in its header"));
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
