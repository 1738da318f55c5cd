// A file of acknowledged edits, from which another program can compute the expected world.
#pragma once

#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>

#include <tl/expected.hpp>

#include <talus/voxel/coords.h>
#include <talus/voxel/material.h>

namespace talus::load {

/// One line for each edit that changed its voxel: revision, x, y, z and material id, in decimal, separated by
/// blanks. Unordered. Thread-safe.
class EditJournal {
 public:
  /// Appends to `path` if it exists. An error is one line.
  [[nodiscard]] static tl::expected<std::shared_ptr<EditJournal>, std::string> open(const std::string& path);

  void add(std::uint64_t revision, VoxelPos at, MaterialId material);
  /// Writes everything so far to the file. An error, one line, means that some of it is missing.
  [[nodiscard]] tl::expected<void, std::string> flush();

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  EditJournal(std::string path, std::FILE* file) : path_{std::move(path)}, file_{file} {}

  const std::string path_;
  const std::unique_ptr<std::FILE, Close> file_;
};

}  // namespace talus::load
