// Detects that servers of a world have different states. Each batch reports a revision of its server and the
// state hash S at that revision. A server that reads a different S for a revision that it had itself has
// found a fault: one of the two states is wrong.
//
// Neither can know which. So each server reports its S for that revision in the log, and after kVoting the
// largest group counts: servers with another S take themselves out. If two groups are equally large, the
// right state is unknown, and both reject edits until another server reports or an operator acts.
//
// S is a sum, so a wrong state keeps the same difference while edits elsewhere go on: servers are grouped by
// their difference from this one at the last revision that they reported. All servers pass through the same
// revisions, so one that reports a revision between those of this server has another state too, with an
// unknown difference. Servers are counted once, regardless of restarts.
//
// Pure; for one thread.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <set>
#include <string>

#include <talus/edits/state_hash.h>

namespace talus::server::cluster {

class StateComparison {
 public:
  using TimePoint = std::chrono::steady_clock::time_point;

  static constexpr std::chrono::seconds kVoting{2};
  /// Number of states remembered; reports about older ones cannot be compared.
  static constexpr std::size_t kRemembered = 65'536;
  static constexpr std::size_t kMaxVoters = 256;

  struct Claim {
    std::uint64_t publisher = 0;
    std::uint64_t revision = 0;
    edits::StateHash hash;
  };
  enum class Verdict : std::uint8_t {
    same,       // no other state, or only servers known to be wrong
    voting,     // another state exists, and the vote is not over
    undecided,  // equal votes for two states
    wrong,      // most servers have another state; permanent
  };

  explicit StateComparison(std::uint64_t self) : self_{self} {}

  /// This server has this state after a message.
  void stands(std::uint64_t revision, edits::StateHash hash);

  /// A report of another server, or of this one, is in the log. Returns the report that this server must
  /// publish now, if any.
  [[nodiscard]] std::optional<Claim> heard(const Claim& claim, TimePoint now);

  [[nodiscard]] Verdict judge(TimePoint now);
  /// One line on the last fault found; may be empty.
  [[nodiscard]] const std::string& what() const { return what_; }

 private:
  struct Vote {
    /// From this server's state; nullopt if this server never had that revision.
    std::optional<edits::StateHash> difference;
    std::uint64_t publisher = 0;
    std::uint64_t revision = 0;
  };
  struct Dispute {
    std::uint64_t revision = 0;
    TimePoint since;
    std::map<std::uint32_t, Vote> votes;  // by server
  };

  [[nodiscard]] const edits::StateHash* own_at(std::uint64_t revision) const;

  const std::uint64_t self_;
  struct State {
    std::uint64_t revision = 0;
    edits::StateHash hash;
  };
  std::deque<State> states_;  // by ascending revision
  std::optional<Dispute> dispute_;
  std::set<std::uint64_t> wrong_;  // publishers, because a restarted server may have taken another's store
  bool is_wrong_ = false;
  std::string what_;
};

}  // namespace talus::server::cluster
