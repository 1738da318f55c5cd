// Whether the servers of a world have the same state. Each batch says at which revision its server stood, and
// with which S. Who hears another S for a revision at which it stood itself has found a fault: one of the two
// has a wrong state.
//
// Neither can know which. So each says in the log what it had at that revision, and after kVoting most of
// them count: who has another S than the largest group takes itself out. Where two groups are the same size
// nobody knows, and all of both take no edits until somebody else says what it had, or a person acts: what
// one of them would answer is wrong.
//
// S is a sum, so a wrong state stays wrong by the same difference while edits elsewhere go on: what counts is
// a server's difference from this one, at whichever revision it spoke last. All stand at the ends of the same
// messages, so who stood at a revision between those of this server has another state too, of a difference
// that nobody knows. Servers count, however often they are started.
//
// Pure; of one thread.
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
  /// States that are remembered: what others say of older ones cannot be compared.
  static constexpr std::size_t kRemembered = 65'536;
  static constexpr std::size_t kMostVoters = 256;

  struct Claim {
    std::uint64_t publisher = 0;
    std::uint64_t revision = 0;
    edits::StateHash hash;
  };
  enum class Verdict : std::uint8_t {
    same,       // nobody has another state; or who had is known to be wrong
    voting,     // somebody has, and it is not known yet who is right
    undecided,  // as many say this as say that
    wrong,      // most have another state than this server. It stays so
  };

  explicit StateComparison(std::uint64_t self) : self_{self} {}

  /// Where this server stands, at the end of a message.
  void stands(std::uint64_t revision, edits::StateHash hash);

  /// In the log is what another server says, or this one. Returns what this server is to say in the log now,
  /// if anything.
  [[nodiscard]] std::optional<Claim> heard(const Claim& claim, TimePoint now);

  [[nodiscard]] Verdict judge(TimePoint now);
  /// One line, of the last fault that was found; empty: none was.
  [[nodiscard]] const std::string& what() const { return what_; }

 private:
  struct Vote {
    /// From this server's; none: it stood where this server never did.
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
  std::deque<State> states_;  // by rising revision
  std::optional<Dispute> dispute_;
  std::set<std::uint64_t> wrong_;  // publishers: a server that starts again may have taken another's store
  bool is_wrong_ = false;
  std::string what_;
};

}  // namespace talus::server::cluster
