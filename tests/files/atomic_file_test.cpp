#include <talus/files/atomic_file.h>

#include <sys/stat.h>
#include <unistd.h>

#include <span>
#include <string>

#include <catch2/catch.hpp>

#include "failing_files.h"
#include "scratch_directory.h"

using namespace talus::files;

namespace {

namespace fs = std::filesystem;

tl::expected<void, FileError> put(const AtomicFile& file, const std::string& text) {
  return file.write_at(0, std::as_bytes(std::span{text}));
}

}  // namespace

TEST_CASE("a file that is not committed leaves its target and its directory as they were") {
  const ScratchDirectory scratch;
  REQUIRE(write_file(scratch / "f", "old"));
  {
    auto file = AtomicFile::create(scratch / "f");
    REQUIRE(file);
    REQUIRE(put(*file, "half of the n"));
    CHECK(read_whole(scratch / "f") == "old");
  }
  CHECK(read_whole(scratch / "f") == "old");
  CHECK(scratch.file_count() == 1);
}

TEST_CASE("a committed file replaces a longer one and leaves nothing else") {
  const ScratchDirectory scratch;
  REQUIRE(write_file(scratch / "f", "old and long"));
  REQUIRE(write_file(scratch / "f", "new"));
  CHECK(read_whole(scratch / "f") == "new");
  CHECK(scratch.file_count() == 1);
}

TEST_CASE("other files in the directory stay, another run's too") {
  const ScratchDirectory scratch;
  const std::string left = ".talus." + std::to_string(::getpid()) + ".0.partial";
  scratch.write(left, "not ours");
  FailingFiles named;
  named.refuse_unnamed();
  REQUIRE(write_file(scratch / "f", "text"));
  REQUIRE(write_file(scratch / "f", "text", named));
  CHECK(read_whole(scratch / left) == "not ours");
  CHECK(scratch.file_count() == 2);
}

TEST_CASE("two files of one directory may be written at once") {
  const ScratchDirectory scratch;
  FailingFiles named;
  named.refuse_unnamed();
  auto first = AtomicFile::create(scratch / "first", named);
  auto second = AtomicFile::create(scratch / "second", named);
  REQUIRE((first && second));
  REQUIRE((put(*first, "1") && put(*second, "2")));
  REQUIRE((second->commit() && first->commit()));
  CHECK(read_whole(scratch / "first") == "1");
  CHECK(read_whole(scratch / "second") == "2");
}

TEST_CASE("a name as long as names may be can be written") {
  const ScratchDirectory scratch;
  const fs::path file = scratch / std::string(255, 'n');
  REQUIRE(write_file(file, "text"));
  CHECK(read_whole(file) == "text");
}

TEST_CASE("a file is written where its symlinks lead, also to a file that is not there yet") {
  const ScratchDirectory scratch;
  fs::create_directory(scratch / "inner");
  fs::create_symlink("inner/second", scratch / "first");
  fs::create_symlink("file", scratch / "inner" / "second");
  for (const char* text : {"new", "newer"}) {
    REQUIRE(write_file(scratch / "first", text));
    CHECK(read_whole(scratch / "inner" / "file") == text);
  }
  CHECK(fs::is_symlink(scratch / "first"));
  CHECK(fs::is_symlink(scratch / "inner" / "second"));
}

TEST_CASE("a file that is not regular is refused in one line and left as it is") {
  const ScratchDirectory scratch;
  REQUIRE(::mkfifo((scratch / "fifo").c_str(), 0600) == 0);
  fs::create_symlink("fifo", scratch / "link");
  fs::create_symlink("loop", scratch / "loop");
  fs::create_directory(scratch / "inner");
  for (const char* name : {"fifo", "link", "loop", "inner"}) {
    const auto written = write_file(scratch / name, "text");
    REQUIRE_FALSE(written);
    CHECK_THAT(written.error().message(), Catch::Contains(name) && !Catch::Contains("\n"));
  }
  CHECK(fs::is_fifo(scratch / "fifo"));
  CHECK(fs::is_symlink(scratch / "loop"));
  CHECK(scratch.file_count() == 4);
  CHECK(write_file("/dev/null", "text").error().message() == "/dev/null: is not a regular file");
  CHECK(write_file("", "text").error().message() == "'': is not a file name; give one");
}

TEST_CASE("a file in a directory that is not there is an error that says so") {
  const ScratchDirectory scratch;
  const fs::path file = scratch / "none" / "f";
  CHECK(write_file(file, "text").error().message() ==
        file.string() + ": cannot write: No such file or directory");
}

TEST_CASE("a file is whole where the system writes it in pieces") {
  const ScratchDirectory scratch;
  FailingFiles files;
  files.limit_transfers(3);
  REQUIRE(write_file(scratch / "f", "ten bytes!", files));
  CHECK(read_whole(scratch / "f") == "ten bytes!");
}

TEST_CASE("each call that fails leaves the old file or the whole new one, no other file and no open file") {
  const bool unnamed = GENERATE(true, false);
  const std::string text = "the new text";
  bool is_new = false;
  int failures = 0;
  for (;; ++failures) {
    const ScratchDirectory scratch;
    REQUIRE(write_file(scratch / "f", "old"));
    FailingFiles files;
    if (!unnamed) files.refuse_unnamed();
    files.fail_after(failures);
    const auto written = write_file(scratch / "f", text, files);
    CHECK(files.open_files() == 0);
    CHECK(scratch.file_count() == 1);
    const std::string content = read_whole(scratch / "f");
    CHECK((content == "old" || content == text));
    is_new = content == text;
    if (!files.has_failed()) break;
    // Where no unnamed file can be made, a named one is.
    if (!written) {
      CHECK(written.error().code == FailingFiles::kError);
      CHECK(written.error().reason == "cannot write: No space left on device");
    }
  }
  CHECK(is_new);
  CHECK(failures == (unnamed ? 7 : 6));
}

TEST_CASE("a file system that cannot sync directories is written to all the same") {
  const ScratchDirectory scratch;
  FailingFiles files;
  files.refuse_to_sync_directories();
  CHECK(write_file(scratch / "f", "text", files));
  CHECK(read_whole(scratch / "f") == "text");
}
