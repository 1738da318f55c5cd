// Runs talus-gen as a shell does. For programs that talus_test() gives TALUS_GEN_PATH.
#pragma once

#include <stdio.h>
#include <sys/wait.h>

#include <array>
#include <string>

#include <catch2/catch.hpp>

namespace talus::test {

struct Outcome {
  int exit_code = -1;
  std::string output;  // stdout and stderr together
};

[[nodiscard]] inline Outcome talus_gen(const std::string& arguments) {
  const std::string command = "'" TALUS_GEN_PATH "' " + arguments + " 2>&1";
  Outcome outcome;
  FILE* pipe = ::popen(command.c_str(), "r");
  REQUIRE(pipe != nullptr);
  std::array<char, 4096> buffer{};
  for (std::size_t n = 0; (n = ::fread(buffer.data(), 1, buffer.size(), pipe)) > 0;) {
    outcome.output.append(buffer.data(), n);
  }
  const int status = ::pclose(pipe);
  if (WIFEXITED(status)) outcome.exit_code = WEXITSTATUS(status);
  return outcome;
}

}  // namespace talus::test
