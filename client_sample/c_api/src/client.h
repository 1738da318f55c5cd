// Definition of talus_client.
#pragma once

#include <memory>

#include <talus.h>

#include "chunk.h"
#include "error_line.h"
#include "session.h"

struct talus_client {
  talus::c_api::ErrorLine error;
  // The world according to the events polled, not to queued ones.
  std::shared_ptr<const talus::client::WorldInfo> world;
  talus::c_api::QueuedEvent current;  // the last event, which the caller reads
  talus::c_api::ChunkHandle chunk;    // belongs to `current`
  std::unique_ptr<talus::c_api::Session> session;
};
