// The stream of a cluster in memory, with as many ends as there are servers: messages that come late, holes
// in what an end sees at first, acknowledgements that get lost, no quorum.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <random>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include "cluster/log_stream.h"

namespace talus::server::testing {

class SharedStream {
 public:
  SharedStream() = default;  // without a message
  explicit SharedStream(std::vector<std::byte> genesis) { messages_.push_back(std::move(genesis)); }

  std::uint64_t append(std::span<const std::byte> message) {
    std::uint64_t sequence = 0;
    {
      const std::lock_guard lock{mutex_};
      messages_.emplace_back(message.begin(), message.end());
      const std::int64_t now_ms = std::chrono::duration_cast<std::chrono::milliseconds>(
                                      std::chrono::system_clock::now().time_since_epoch())
                                      .count();
      times_ms_[messages_.size()] = now_ms;
      sequence = messages_.size();
    }
    changed_.notify_all();
    return sequence;
  }
  /// When it came; nothing where there is none.
  [[nodiscard]] std::optional<std::int64_t> time_of(std::uint64_t sequence) const {
    const std::lock_guard lock{mutex_};
    const auto at = times_ms_.find(sequence);
    return at == times_ms_.end() ? std::nullopt : std::optional{at->second};
  }
  void set_quorum(bool quorum) { quorum_ = quorum; }
  [[nodiscard]] bool has_quorum() const { return quorum_; }
  /// Messages before this one are not kept any more.
  void keep_from(std::uint64_t first) {
    const std::lock_guard lock{mutex_};
    first_ = first;
  }
  void make_anew() { created_ns_ = 2; }
  /// As if its hosts had lost power before so many messages reached their disks.
  void lose_end(std::size_t messages) {
    const std::lock_guard lock{mutex_};
    messages_.resize(messages_.size() - messages);
  }
  /// As if another talusd had begun it.
  void replace_first(std::vector<std::byte> genesis) {
    const std::lock_guard lock{mutex_};
    messages_.at(0) = std::move(genesis);
  }
  /// What the stream's settings say.
  void describe(std::string_view description) {
    const std::lock_guard lock{mutex_};
    enabled_ = cluster::enabled_formats(description);
  }
  void enable(cluster::EnabledFormat format) {
    const std::lock_guard lock{mutex_};
    enabled_ = {{format}, true};
  }
  /// What every publish() and next() says from now on.
  void fail_publish_as(std::optional<StreamFailure::Kind> kind) { fails_publish_ = kind; }
  void fail_next_as(std::optional<StreamFailure::Kind> kind) { fails_next_ = kind; }
  [[nodiscard]] std::optional<StreamFailure::Kind> fails_publish() const { return fails_publish_; }
  [[nodiscard]] std::optional<StreamFailure::Kind> fails_next() const { return fails_next_; }
  /// The leader says that so many messages at its end are not there.
  void say_fewer(std::uint64_t fewer) { fewer_ = fewer; }
  /// How often any end published, or tried to.
  std::atomic<std::uint64_t> attempts{0};
  /// How often any end asked the leader.
  std::atomic<std::uint64_t> asked{0};

  [[nodiscard]] StreamState state() const {
    const std::lock_guard lock{mutex_};
    return {first_, messages_.size() - fewer_, created_ns_, 0, enabled_};
  }
  [[nodiscard]] std::vector<std::vector<std::byte>> all() const {
    const std::lock_guard lock{mutex_};
    return messages_;
  }
  /// A copy of some message is stored once more, as one that was sent again and overtaken.
  void repeat_any(std::mt19937_64& random) {
    std::vector<std::byte> copy;
    {
      const std::lock_guard lock{mutex_};
      if (messages_.size() < 2) return;
      copy = messages_[1 + random() % (messages_.size() - 1)];
    }
    append(copy);
  }

  /// The message, or nothing where there is none until then.
  [[nodiscard]] tl::expected<std::optional<StreamMessage>, StreamFailure> wait_for(
      std::uint64_t sequence, LogStream::TimePoint until, const std::atomic<bool>& woken) {
    std::unique_lock lock{mutex_};
    changed_.wait_until(lock, until, [&] { return woken || messages_.size() >= sequence; });
    if (sequence < first_) {
      return tl::unexpected{StreamFailure{StreamFailure::Kind::gone, "the message is not kept any more"}};
    }
    if (messages_.size() < sequence) return std::nullopt;
    return StreamMessage{sequence, messages_[sequence - 1]};
  }
  void wake() { changed_.notify_all(); }

 private:
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<std::vector<std::byte>> messages_;
  std::map<std::uint64_t, std::int64_t> times_ms_;
  std::uint64_t first_ = 1;
  cluster::EnabledFormats enabled_;
  std::atomic<bool> quorum_{true};
  std::atomic<std::int64_t> created_ns_{1};
  std::atomic<std::uint64_t> fewer_{0};
  std::atomic<std::optional<StreamFailure::Kind>> fails_publish_{};
  std::atomic<std::optional<StreamFailure::Kind>> fails_next_{};
};

/// How often, in 256 calls.
struct StreamFaults {
  std::uint64_t lost = 0;     // a message is not stored, and not acknowledged
  std::uint64_t unacked = 0;  // it is stored, and not acknowledged
  std::uint64_t holes = 0;    // what is there is not seen yet
  std::uint64_t late_us = 0;  // that a call takes, at most
  std::uint64_t delayed = 0;  // a message is not acknowledged, and stored when the next is published
};

class StreamEnd final : public LogStream {
 public:
  StreamEnd(SharedStream& stream, std::uint64_t seed, const StreamFaults& faults = {})
      : stream_{stream}, faults_{faults}, publishing_{seed}, reading_{seed + 1} {}

  [[nodiscard]] tl::expected<std::uint64_t, StreamFailure> publish(
      std::span<const std::byte> message) override {
    ++stream_.attempts;
    delay(publishing_);
    if (const auto kind = stream_.fails_publish())
      return tl::unexpected{StreamFailure{*kind, "it is another"}};
    if (stopped_ || !stream_.has_quorum() || !connected_) return unavailable();
    if (const auto late = std::exchange(delayed_, {})) stream_.append(*late);
    const std::uint64_t fault = publishing_() % 256;
    if (fault < faults_.delayed) {
      delayed_.emplace(message.begin(), message.end());
      return unavailable();
    }
    if (fault < faults_.lost) return unavailable();
    const std::uint64_t sequence = stream_.append(message);
    if (fault < faults_.lost + faults_.unacked) return unavailable();
    return sequence;
  }
  [[nodiscard]] tl::expected<std::optional<StreamMessage>, StreamFailure> next(std::uint64_t after,
                                                                               TimePoint until) override {
    delay(reading_);
    if (const auto kind = stream_.fails_next()) return tl::unexpected{StreamFailure{*kind, "it is another"}};
    if (stopped_ || !connected_) return unavailable();
    if (reading_() % 256 < faults_.holes) return std::nullopt;
    auto message = stream_.wait_for(after + 1, until, woken_);
    woken_ = stopped_.load();
    if (const auto kind = stream_.fails_next()) return tl::unexpected{StreamFailure{*kind, "it is another"}};
    if (message && *message && alters_ == (*message)->sequence) {
      (*message)->of_leader = false;
      (*message)->bytes.back() ^= std::byte{1};
    }
    return message;
  }
  [[nodiscard]] tl::expected<StreamState, StreamFailure> state() override {
    ++stream_.asked;
    if (stopped_ || !stream_.has_quorum() || !connected_) return unavailable();
    return stream_.state();
  }
  [[nodiscard]] tl::expected<std::int64_t, StreamFailure> time_of(std::uint64_t sequence) override {
    if (stopped_ || !connected_) return unavailable();
    if (reading_() % 256 < faults_.holes) return unavailable();
    const auto time_ms = stream_.time_of(sequence);
    if (!time_ms) return unavailable();
    return *time_ms;
  }
  [[nodiscard]] StreamFigures figures() const override { return {connected_, 0, 0}; }
  void wake() override {
    woken_ = true;
    stream_.wake();
  }
  void stop() override {
    stopped_ = true;
    wake();
  }

  void ask_again() override { alters_ = 0; }

  /// The message comes altered, until it is asked for.
  void alter(std::uint64_t sequence) { alters_ = sequence; }
  void connect(bool connected) { connected_ = connected; }

 private:
  static tl::unexpected<StreamFailure> unavailable() {
    return tl::unexpected{StreamFailure{StreamFailure::Kind::unavailable, "no answer"}};
  }
  void delay(std::mt19937_64& random) const {
    if (faults_.late_us > 0)
      std::this_thread::sleep_for(std::chrono::microseconds{random() % faults_.late_us});
  }

  SharedStream& stream_;
  const StreamFaults faults_;
  std::mt19937_64 publishing_;
  std::mt19937_64 reading_;
  std::optional<std::vector<std::byte>> delayed_;
  std::atomic<bool> stopped_{false};
  std::atomic<bool> woken_{false};
  std::atomic<bool> connected_{true};
  std::atomic<std::uint64_t> alters_{0};
};

/// Opens one end after another.
inline std::function<std::unique_ptr<LogStream>()> ends_of(SharedStream& stream, std::uint64_t seed,
                                                           const StreamFaults& faults = {}) {
  return [&stream, seed, faults]() mutable { return std::make_unique<StreamEnd>(stream, ++seed, faults); };
}

}  // namespace talus::server::testing
