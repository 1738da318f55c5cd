// The program of the README.
#include <catch2/catch.hpp>

#include "program_outcome.h"
#include "scratch_directory.h"

TEST_CASE("the example digs, and finds the hole in its save") {
  const ScratchDirectory directory;
  const auto play = [&](const std::string& more = "") {
    return talus::test::run_in_shell(TALUS_SINGLE_PLAYER_PATH, (directory / "game.talus").string() + more);
  };
  const auto first = play();
  INFO(first.output << first.errors);
  CHECK(first.exit_code == 0);
  CHECK_THAT(first.output, Catch::Contains("revision 0") && Catch::Contains("dug: 4 voxels") &&
                               Catch::Contains("saved: air there, revision 1"));
  const auto second = play();
  INFO(second.output << second.errors);
  CHECK(second.exit_code == 0);
  CHECK_THAT(second.output, Catch::Contains("revision 1") && Catch::Contains("air under the feet") &&
                                Catch::Contains("dug: 0 voxels"));
  directory.write("game.talus", "no save");
  talus::test::check_refusal(play(), "talus_save_open", 1, "is no save of Talus");
}
