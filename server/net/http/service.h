// What all HTTP connections of a port share.
#pragma once

#include <chrono>

#include "net/http/request_parser.h"
#include "runtime/clock.h"
#include "runtime/log/logger.h"

namespace talus::server::http {

/// What connections share; outlives them.
struct Service {
  const Clock& clock;
  Logger log;
  RequestBounds bounds{};
  std::chrono::milliseconds idle_timeout{5000};      // from a response to the next request's first byte
  std::chrono::milliseconds request_timeout{5000};   // from there, or the connection's begin, to all of it
  std::chrono::milliseconds response_timeout{5000};  // to take a response
};

}  // namespace talus::server::http
