// Runs talus-gen as a shell does. For programs that talus_test() gives TALUS_GEN_PATH.
#pragma once

#include <stdio.h>
#include <sys/wait.h>

#include <array>
#include <string>

#include <catch2/catch.hpp>

#include "progress_lines.h"
#include "scratch_directory.h"

namespace talus::test {

struct Outcome {
  int exit_code = -1;
  std::string output;  // stdout
  std::string errors;  // stderr, without lines of progress
};

[[nodiscard]] inline Outcome talus_gen(const std::string& arguments) {
  const ScratchDirectory scratch;
  const std::string command =
      "'" TALUS_GEN_PATH "' " + arguments + " 2>'" + (scratch / "errors").string() + "'";
  Outcome outcome;
  FILE* pipe = ::popen(command.c_str(), "r");
  REQUIRE(pipe != nullptr);
  std::array<char, 4096> buffer{};
  for (std::size_t n = 0; (n = ::fread(buffer.data(), 1, buffer.size(), pipe)) > 0;) {
    outcome.output.append(buffer.data(), n);
  }
  const int status = ::pclose(pipe);
  if (WIFEXITED(status)) outcome.exit_code = WEXITSTATUS(status);
  outcome.errors = without_progress(read_whole(scratch / "errors"));
  return outcome;
}

}  // namespace talus::test
