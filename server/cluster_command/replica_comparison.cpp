#include "cluster_command/replica_comparison.h"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <thread>

#include <fmt/format.h>

#include "jetstream/stream_admin.h"

namespace talus::server::cluster_tool {
namespace {

using namespace std::chrono_literals;

constexpr auto kReplicaPatience = 500ms;
constexpr auto kLagPatience = 2s;
// One replica of five is missed once in 40,000 times, and the next message asks again.
constexpr std::size_t kTimesAsked = 48;

class ReplicaComparison {
 public:
  ReplicaComparison(std::span<const std::shared_ptr<jetstream::Connection>> connections, const Target& target)
      : connections_{connections}, target_{target} {}

  tl::expected<std::vector<std::string>, std::string> lines() {
    const auto state = leader_state();
    if (!state) return tl::unexpected{std::string{"the leader says nothing"}};
    std::vector<std::string> lines;
    // The newest, and ever fewer of the older ones.
    for (std::uint64_t back = 0; state->first + back <= state->last; back = back == 0 ? 1 : back * 2) {
      if (refusal_) break;
      if (auto line = difference_at(state->last - back)) lines.push_back(*std::move(line));
    }
    if (auto line = beyond_the_end()) lines.push_back(*std::move(line));
    if (refusal_) return tl::unexpected{*refusal_};
    return lines;
  }

 private:
  /// What the answers to a question are.
  struct Answers {
    std::set<std::string> texts;
    std::uint64_t newest = 0;
    bool missing = false;  // for one at least
  };

  Answers ask(const std::string& question) {
    Answers answers;
    for (std::size_t i = 0; i < kTimesAsked; ++i) {
      const auto reply = connections_[i % connections_.size()]->request(target_.names.direct_get(), question,
                                                                        kReplicaPatience);
      if (!reply && reply.error().kind == StreamFailure::Kind::refused) {
        refusal_ = reply.error().reason;
        break;
      }
      if (!reply) continue;
      const jetstream::Arrived message{reply->get()};
      if (message.status() != 0) {
        answers.missing = true;
        continue;
      }
      answers.texts.emplace(message.text());
      answers.newest = std::max(answers.newest, message.sequence());
    }
    return answers;
  }

  std::optional<StreamState> leader_state() {
    auto info = ask_stream_info(*connections_.front(), target_.names);
    if (!info) return std::nullopt;
    return std::move(info->state);
  }

  [[nodiscard]] bool is_too_late() const { return std::chrono::steady_clock::now() > until_; }

  std::optional<std::string> difference_at(std::uint64_t sequence) {
    for (;;) {
      const Answers answers = ask(jetstream::StreamNames::by_number(sequence));
      if (answers.texts.size() > 1) {
        return fmt::format("message {} is not the same at all of them", sequence);
      }
      if (!answers.missing) return std::nullopt;
      const auto state = leader_state();
      if (!state || state->first > sequence) return std::nullopt;  // it is kept no more
      if (is_too_late()) return fmt::format("not all of them have message {}", sequence);
      std::this_thread::sleep_for(kBetweenTries);
    }
  }

  std::optional<std::string> beyond_the_end() {
    const std::uint64_t newest = ask(jetstream::StreamNames::newest_of(target_.names.log)).newest;
    for (;;) {
      const auto state = leader_state();
      if (!state || state->last >= newest) return std::nullopt;
      if (is_too_late())
        return fmt::format("one has message {}, and the leader ends at {}", newest, state->last);
      std::this_thread::sleep_for(kBetweenTries);
    }
  }

  std::span<const std::shared_ptr<jetstream::Connection>> connections_;
  const Target& target_;
  std::optional<std::string> refusal_;
  const std::chrono::steady_clock::time_point until_ = std::chrono::steady_clock::now() + kLagPatience;
};

}  // namespace

tl::expected<std::vector<std::string>, std::string> compare_replicas(
    std::span<const std::shared_ptr<jetstream::Connection>> connections, const Target& target) {
  return ReplicaComparison{connections, target}.lines();
}

}  // namespace talus::server::cluster_tool
