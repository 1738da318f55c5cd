// talusd: streams an endless world, generated on demand, to game clients.
#include "app/program.h"

int main(int argc, char** argv) {
  return talus::server::run_program(argc, argv);
}
