#include "commands/cluster/replica_comparison.h"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include <fmt/format.h>

namespace talus::server::cluster_tool {
namespace {

using jetstream::StreamInfo;
using jetstream::StreamNames;

// One replica of three is missed once in 17,000 times, and the next request reaches it again.
constexpr int kTimesAsked = 24;
constexpr int kMaxUnansweredRequests = 3;  // consecutive requests without an answer
constexpr int kMaxPauses = 20;
constexpr std::array<std::uint64_t, 5> kMessagesBack{0, 1, 16, 256, 4096};

bool lags(const StreamInfo& info) {
  return std::ranges::any_of(info.replicas,
                             [](const auto& each) { return !each.current || each.offline || each.lag > 0; });
}

class ReplicaComparison {
 public:
  ReplicaComparison(const ReplicaQuestions& questions, const StreamNames& names)
      : questions_{questions}, names_{names} {}

  tl::expected<std::vector<std::string>, std::string> lines() {
    const auto info = leader_info();
    if (!info) return tl::unexpected{*failure_};
    const StreamState& state = info->state;
    std::vector<std::string> lines;
    for (const std::uint64_t back : kMessagesBack) {
      if (state.first + back > state.last) break;
      if (auto line = difference_at(state.last - back)) lines.push_back(*std::move(line));
      if (failure_) return tl::unexpected{*failure_};
    }
    if (auto line = beyond_the_end()) lines.push_back(*std::move(line));
    if (failure_) return tl::unexpected{*failure_};
    return lines;
  }

 private:
  /// Distinct answers to a request.
  struct Answers {
    std::set<std::string> texts;
    std::uint64_t newest = 0;
    bool missing = false;  // in at least one replica
  };

  Answers ask(const std::string& question) {
    Answers answers;
    int silent = 0;
    for (int i = 0; i < kTimesAsked && !failure_; ++i) {
      auto answer = questions_.ask(question);
      if (!answer) {
        if (++silent == kMaxUnansweredRequests) failure_ = std::move(answer.error());
        continue;
      }
      silent = 0;
      if (answer->sequence == 0) {
        answers.missing = true;
        continue;
      }
      answers.newest = std::max(answers.newest, answer->sequence);
      answers.texts.insert(std::move(answer->text));
    }
    return answers;
  }

  std::optional<std::string> difference_at(std::uint64_t sequence) {
    for (int pauses = 0;; ++pauses) {
      const Answers answers = ask(StreamNames::by_number(sequence));
      if (failure_) return std::nullopt;
      if (answers.texts.size() > 1)
        return fmt::format("message {} is not the same at all replicas", sequence);
      if (!answers.missing) return std::nullopt;
      const auto info = leader_info();
      if (!info || info->state.first > sequence) return std::nullopt;  // the stream dropped it
      if (pauses == kMaxPauses) {
        if (!lags(*info)) return fmt::format("not all replicas have message {}", sequence);
        failure_ = "one replica lags behind; retry when all are current";
        return std::nullopt;
      }
      questions_.pause();
    }
  }

  std::optional<std::string> beyond_the_end() {
    const std::uint64_t newest = ask(StreamNames::newest_of(names_.log)).newest;
    for (int pauses = 0; !failure_; ++pauses) {
      const auto info = leader_info();
      if (!info || info->state.last >= newest) return std::nullopt;
      if (pauses == kMaxPauses)
        return fmt::format("one replica has message {}, and the leader ends at {}", newest, info->state.last);
      questions_.pause();
    }
    return std::nullopt;
  }

  /// Fails without a leader, because the stream's extent is unknown then.
  std::optional<StreamInfo> leader_info() {
    auto info = questions_.info();
    if (info && !info->leader.empty()) return info;
    failure_ = info ? "the stream has no leader" : "the leader does not answer";
    return std::nullopt;
  }

  const ReplicaQuestions& questions_;
  const StreamNames& names_;
  std::optional<std::string> failure_;
};

}  // namespace

tl::expected<std::vector<std::string>, std::string> compare_replicas(const ReplicaQuestions& questions,
                                                                     const StreamNames& names) {
  return ReplicaComparison{questions, names}.lines();
}

}  // namespace talus::server::cluster_tool
