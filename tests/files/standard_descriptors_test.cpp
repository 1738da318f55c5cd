#include <talus/files/standard_descriptors.h>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>

using namespace talus::files;

namespace {

/// Where, in a process that starts with the descriptors of `closed` (bits) closed, the next file lands; -1
/// where one of the three does not do what it should.
int next_file_where_closed(int closed) {
  const ::pid_t child = ::fork();
  if (child == 0) {
    for (int descriptor = 0; descriptor < 3; ++descriptor) {
      if ((closed & (1 << descriptor)) != 0) ::close(descriptor);
    }
    open_closed_standard_descriptors();
    char byte = 'x';
    if ((closed & 1) != 0 && ::read(STDIN_FILENO, &byte, 1) != 0) ::_exit(255);
    if ((closed & 2) != 0 && ::write(STDOUT_FILENO, &byte, 1) != -1) ::_exit(255);
    if ((closed & 4) != 0 && ::write(STDERR_FILENO, &byte, 1) != 1) ::_exit(255);
    ::_exit(::open("/", O_RDONLY));
  }
  int status = 0;
  if (child == -1 || ::waitpid(child, &status, 0) != child || !WIFEXITED(status)) return -1;
  return WEXITSTATUS(status) == 255 ? -1 : WEXITSTATUS(status);
}

}  // namespace

TEST_CASE("no file takes the place of a standard descriptor that is closed") {
  for (int closed = 0; closed < 8; ++closed) {
    CAPTURE(closed);
    CHECK(next_file_where_closed(closed) >= 3);
  }
}
