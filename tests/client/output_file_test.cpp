#include "output_file.h"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <iterator>

#include <catch2/catch.hpp>

#include "scratch_directory.h"

namespace talus::cli {
namespace {

namespace fs = std::filesystem;

tl::expected<void, std::string> write(const fs::path& path, std::string_view text) {
  return write_file(path, std::as_bytes(std::span{text.data(), text.size()}));
}

std::string content(const fs::path& path) {
  std::ifstream in{path, std::ios::binary};
  return {std::istreambuf_iterator<char>{in}, {}};
}

}  // namespace

TEST_CASE("a file is written, then replaced, and nothing is left beside it") {
  const ScratchDirectory folder;
  const fs::path file = folder / "out";
  REQUIRE(write(file, "first").has_value());
  CHECK(content(file) == "first");
  REQUIRE(write(file, "second").has_value());
  CHECK(content(file) == "second");
  CHECK(folder.file_count() == 1);
}

TEST_CASE("other files beside the one written are left alone") {
  const ScratchDirectory folder;
  std::ofstream{folder / "out.part"} << "not ours";
  REQUIRE(write(folder / "out", "text").has_value());
  CHECK(content(folder / "out.part") == "not ours");
}

TEST_CASE("a name as long as names may be can be written") {
  const ScratchDirectory folder;
  const fs::path file = folder / std::string(255, 'n');
  REQUIRE(write(file, "text").has_value());
  CHECK(content(file) == "text");
}

TEST_CASE("symlinks are followed, also to a file that is not there yet") {
  const ScratchDirectory folder;
  fs::create_directory(folder / "inner");
  fs::create_symlink("inner/second", folder / "first");
  fs::create_symlink("file", folder / "inner" / "second");
  for (const char* text : {"new", "newer"}) {
    REQUIRE(write(folder / "first", text).has_value());
    CHECK(content(folder / "inner" / "file") == text);
  }
  CHECK(fs::is_symlink(folder / "first"));
  CHECK(fs::is_symlink(folder / "inner" / "second"));
}

TEST_CASE("what is no regular file is refused in one line and left as it is") {
  const ScratchDirectory folder;
  REQUIRE(::mkfifo((folder / "fifo").c_str(), 0600) == 0);
  fs::create_symlink("fifo", folder / "link");
  fs::create_symlink("loop", folder / "loop");
  fs::create_directory(folder / "inner");
  for (const char* name : {"fifo", "link", "loop", "inner"}) {
    const auto written = write(folder / name, "text");
    REQUIRE_FALSE(written.has_value());
    CHECK_THAT(written.error(), Catch::Contains(name) && !Catch::Contains("\n"));
  }
  CHECK(fs::is_fifo(folder / "fifo"));
  CHECK(fs::is_symlink(folder / "loop"));
  CHECK(folder.file_count() == 4);
}

TEST_CASE("a file in a folder that is not there is an error that says so") {
  const ScratchDirectory folder;
  const auto written = write(folder / "none" / "out", "text");
  REQUIRE_FALSE(written.has_value());
  CHECK_THAT(written.error(), Catch::Contains("No such file or directory"));
}

}  // namespace talus::cli
