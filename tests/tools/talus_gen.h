// Runs talus-gen. For programs that talus_test() gives TALUS_GEN_PATH.
#pragma once

#include <string>

#include "program_outcome.h"

namespace talus::test {

[[nodiscard]] inline Outcome talus_gen(const std::string& arguments) {
  return run_in_shell(TALUS_GEN_PATH, arguments);
}

}  // namespace talus::test
