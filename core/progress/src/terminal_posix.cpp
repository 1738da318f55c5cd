#include "terminal.h"

#include <unistd.h>

namespace talus {

bool standard_error_is_terminal() {
  return ::isatty(STDERR_FILENO) == 1;
}

}  // namespace talus
