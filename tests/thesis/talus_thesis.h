// Runs talus-thesis. For programs that talus_test() gives TALUS_THESIS_PATH.
#pragma once

#include <string>

#include "program_outcome.h"

namespace talus::test {

[[nodiscard]] inline Outcome talus_thesis(const std::string& arguments) {
  return run_in_shell(TALUS_THESIS_PATH, arguments);
}

}  // namespace talus::test
