#include "app/process_signals.h"

#include <csignal>
#include <cstdlib>
#include <initializer_list>

namespace talus::server {

void end_at_once_on_signals() {
  std::signal(SIGHUP, SIG_IGN);
  for (const int signal : {SIGTERM, SIGINT}) {
    std::signal(signal, [](int) { std::_Exit(0); });
  }
}

void end_by_default_on_signals() {
  for (const int signal : {SIGTERM, SIGINT}) std::signal(signal, SIG_DFL);
}

}  // namespace talus::server
