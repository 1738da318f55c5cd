// SQLite's files with a disk that fails, or a process that is killed, at a chosen change of a file.
#pragma once

#include <cstdint>

#include <catch2/catch.hpp>

class FailingDisk {
 public:
  enum class Failure : std::uint8_t { full, broken, killed };

  /// From here on SQLite uses these files, until the object goes: change `at` and all later ones fail; 0:
  /// none.
  FailingDisk(Failure failure, int at);
  ~FailingDisk();
  FailingDisk(const FailingDisk&) = delete;
  FailingDisk& operator=(const FailingDisk&) = delete;

  /// Changes of files so far: writes, syncs, truncations and removals.
  [[nodiscard]] static int changes();
  /// From here on nothing fails.
  static void mend();
};
