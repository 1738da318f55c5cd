// Tells a balancer if it should send players here, and why not.
#pragma once

#include "admin/operators_page.h"
#include "cluster/cluster_log.h"
#include "limits/memory/memory_budget.h"

namespace talus::server {

/// `log` is the status of a shared log; null without one.
[[nodiscard]] Readiness readiness_of(bool draining, const cluster::ClusterLog::State* log,
                                     const MemoryBudget& memory);

}  // namespace talus::server
