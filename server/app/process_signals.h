// Signal handling while no server handles signals.
#pragma once

namespace talus::server {

/// SIGTERM and SIGINT end the process at once with success, because no client is served. SIGHUP is ignored,
/// because there is nothing to reload. Callable from any thread at any time.
void end_at_once_on_signals();

/// Restores the default action of SIGTERM and SIGINT, for commands that do not serve clients.
void end_by_default_on_signals();

}  // namespace talus::server
