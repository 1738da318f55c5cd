// An accepted connection of the HTTP port: serves its requests, and becomes a session if it asks for a
// WebSocket.
#pragma once

#include "net/accepted_connection.h"
#include "web/web_context.h"

namespace talus::server::web {

/// Callable from any thread.
void start_connection(AcceptedConnection accepted, const WebContextPtr& context);

}  // namespace talus::server::web
