// Objects shared by all sessions.
#pragma once

#include "chunks/chunk_source.h"
#include "config/access/access_control.h"
#include "edits/edit_taker.h"
#include "limits/flows/flow_uses.h"
#include "limits/memory/memory_budget.h"
#include "limits/rates/rates.h"
#include "player/session/session_limits.h"
#include "player/session/world_info.h"
#include "runtime/clock.h"
#include "runtime/metrics/metrics.h"

namespace talus::server {

/// All of them outlive the sessions.
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
  EditTaker* edits = nullptr;  // null: no edits are stored
};

}  // namespace talus::server
