// Runs a program as a shell does.
#pragma once

#include <stdio.h>
#include <sys/wait.h>

#include <algorithm>
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

[[nodiscard]] inline Outcome run_in_shell(const std::string& program, const std::string& arguments) {
  const ScratchDirectory scratch;
  const std::string command = "'" + program + "' " + arguments + " 2>'" + (scratch / "errors").string() + "'";
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

/// Checks that the program printed one line, which says what is wrong.
inline void check_refusal(const Outcome& outcome, const std::string& program, int exit_code,
                          const std::string& part) {
  INFO(outcome.output << outcome.errors);
  CHECK(outcome.exit_code == exit_code);
  CHECK(outcome.output.empty());
  CHECK(std::count(outcome.errors.begin(), outcome.errors.end(), '\n') == 1);
  CHECK_THAT(outcome.errors, Catch::StartsWith(program));
  CHECK_THAT(outcome.errors, Catch::Contains(part));
}

}  // namespace talus::test
