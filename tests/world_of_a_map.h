// A world whose ground is a height map from a file.
#pragma once

#include <cstdint>
#include <string>

#include "scratch_directory.h"

/// Writes world.toml and heights.npy of `side` x `side` samples, two bytes each; returns the world's path.
inline std::string write_world_of_a_map(const ScratchDirectory& scratch, int side) {
  std::string spec = read_whole(TALUS_SOURCE_DIR "/tests/golden/worlds/repeated_map.toml");
  const std::string name = "made by the test";
  spec.replace(spec.find(name), name.size(), "heights.npy");
  const std::string sides = std::to_string(side);
  std::string head = "{'descr': '<u2', 'fortran_order': False, 'shape': (" + sides + ", " + sides + "), }";
  head.resize(128 - 10 - 1, ' ');
  head += '\n';
  std::string map = std::string{"\x93NUMPY\x01\x00\x76\x00", 10} + head;
  for (std::int64_t i = 0; i < std::int64_t{side} * side; ++i)
    map += {static_cast<char>(i), static_cast<char>(i * i / 100 % 7)};
  (void)scratch.write("heights.npy", map);
  return scratch.write("world.toml", spec);
}
