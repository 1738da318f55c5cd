#include "talus/files/standard_descriptors.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstddef>

namespace talus::files {

void open_closed_standard_descriptors() {
  constexpr std::array kModes{O_RDONLY, O_RDONLY, O_WRONLY};
  static_assert(STDIN_FILENO == 0 && STDOUT_FILENO == 1 && STDERR_FILENO == 2);
  for (int descriptor = 0; descriptor < 3; ++descriptor) {
    if (::fcntl(descriptor, F_GETFD) != -1 || errno != EBADF) continue;
    // Takes the lowest free number, which is this one: lower ones are open by now.
    if (::open("/dev/null", kModes[static_cast<std::size_t>(descriptor)]) == -1) return;
  }
}

}  // namespace talus::files
