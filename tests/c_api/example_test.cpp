// The program of the README.
#include <catch2/catch.hpp>

#include "server_process.h"

using namespace talus::e2e;

TEST_CASE("the example in C prints the chunks around the spawn") {
  const ServerProcess server;
  const ProgramResult ended = run_program(TALUS_FLY_PATH, {"127.0.0.1", std::to_string(server.port())});
  INFO(ended.err);
  CHECK(ended.status == 0);
  CHECK_THAT(ended.out, Catch::Contains("ground at spawn: ") && Catch::Contains(": 2601 chunks, "));
}

TEST_CASE("the example in C says in one line why it ended") {
  const ProgramResult ended = run_program(TALUS_FLY_PATH, {"127.0.0.1", "1"});
  CHECK(ended.status == 1);
  CHECK(ended.err == "127.0.0.1:1: no server answers there: Connection refused\n");
}
