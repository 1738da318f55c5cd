// core/voxel/vectors/payloads.txt: what clients in any language are tested by holds for this one.
#include <fstream>
#include <iterator>
#include <sstream>

#include <catch2/catch.hpp>

#include <talus/voxel/content_hash.h>

#include "payload_vectors.h"

namespace talus {
namespace {

std::string vectors_file() {
  std::ifstream file{TALUS_SOURCE_DIR "/core/voxel/vectors/payloads.txt", std::ios::binary};
  return {std::istreambuf_iterator<char>{file}, {}};
}

std::vector<std::byte> bytes_of(const std::string& hex) {
  std::vector<std::byte> bytes;
  for (std::size_t i = 0; i + 1 < hex.size(); i += 2) {
    bytes.push_back(static_cast<std::byte>(std::stoul(hex.substr(i, 2), nullptr, 16)));
  }
  return bytes;
}

}  // namespace

TEST_CASE("the payload vectors are what encode writes") {
  CHECK(vectors_file() == testing::payload_vectors());
}

TEST_CASE("every payload vector decodes to its hash or is its error") {
  std::istringstream lines{vectors_file()};
  std::size_t checked = 0;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with('#')) continue;
    std::istringstream words{line};
    std::string kind;
    std::string name;
    std::string expected;
    std::string hex;
    REQUIRE(words >> kind >> name >> expected >> hex);
    CAPTURE(name);
    const auto chunk = decode(bytes_of(hex == "-" ? "" : hex));
    REQUIRE(chunk.has_value() == (kind == "chunk"));
    if (chunk) CHECK(to_string(content_hash(*chunk)) == expected);
    if (!chunk) CHECK(testing::name_of(chunk.error()) == expected);
    ++checked;
  }
  CHECK(checked > 25);
}

}  // namespace talus
