// The worlds and regions whose hashes golden.txt has.
#pragma once

#include <cstdint>
#include <fstream>
#include <sstream>
#include <string>

#include <talus/voxel/coords.h>

namespace talus::test {

inline std::string read_file(const std::string& path) {
  std::ifstream file{path};
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

struct Place {
  const char* what;
  std::int64_t chunk_x;
  std::int64_t chunk_z;
  int tiles;
  int lod;
};

inline constexpr std::int64_t kEnd = std::int64_t{1} << 31;
inline constexpr Place kPlaces[] = {
    {"origin", -2, -2, 4, 0},
    {"far", 1234567, -7654321, 2, 0},
    {"upper end", kEnd - 2, kEnd - 2, 2, 0},
    {"lower end", -kEnd, -kEnd, 2, 0},
    {"level 1", -1, -1, 2, 1},
    {"level 2", -1, -1, 2, 2},
    {"level 3", -1, -1, 2, 3},
    {"level 4", -1, -1, 2, 4},
    {"level 6", -1, -1, 2, 6},
    {"level 6 upper end", (kEnd >> 6) - 2, (kEnd >> 6) - 2, 2, 6},
};

struct Sample {
  const char* name;
  const char* spec;  // its file, without .toml
  std::string more;  // keys that come before its own
};
inline const Sample kWorlds[] = {
    {"classic", "core/worlds/classic", ""},
    {"canyon", "core/worlds/canyon", ""},
    {"hills", "core/worlds/hills", ""},
    {"features", "core/worlds/features", ""},
    {"features, eroded", "core/worlds/features", "method = \"erosion\"\nerosion_steps = 8\n"},
    {"classic, eroded", "core/worlds/classic", "method = \"erosion\"\nerosion_steps = 8\n"},
    {"classic, eroded by one step", "core/worlds/classic", "method = \"erosion\"\nerosion_steps = 1\n"},
    {"ridged", "tests/golden/worlds/ridged", ""},
    {"warped", "tests/golden/worlds/warped", ""},
    {"height_map", "tests/golden/worlds/height_map", ""},
    {"repeated map", "tests/golden/worlds/repeated_map", ""},
    {"underground", "tests/golden/worlds/underground", ""},
    {"underground, eroded", "tests/golden/worlds/underground", "method = \"erosion\"\nerosion_steps = 5\n"},
    {"default", "core/worlds/default", ""},
    {"archipelago", "core/worlds/archipelago", ""},
    {"mesas", "core/worlds/mesas", ""},
    {"alpine", "core/worlds/alpine", ""}};

inline constexpr int kRandomWorlds = 100;

// At all levels, near, far and at the ends.
inline Place random_place(int i) {
  const int level = i % (Lod::kMax + 1);
  const std::int64_t end = kEnd >> level;
  const std::int64_t places[] = {0, i * 7919 % 2000 - 1000, end - 1, -end};
  return {"", places[i / 7 % 4], places[i / 28 % 4], 1, level};
}

}  // namespace talus::test
