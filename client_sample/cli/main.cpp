// talus-client: one chunk, what there is at a column, a flight, or a map, from a running server.
#include "program.h"

int main(int argc, char** argv) {
  return talus::cli::run_program(argc, argv);
}
