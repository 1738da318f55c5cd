// Where a test may write.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

/// An empty directory that goes away with its test.
class ScratchDirectory {
 public:
  ScratchDirectory();
  explicit ScratchDirectory(const std::filesystem::path& parent);
  /// In memory, where the machine has such files: for tests that write much and whose disk is their own.
  static std::filesystem::path memory();
  ScratchDirectory(const ScratchDirectory&) = delete;
  ScratchDirectory& operator=(const ScratchDirectory&) = delete;
  ~ScratchDirectory();

  [[nodiscard]] std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  /// Writes a file into it and returns its path.
  std::string write(const std::string& name, const std::string& text) const;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] std::size_t file_count() const;

 private:
  std::filesystem::path path_;
};

[[nodiscard]] std::string read_whole(const std::filesystem::path& path);
