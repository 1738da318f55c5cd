// What a talus_client is.
#pragma once

#include <memory>

#include <talus.h>

#include "chunk.h"
#include "error_line.h"
#include "session.h"

struct talus_client {
  talus::c_api::ErrorLine error;
  // The world by the events that were polled, not by those that wait.
  std::shared_ptr<const talus::client::WorldInfo> world;
  talus::c_api::QueuedEvent current;  // the last event, which the caller reads
  talus::c_api::ChunkHandle chunk;    // of that event
  std::unique_ptr<talus::c_api::Session> session;
};
