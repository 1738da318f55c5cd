#include "atomic_file.h"

#include <span>
#include <string>

#include <catch2/catch.hpp>

#include "scratch_directory.h"

using namespace talus::tools;

namespace {

Expected<void> put(const AtomicFile& file, const std::string& text) {
  return file.write_at(0, std::as_bytes(std::span{text}));
}

void write_file(const std::filesystem::path& path, const std::string& text) {
  auto file = AtomicFile::create(path);
  REQUIRE(file);
  REQUIRE(put(*file, text));
  REQUIRE(file->commit());
}

}  // namespace

TEST_CASE("A file that is not committed leaves its target and its directory as they were") {
  const ScratchDirectory scratch;
  write_file(scratch / "f", "old");
  {
    auto file = AtomicFile::create(scratch / "f");
    REQUIRE(file);
    REQUIRE(put(*file, "half of the n"));
    CHECK(read_whole(scratch / "f") == "old");
  }
  CHECK(read_whole(scratch / "f") == "old");
  CHECK(scratch.file_count() == 1);
}

TEST_CASE("A committed file takes the place of an older one and leaves nothing else") {
  const ScratchDirectory scratch;
  write_file(scratch / "f", "old and long");
  write_file(scratch / "f", "new");
  CHECK(read_whole(scratch / "f") == "new");
  CHECK(scratch.file_count() == 1);
}

TEST_CASE("A link's target is written, and the link stays") {
  const ScratchDirectory scratch;
  write_file(scratch / "real", "old");
  std::filesystem::create_symlink(scratch / "real", scratch / "link");
  write_file(scratch / "link", "new");
  CHECK(std::filesystem::is_symlink(scratch / "link"));
  CHECK(read_whole(scratch / "real") == "new");
}

TEST_CASE("A device is never replaced") {
  const auto file = AtomicFile::create("/dev/null");
  REQUIRE_FALSE(file);
  CHECK(file.error().message == "/dev/null: is not a regular file");
}
