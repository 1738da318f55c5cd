// Tells a balancer if it should send players here, and why not.
#pragma once

#include <optional>
#include <string>

#include "admin/operators_page.h"
#include "cluster/cluster_log.h"
#include "edits/local_log.h"
#include "limits/memory/memory_budget.h"

namespace talus::server {

/// That edits are not taken or wait, and why; empty if they are taken.
[[nodiscard]] std::string edits_trouble(const std::optional<std::string>& read_only,
                                        const std::string& disk_wait);

/// `shared` and `own` are the status of the log; null if it is the other kind, both if edits are not stored.
[[nodiscard]] Readiness readiness_of(bool draining, const cluster::ClusterLog::State* shared,
                                     const LocalLog::State* own, const MemoryBudget& memory);

}  // namespace talus::server
