#include <talus/build_version.h>
#include <talus/files/standard_descriptors.h>

#include "command_line.h"

int main(int argc, char** argv) {
  talus::files::open_closed_standard_descriptors();
  return talus::tools::run_talus_thesis(argc, argv, talus::kBuildVersion);
}
