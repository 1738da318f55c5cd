// How the programs show a token.
#include <algorithm>
#include <catch2/catch.hpp>

#include "scratch_directory.h"
#include "server_process.h"

using namespace talus::e2e;

TEST_CASE(
    "talus-client shows the token of a file or a variable, and says what the server says of a wrong one") {
  const ScratchDirectory scratch;
  const std::string secret = scratch.write("secret", "0123456789abcdef\n");
  const ServerProcess server{{{"TALUS_ACCESS_SECRET_FILE", secret}}};
  const auto get = [&](std::vector<std::string> flags, const Settings& settings = {}) {
    flags.insert(flags.end(),
                 {"--connect", "127.0.0.1:" + std::to_string(server.port()), "get", "0", "0", "0"});
    return run_program(TALUS_CLIENT_PATH, flags, settings);
  };
  CHECK(get({"--token-file", secret}).status == 0);
  CHECK(get({}, {{"TALUS_TOKEN", "0123456789abcdef"}}).status == 0);
  CHECK(get({}, {{"TALUS_TOKEN_FILE", secret}}).status == 0);
  const ProgramResult missing = get({});
  CHECK(missing.status == 1);
  CHECK_THAT(missing.err, Catch::Contains("this server asks for a token"));
  CHECK_THAT(get({}, {{"TALUS_TOKEN", "guess"}}).err, Catch::Contains("the token is not accepted"));
}
