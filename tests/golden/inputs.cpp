// Prints as JSON what golden_text.mjs makes the text of golden.txt of: worlds, places and files. Links no
// module.
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <ranges>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <talus/terrain/height_map.h>

#include "golden_worlds.h"
#include "made_height_map.h"
#include "random_regions.h"

namespace {

using namespace talus;
using namespace talus::test;

std::string quoted(std::string_view text) {
  std::string json = "\"";
  for (const char c : text) {
    if (c == '\n') {
      json += "\\n";
      continue;
    }
    if (c == '"' || c == '\\') json += '\\';
    json += c;
  }
  return json + '"';
}

std::string json_of(const Place& place) {
  std::ostringstream json;
  json << R"({"what":)" << quoted(place.what) << R"(,"lod":)" << place.lod << R"(,"x":)" << place.chunk_x
       << R"(,"z":)" << place.chunk_z << R"(,"tiles":)" << place.tiles << '}';
  return json.str();
}

// The height map as .npy, in hexadecimal.
std::string npy_of(const terrain::HeightMap& map) {
  const std::string shape = '(' + std::to_string(map.depth) + ", " + std::to_string(map.width) + ')';
  std::string header = "{'descr': '<u2', 'fortran_order': False, 'shape': " + shape + ", }";
  header.resize(117, ' ');
  std::string bytes = std::string{"\x93NUMPY\x01\x00\x76\x00", 10} + header + '\n';
  for (const std::uint16_t sample : std::get<std::vector<std::uint16_t>>(map.samples)) {
    bytes += {static_cast<char>(sample & 255), static_cast<char>(sample >> 8)};
  }
  std::string digits;
  for (const char byte : bytes) {
    digits += {"0123456789abcdef"[(byte >> 4) & 15], "0123456789abcdef"[byte & 15]};
  }
  return digits;
}

// The names in `file = "NAME"`.
void add_files(const std::string& toml, std::set<std::string>& files) {
  constexpr std::string_view kKey = "\nfile = \"";
  for (std::size_t at = 0; (at = toml.find(kKey, at)) != std::string::npos;) {
    at += kKey.size();
    files.insert(toml.substr(at, toml.find('"', at) - at));
  }
}

}  // namespace

int main() {
  std::ostream& out = std::cout;
  const auto list = [&out](const char* key, const auto& items, const auto& print_item) {
    out << quoted(key) << ":[";
    for (const char* comma = ""; const auto& item : items) {
      out << std::exchange(comma, ",\n");
      print_item(item);
    }
    out << "],\n";
  };
  std::set<std::string> files;
  out << '{';
  list("worlds", kWorlds, [&](const Sample& world) {
    const std::string toml =
        world.more + read_file(std::string{TALUS_SOURCE_DIR} + "/" + world.spec + ".toml");
    add_files(toml, files);
    out << R"({"name":)" << quoted(world.name) << R"(,"toml":)" << quoted(toml) << '}';
  });
  list("places", kPlaces, [&](const Place& place) { out << json_of(place); });
  list("random", std::views::iota(0, kRandomWorlds), [&](int i) {
    out << R"({"toml":)" << quoted(random_regions_text(static_cast<std::uint64_t>(i))) << R"(,"place":)"
        << json_of(random_place(i)) << '}';
  });
  out << R"("files":{)";
  for (const char* comma = ""; const std::string& name : files) {
    out << std::exchange(comma, ",") << quoted(name) << ':' << quoted(npy_of(made_height_map()));
  }
  out << "}}\n";
}
