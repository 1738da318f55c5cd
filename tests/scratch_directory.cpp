#include "scratch_directory.h"

#include <stdlib.h>
#include <unistd.h>

#include <fstream>
#include <iterator>
#include <system_error>

#include <catch2/catch.hpp>

ScratchDirectory::ScratchDirectory() : ScratchDirectory{std::filesystem::temp_directory_path()} {}

ScratchDirectory::ScratchDirectory(const std::filesystem::path& parent) {
  std::string pattern = (parent / "talus-test-XXXXXX").string();
  REQUIRE(::mkdtemp(pattern.data()) != nullptr);
  path_ = pattern;
}

std::filesystem::path ScratchDirectory::memory() {
  const char* const memory = "/dev/shm";
  return ::access(memory, W_OK) == 0 ? std::filesystem::path{memory} : std::filesystem::temp_directory_path();
}

ScratchDirectory::~ScratchDirectory() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::string ScratchDirectory::write(const std::string& name, const std::string& text) const {
  std::ofstream{path_ / name, std::ios::binary} << text;
  return (path_ / name).string();
}

std::size_t ScratchDirectory::file_count() const {
  return static_cast<std::size_t>(
      std::distance(std::filesystem::directory_iterator{path_}, std::filesystem::directory_iterator{}));
}

std::string read_whole(const std::filesystem::path& path) {
  std::ifstream file{path, std::ios::binary};
  return {std::istreambuf_iterator<char>{file}, {}};
}
