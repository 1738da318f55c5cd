#include "edits/edit_turns.h"

namespace talus::server {
namespace {

/// What an edit costs beside its voxels.
constexpr std::uint64_t kEdit = 64;

}  // namespace

void EditTurns::enter(FlowId flow, ClientId session, std::size_t voxels) {
  FairOrder<ClientId>& sessions = sessions_[flow];
  const auto before = sessions.next_cost();
  sessions.enter(session, kEdit + voxels);
  // The flow waits for the piece that goes next of its own.
  if (sessions.next_cost() != before) flows_.enter(flow, *sessions.next_cost());
  ++entered_;
}

std::optional<ClientId> EditTurns::next() {
  const auto flow = flows_.next();
  if (!flow) return std::nullopt;
  const auto sessions = sessions_.find(*flow);
  const auto session = sessions->second.next();
  if (const auto cost = sessions->second.next_cost()) {
    flows_.enter(*flow, *cost);
  } else {
    sessions_.erase(sessions);
  }
  --entered_;
  return session;
}

}  // namespace talus::server
