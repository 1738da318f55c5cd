// The beginning of a session over a stream, and what all sessions of a server share.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "net/accepted_connection.h"
#include "net/admission.h"
#include "net/registry.h"
#include "net/session_stream.h"
#include "net/watchdog.h"
#include "player/session/session_context.h"
#include "runtime/log/logger.h"

namespace talus::server {

/// Limits of every session of a server.
struct RunnerLimits {
  std::uint32_t frame_bytes = 0;  // of one frame from the client
  std::size_t queued_bytes = 0;   // queued for the client; above this, reading pauses
  SessionTimeouts timeouts;
};

/// Shared by all runners. Objects that it refers to live as long as it does, or outlive all runners.
struct RunnerContext {
  SessionContext session;
  RunnerLimits limits;
  Registry& registry;
  Logger log;
  std::string http_place{};  // one line that says where HTTP is served, for HTTP clients of this port
};
using RunnerContextPtr = std::shared_ptr<const RunnerContext>;

/// Creates the connection's session and starts it.
void start_session(std::unique_ptr<SessionStream> stream, ConnectionInfo info, Admission::Slot slot,
                   const RunnerContextPtr& context);
void start_session(AcceptedConnection accepted, const RunnerContextPtr& context);

}  // namespace talus::server
