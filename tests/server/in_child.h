// For tests that change the process.
#pragma once

#include <sys/wait.h>
#include <unistd.h>

namespace talus::server {

/// The value that `act` returns in a child process, 0 to 255; -1 where the child did not end by itself.
template <typename Act>
int in_child(Act&& act) {
  const pid_t child = ::fork();
  if (child == 0) ::_exit(act());
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace talus::server
