// What all sessions share.
#pragma once

#include "access/access_control.h"
#include "chunks/chunk_source.h"
#include "clock/clock.h"
#include "edits/edit_taker.h"
#include "flows/flow_uses.h"
#include "memory/memory_budget.h"
#include "metrics/metrics.h"
#include "rates/rates.h"
#include "session/session_limits.h"
#include "session/world_info.h"

namespace talus::server {

/// Everything outlives the sessions.
struct SessionContext {
  const SessionLimits& limits;
  const WorldInfo& world;
  ChunkSource& chunks;
  MemoryBudget& memory;
  Metrics& metrics;
  const AccessControl& access;
  const CurrentRates& rates;
  FlowUses& flows;
  const Clock& clock;
  EditTaker* edits = nullptr;  // null: nothing is stored
};

}  // namespace talus::server
