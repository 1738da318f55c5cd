// Whose edit goes next. Flows have equal shares by what their edits cost, and so have the sessions of a flow.
// So a player who digs alone does not wait for all that others have sent, however many flood, and nobody gets
// more by opening more connections.
#pragma once

#include <cstddef>
#include <optional>
#include <unordered_map>

#include "chunks/mailbox.h"
#include "limits/flows/fair_order.h"
#include "limits/flows/flow_ids.h"

namespace talus::server {

/// For one thread.
class EditTurns {
 public:
  /// The session has an edit that may go, which costs as much as so many voxels. REQUIRES: it is not entered.
  void enter(FlowId flow, ClientId session, std::size_t voxels);
  /// Whose edit goes now; it is entered no more.
  [[nodiscard]] std::optional<ClientId> next();

  /// Nobody wants anything, so nobody owes anything from here on. Not at once when the last that is entered
  /// goes: it mostly enters again, and others with debts would come back without. REQUIRES: none is entered.
  void rest() { flows_ = {}; }

  /// Sessions that are entered.
  [[nodiscard]] std::size_t entered() const { return entered_; }

 private:
  std::unordered_map<FlowId, FairOrder<ClientId>> sessions_;  // of flows that are entered
  FairOrder<FlowId> flows_;
  std::size_t entered_ = 0;
};

}  // namespace talus::server
