// What talus-client says and returns, against a real server.
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "server_process.h"

using namespace talus::e2e;

namespace {

ProgramResult talus_client(const ServerProcess& server, std::vector<std::string> flags) {
  flags.insert(flags.begin(), {"--connect", "127.0.0.1:" + std::to_string(server.port())});
  return run_program(TALUS_CLIENT_PATH, flags);
}

void check_refused(const ProgramResult& ended, int status, const std::string& part) {
  INFO(ended.err);
  CHECK(ended.status == status);
  CHECK(std::count(ended.err.begin(), ended.err.end(), '\n') == 1);
  CHECK_THAT(ended.err, Catch::StartsWith("talus-client: ") && Catch::Contains(part));
}

}  // namespace

TEST_CASE("talus-client: wrong use is one line and exit code 2") {
  const auto run = [](const std::vector<std::string>& flags) {
    return run_program(TALUS_CLIENT_PATH, flags);
  };
  check_refused(run({}), 2, "subcommand");
  check_refused(run({"fly", "--radius", "0"}), 2, "--radius");
  check_refused(run({"map"}), 2, "--output");
  check_refused(run({"--connect", "nowhere", "fly"}), 2, "--connect nowhere");
}

TEST_CASE("talus-client fly says in one line what the server does not allow") {
  const ServerProcess server{
      {{"TALUS_LIMITS_VIEW_HORIZONTAL_RADIUS", "16"}, {"TALUS_LIMITS_VIEW_CHUNKS", "20000"}}};
  check_refused(talus_client(server, {"fly", "--radius", "17"}), 1, "horizontal radius 17");
  check_refused(talus_client(server, {"fly", "--radius", "1", "--far", "1025"}), 1, "radius 1025");
  check_refused(talus_client(server, {"fly", "--radius", "16"}), 1, "(20000)");
}

TEST_CASE("talus-client map draws the world's last rows of chunks, and nothing beyond them") {
  const ServerProcess server;
  const std::string file =
      (std::filesystem::temp_directory_path() / ("talus-e2e-" + std::to_string(server.port()) + ".png"))
          .string();
  const auto map = [&](const std::string& center) {
    return talus_client(server, {"map", "--center", center, "--size", "64,64", "-o", file});
  };
  CHECK(map("68719476700,68719476700").status == 0);
  CHECK(map("-68719476704,-68719476704").status == 0);
  std::filesystem::remove(file);
  check_refused(map("0,68719476730"), 2, "voxel z is 68719476761");
  check_refused(map("9223372036854775807,0"), 2, "9223372036854775807");
  CHECK_FALSE(std::filesystem::exists(file));
}
