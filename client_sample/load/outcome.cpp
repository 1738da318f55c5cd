#include "outcome.h"

namespace talus::load {

Tally Outcome::players() const {
  Tally sum;
  for (std::size_t role = 0; role < kRoles; ++role) {
    if (is_player(static_cast<Role>(role))) sum.merge(tallies[role]);
  }
  return sum;
}

Tally Outcome::all() const {
  Tally sum;
  for (const Tally& tally : tallies) sum.merge(tally);
  return sum;
}

}  // namespace talus::load
