// When a server's messages are sent, and what is in them.
#include "cluster/publisher.h"

#include <algorithm>
#include <atomic>

#include <catch2/catch.hpp>

#include "cluster/message_pace.h"
#include "runtime/manual_clock.h"

namespace talus::server::cluster {
namespace {

using namespace std::chrono_literals;
using TimePoint = std::chrono::steady_clock::time_point;

constexpr store::StoreIdentity kOwnStore{{1, 2}, {3, 4}};

/// Acknowledges when it is told to, and takes no message of more than `limit` bytes.
class SlowStream final : public LogStream {
 public:
  explicit SlowStream(std::size_t limit = kMaxMessageBytes) : limit_{limit} {}

  struct PublishedMessage {
    TimePoint at;
    std::size_t entries = 0;
  };

  tl::expected<std::uint64_t, StreamFailure> publish(std::span<const std::byte> message) override {
    if (breaks_.exchange(false)) {
      return tl::unexpected{StreamFailure{StreamFailure::Kind::unavailable, "the connection broke"}};
    }
    if (message.size() > limit_)
      return tl::unexpected{StreamFailure{StreamFailure::Kind::too_large, "limit"}};
    const auto now = std::chrono::steady_clock::now();
    const auto batch = decode_batch(message, kOwnStore);
    std::unique_lock lock{mutex_};
    published_.push_back({now, batch ? batch->entries.size() : 0});
    changed_.notify_all();
    changed_.wait(lock, [&] { return stopped_ || acknowledged_ >= published_.size(); });
    return published_.size();
  }
  tl::expected<std::optional<StreamMessage>, StreamFailure> next(std::uint64_t /*after*/,
                                                                 TimePoint /*until*/) override {
    return std::nullopt;
  }
  tl::expected<StreamState, StreamFailure> state() override { return StreamState{}; }
  tl::expected<std::int64_t, StreamFailure> time_of(std::uint64_t /*sequence*/) override { return 0; }
  void wake() override {}
  void stop() override {
    const std::lock_guard lock{mutex_};
    stopped_ = true;
    changed_.notify_all();
  }

  /// The message of that number, from 1 on; waits for it.
  PublishedMessage await(std::size_t number) {
    std::unique_lock lock{mutex_};
    changed_.wait(lock, [&] { return published_.size() >= number; });
    return published_[number - 1];
  }
  /// The next attempt to publish has an unknown outcome.
  void break_once() { breaks_ = true; }
  void acknowledge(std::size_t number) {
    const std::lock_guard lock{mutex_};
    acknowledged_ = number;
    changed_.notify_all();
  }

 private:
  const std::size_t limit_;
  std::atomic<bool> breaks_{false};
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<PublishedMessage> published_;
  std::size_t acknowledged_ = 0;
  bool stopped_ = false;
};

TEST_CASE("a message waits after another if they have many entries, and is sent at once if few") {
  constexpr std::size_t kFew = MessagePace::kFewEntries;
  const TimePoint now{5s};
  const auto next_at = [&](std::size_t sent, std::size_t waiting) {
    MessagePace pace;
    pace.sent(now, sent);
    return pace.next_at(waiting);
  };
  CHECK(next_at(kFew, 1) == now + MessagePace::kLongest);
  CHECK(next_at(1, kFew) == now + MessagePace::kLongest);
  CHECK(next_at(kFew - 1, 1) == now);
  CHECK(next_at(kFew, 0) == now);
}

TEST_CASE("messages are apart by some times what acknowledgements take, and never by more than the longest") {
  MessagePace pace;
  const auto after = [&](std::chrono::steady_clock::duration took) {
    for (int i = 0; i < 200; ++i) pace.acknowledged(took);
    return pace.now();
  };
  const auto is_about = [](auto a, auto b) { return a < b + 1us && a > b - 1us; };
  CHECK(is_about(after(250us), MessagePace::kAcknowledgements * 250us));
  CHECK(is_about(after(10s), std::chrono::steady_clock::duration{MessagePace::kLongest}));
  // One that was stuck is forgotten after a few that were not.
  CHECK(is_about(after(250us), MessagePace::kAcknowledgements * 250us));
  pace.acknowledged(10s);
  CHECK(pace.now() < 1500us);
}

TEST_CASE("edits that come while a message is in flight are in the next, when the pace allows it") {
  SlowStream stream;
  const ManualClock clock;
  Publisher publisher{{stream, clock, kOwnStore, 1, nullptr, [] { return Publisher::Stand{}; }, [] {}}};
  publisher.start();
  const auto append = [&] {
    const edits::AttachEntry entry{{1, 2}, 1, "somebody"};
    REQUIRE(publisher.append(entry, [](const auto& /*outcome*/) {}));
  };
  const TimePoint began = std::chrono::steady_clock::now();
  append();
  const auto first = stream.await(1);
  for (std::size_t i = 0; i < 10; ++i) append();
  stream.acknowledge(1);
  const auto second = stream.await(2);
  stream.stop();
  publisher.stop();
  CHECK(first.entries == 1);
  CHECK(second.entries == 10);
  CHECK(second.at - began >=
        MessagePace::kLongest * 7 / 8);  // one acknowledgement, however quick, is an eighth
}

TEST_CASE("an edit that the stream can never take is answered at once, and others go on") {
  const bool is_unknown = GENERATE(false, true);
  // Room for a batch with one short entry.
  constexpr std::size_t kShort = 60;
  SlowStream stream{encode_batch({}, nullptr, {}).size() + kShort};
  const ManualClock clock;
  Publisher publisher{{stream, clock, kOwnStore, 1, nullptr, [] { return Publisher::Stand{}; }, [] {}}};
  std::mutex mutex;
  std::condition_variable changed;
  std::vector<std::string> rejected;
  const auto append = [&](const std::string& name, std::size_t length) {
    const edits::AttachEntry entry{{1, 2}, 1, name + std::string(length, '.')};
    REQUIRE(publisher.append(entry, [&, name](const auto& outcome) {
      const std::lock_guard lock{mutex};
      const auto code = is_unknown ? EditErrorCode::unwritable : EditErrorCode::out_of_range;
      rejected.push_back(!outcome && outcome.error().code == code ? name : "?");
      changed.notify_all();
    }));
  };
  const auto await_rejected = [&] {
    std::unique_lock lock{mutex};
    changed.wait(lock, [&] { return !rejected.empty(); });
    return rejected;
  };
  if (is_unknown) {
    stream.break_once();
  } else {
    append("small", 0);
  }
  // In one message with the small one, because the thread has not started.
  append("large", 2 * kShort);
  publisher.start();
  if (!is_unknown) stream.acknowledge(1);
  CHECK(await_rejected() == std::vector<std::string>{"large"});
  append("other", 0);
  CHECK(stream.await(is_unknown ? 1 : 2).entries == 1);
  CHECK(publisher.takes());
  stream.stop();
  publisher.stop();
}

}  // namespace
}  // namespace talus::server::cluster
