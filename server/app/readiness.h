// Whether a balancer is to send players here, and why not.
#pragma once

#include "admin/operators_page.h"
#include "cluster/cluster_log.h"
#include "limits/memory/memory_budget.h"

namespace talus::server {

/// `log` is that of a log that is shared; null: there is none.
[[nodiscard]] Readiness readiness_of(bool draining, const cluster::ClusterLog::Status* log,
                                     const MemoryBudget& memory);

}  // namespace talus::server
