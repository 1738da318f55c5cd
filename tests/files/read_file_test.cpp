#include <talus/files/read_file.h>
#include <talus/files/secret_file.h>

#include <sys/stat.h>

#include <catch2/catch.hpp>

#include "failing_files.h"
#include "scratch_directory.h"

using namespace talus::files;

TEST_CASE("a file of just the bound is read whole, also in pieces") {
  const ScratchDirectory scratch;
  const std::string text(10'000, 'x');
  const std::string file = scratch.write("f", text);
  FailingFiles files;
  files.limit_transfers(7);
  CHECK(read_file(file, text.size(), files) == text);
  const auto secret = SecretFile::read(file, text.size(), files);
  REQUIRE(secret);
  CHECK(secret->text() == text);
}

TEST_CASE("a file over the bound is refused without being read to its end") {
  CHECK(read_file("/dev/zero", 100).error().code == std::errc::file_too_large);
  const ScratchDirectory scratch;
  const std::string file = scratch.write("f", "four");
  CHECK(read_file(file, 3).error().code == std::errc::file_too_large);
  CHECK(read_file(file, 3).error().message() == file + ": has over 3 bytes");
  CHECK(SecretFile::read(file, 3).error().reason == "has over 3 bytes");
}

TEST_CASE("a missing file or a directory is an error with the system's words") {
  const ScratchDirectory scratch;
  CHECK(read_file(scratch / "none", 9).error().message() ==
        (scratch / "none").string() + ": cannot be read: No such file or directory");
  CHECK(SecretFile::read(scratch / "none", 9).error().reason == "cannot be read: No such file or directory");
  CHECK(read_file(scratch.path(), 9).error().code == std::errc::is_a_directory);
}

TEST_CASE("a secret is read only from a regular file, and a pipe without a writer does not block") {
  const ScratchDirectory scratch;
  REQUIRE(::mkfifo((scratch / "pipe").c_str(), 0600) == 0);
  for (const auto& path : {scratch / "pipe", scratch.path(), std::filesystem::path{"/dev/zero"}}) {
    CHECK(SecretFile::read(path, 100).error().reason == "is not a regular file");
  }
}

TEST_CASE("a file that must be regular is refused otherwise, and does not block") {
  const ScratchDirectory scratch;
  REQUIRE(::mkfifo((scratch / "pipe").c_str(), 0600) == 0);
  CHECK(read_regular_file(scratch / "pipe", 100).error().reason == "is not a regular file");
  CHECK(read_regular_file("/dev/zero", 100).error().reason == "is not a regular file");
  CHECK(read_regular_file(scratch.path(), 100).error().reason == "is a directory");
  CHECK(read_regular_file(scratch / "none", 100).error().code == std::errc::no_such_file_or_directory);
  const std::string file = scratch.write("f", "four");
  CHECK(read_regular_file(file, 4) == "four");
  CHECK(read_regular_file(file, 3).error().code == std::errc::file_too_large);
}

TEST_CASE("a secret file reports its permissions") {
  const ScratchDirectory scratch;
  const std::string file = scratch.write("f", "secret");
  std::filesystem::permissions(file, std::filesystem::perms::owner_read);
  CHECK((SecretFile::read(file, 100)->mode() & 0777U) == 0400);
}

TEST_CASE("each call that fails while a file is read is an error, and leaves no file open") {
  const ScratchDirectory scratch;
  const std::string file = scratch.write("f", "text");
  const auto whole = [&](FileLayer& layer) {
    const auto read = read_file(file, 100, layer);
    return read ? std::error_code{} : read.error().code;
  };
  const auto regular = [&](FileLayer& layer) {
    const auto read = read_regular_file(file, 100, layer);
    return read ? std::error_code{} : read.error().code;
  };
  const auto secret = [&](FileLayer& layer) {
    const auto read = SecretFile::read(file, 100, layer);
    return read ? std::error_code{} : read.error().code;
  };
  const auto check_calls = [](const auto& read) {
    int failures = 0;
    for (;; ++failures) {
      FailingFiles files;
      files.fail_after(failures);
      const std::error_code error = read(files);
      CHECK(files.open_files() == 0);
      if (!files.has_failed()) break;
      CHECK(error == FailingFiles::kError);
    }
    return failures;
  };
  CHECK(check_calls(whole) == 3);    // open, read, read of the end
  CHECK(check_calls(regular) == 4);  // the same and the mode
  CHECK(check_calls(secret) == 4);
}
