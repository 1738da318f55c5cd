// Settings shared by all HTTP connections of a port.
#pragma once

#include <chrono>

#include "net/http/request_parser.h"
#include "runtime/clock.h"
#include "runtime/log/logger.h"

namespace talus::server::http {

/// Outlives the connections.
struct Service {
  const Clock& clock;
  Logger log;
  RequestBounds bounds{};
  std::chrono::milliseconds idle_timeout{5000};      // from a response to the first byte of the next request
  std::chrono::milliseconds request_timeout{5000};   // from there, or the connection's start, to its end
  std::chrono::milliseconds response_timeout{5000};  // without progress of a write
};

}  // namespace talus::server::http
