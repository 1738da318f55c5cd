// Neither a killed process nor a full disk loses a committed edit, or leaves half of one.
#include <talus/saves/save.h>

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include <catch2/catch.hpp>

#include "failing_disk.h"
#include "saved_land.h"
#include "scratch_directory.h"

using namespace talus;
using saves::Save;

namespace {

/// An edit of many chunks, another each time: half of it would have another hash.
edits::Edit edit_number(std::int64_t number) {
  return filled({-40, 100 + number, -40}, {40, 100 + number, 40}, MaterialId{256});
}

/// Opens the save, makes edits and tells `told` the revision of each that is committed. For a child process.
void edit_until_killed(const std::filesystem::path& file, int told) {
  auto save = Save::open(file);
  if (!save) _exit(2);
  local::Workspace workspace{save->world()};
  for (int i = 0; i < 3; ++i) {
    const auto number = static_cast<std::int64_t>(save->revision());
    if (!save->apply(workspace, edit_number(number)) || !save->commit()) _exit(3);
    const auto revision = static_cast<char>(save->revision());
    if (write(told, &revision, 1) != 1) _exit(4);
  }
  save = tl::unexpected{saves::SaveError{}};  // closes it
  _exit(0);
}

}  // namespace

TEST_CASE("a process killed at any write leaves every committed edit, whole") {
  const ScratchDirectory directory{ScratchDirectory::memory()};
  const std::filesystem::path fresh = directory / "fresh";
  (void)new_save(fresh);
  bool survived = false;
  for (int at = 1; !survived; ++at) {
    INFO("killed at change " << at);
    const std::filesystem::path file = directory / "game";
    std::filesystem::copy_file(fresh, file, std::filesystem::copy_options::overwrite_existing);
    int pipe_ends[2];
    REQUIRE(pipe(pipe_ends) == 0);
    const pid_t child = fork();
    REQUIRE(child >= 0);
    if (child == 0) {
      const FailingDisk disk{FailingDisk::Failure::killed, at};
      edit_until_killed(file, pipe_ends[1]);
    }
    close(pipe_ends[1]);
    char told = 0;
    while (read(pipe_ends[0], &told, 1) == 1) {
    }
    close(pipe_ends[0]);
    int status = 0;
    REQUIRE(waitpid(child, &status, 0) == child);
    survived = WIFEXITED(status);
    if (survived) REQUIRE(WEXITSTATUS(status) == 0);
    const auto save = Save::open(file);  // compares S
    INFO((save ? std::string{} : save.error().message));
    REQUIRE(save);
    CHECK(save->revision() >= static_cast<std::uint64_t>(told));
    CHECK(save->revision() <= static_cast<std::uint64_t>(told) + 1);
    if (survived) CHECK(at > 20);
    REQUIRE(at < 1'000);
  }
}

TEST_CASE("a disk that fails at any write leaves the save as it was, and the next commit succeeds") {
  const ScratchDirectory directory{ScratchDirectory::memory()};
  const auto failure = GENERATE(FailingDisk::Failure::full, FailingDisk::Failure::broken);
  bool succeeded = false;
  for (int at = 1; !succeeded; ++at) {
    INFO("fails from change " << at);
    std::filesystem::remove(directory / "game");
    { (void)new_save(directory / "game"); }
    const FailingDisk disk{failure, 0};
    {
      auto save = Save::open(directory / "game");
      REQUIRE(save);
      local::Workspace workspace{save->world()};
      REQUIRE(save->apply(workspace, edit_number(0)));
      const FailingDisk failing{failure, at};
      const auto kept = save->commit();
      succeeded = kept.has_value();
      if (!kept) {
        CHECK(save->has_changes());
        CHECK((kept.error().kind == saves::SaveError::Kind::full) == (failure == FailingDisk::Failure::full));
        FailingDisk::mend();
        const auto again = save->commit();
        INFO((again ? std::string{} : again.error().message));
        CHECK(again);
      }
    }
    const auto save = Save::open(directory / "game");
    INFO((save ? std::string{} : save.error().message));
    REQUIRE(save);
    CHECK(save->revision() == 1);
    REQUIRE(at < 1'000);
  }
}
