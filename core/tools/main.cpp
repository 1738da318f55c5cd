#include "command_line.h"

int main(int argc, char** argv) {
  return talus::tools::run_command_line(argc, argv, TALUS_VERSION);
}
