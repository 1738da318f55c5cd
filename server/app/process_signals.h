// What signals do while no server handles them.
#pragma once

namespace talus::server {

/// SIGTERM and SIGINT end the process at once, as done: nobody is served yet, or any more. SIGHUP does
/// nothing: there is nothing to read again. Any thread, any time.
void end_at_once_on_signals();

/// SIGTERM and SIGINT end the process as they end any other: for commands that serve nobody.
void end_by_default_on_signals();

}  // namespace talus::server
