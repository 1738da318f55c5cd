// A file of the edits that were acknowledged, so that another program can work out what the world must be.
#pragma once

#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>

#include <tl/expected.hpp>

#include <talus/voxel/coords.h>
#include <talus/voxel/material.h>

namespace talus::load {

/// A line for each edit that changed its voxel: revision, x, y, z and the material's id, in decimal and with
/// blanks between them. In no order: answers come as they come. Any thread may call.
class EditJournal {
 public:
  /// Appends to `path`, where that is there. An error is one line.
  [[nodiscard]] static tl::expected<std::shared_ptr<EditJournal>, std::string> open(const std::string& path);

  void add(std::uint64_t revision, VoxelPos at, MaterialId material);
  /// Everything so far is in the file. An error is one line: some of it is not.
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
