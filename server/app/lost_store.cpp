#include "app/lost_store.h"

#include <cstdlib>

#include "cluster/join/prepare_store.h"

namespace talus::server {

void LostStore::lose(cluster::StoreLoss how, const std::string& reason) {
  using cluster::StoreLoss;
  if (how == StoreLoss::other) {
    log_->error("cluster: {}; no edits are taken; see \"talusd store fork --help\"", reason);
    return;
  }
  if (!has_peers_) {
    log_->error(
        "cluster: {}; no edits are taken; name other servers in cluster.peers, and start this one again",
        reason);
    return;
  }
  if (how == StoreLoss::wrong_state) {
    if (const auto noted = join::want_rejoin(directory_, reason); !noted)
      log_->error("cluster: {}", noted.error());
  }
  log_->error("cluster: {}; this server ends, and takes another server's store when it is started again",
              reason);
  end();
}

void LostStore::start_again(const std::string& reason) {
  if (!wants_end_) log_->error("{}; this server ends, to be started again", reason);
  end();
}

void LostStore::end() {
  wants_end_ = true;
  if (!serving_) std::_Exit(kStartAgain);
}

}  // namespace talus::server
