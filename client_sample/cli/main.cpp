// talus-client: fetches a chunk, a column, a flight or a map from a running server.
#include <talus/build_version.h>
#include <talus/files/standard_descriptors.h>

#include "program.h"

int main(int argc, char** argv) {
  talus::files::open_closed_standard_descriptors();
  return talus::cli::run_program(argc, argv, talus::kBuildVersion);
}
