// One client's conversation: messages in, frames out. The state machine of PROTOCOL.md.
//
// Knows no socket, no thread and no timer: net/connection.h feeds it, and calls it from one thread at a time.
// Only rates go by the clock, which is passed in, and a token when it comes. What it holds is bounded by
// Limits, whatever the client sends.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include <talus/protocol/frame.h>
#include <talus/protocol/message.h>

#include "config/config.h"
#include "generation/chunk_service.h"
#include "memory/memory_budget.h"
#include "metrics/metrics.h"
#include "rates/rates.h"
#include "session/handshake.h"
#include "session/request_book.h"
#include "session/world_info.h"
#include "stream/area_of_interest.h"
#include "stream/credit.h"
#include "stream/outbox.h"
#include "stream/view_stream.h"

namespace talus::server {

/// What sessions share; outlives them.
struct SessionContext {
  const Limits& limits;
  const WorldInfo& world;
  ChunkService& chunks;
  Metrics& metrics;
  const AccessControl& access;
  const RateLimits& rates = kUnlimited;
};

class Session {
 public:
  /// Chunks of the View generated or waiting to be sent at once: few, so that a moved View soon counts.
  static constexpr std::size_t kViewWindow = 64;
  /// Chunks of this session that wait for a generator at once.
  static constexpr std::size_t kServiceWindow = 128;
  /// Bytes of control frames above which no Column is added: they need no credit.
  static constexpr std::size_t kColumnBytes = std::size_t{16} * 1024;
  /// Views of other chunks that may come between two looks; with more, all that was sent is sent again.
  static constexpr std::size_t kUnseenViews = 8;
  /// Chunks that a client may say it knows; those beyond are sent.
  static constexpr std::size_t kKnownChunks = 8192;
  /// What a chunk that waits for a generator is reckoned to cost, until a larger one has come.
  static constexpr std::size_t kExpectedChunkBytes = 4096;

  /// What one costs that says and wants nothing, its connection and coroutines included.
  static constexpr std::size_t kIdleBytes = std::size_t{32} * 1024;

  using Clock = std::chrono::steady_clock;

  /// `address` has the rates that it shares with others; null: none.
  explicit Session(const SessionContext& context, AddressBucketsPtr address = nullptr)
      : context_{context},
        rates_{context.rates, std::move(address), context.metrics},
        memory_{context.chunks.memory(), MemoryUse::sessions} {}

  /// `client` hands answers back to chunk_ready() and heights_ready() on the session's own thread.
  void attach(ChunkClientPtr client) { client_ = std::move(client); }

  // ---- what happens to it
  /// A whole frame, as FrameReader gives it.
  void receive(std::span<const std::byte> frame, Clock::time_point now = Clock::now());
  void broken_frame(const protocol::FrameError& error);
  void timed_out(std::string_view text);
  void token_expired();
  void chunk_ready(ChunkKey key, const ChunkAnswer& answer);
  void heights_ready(std::uint64_t ticket, const HeightsAnswer& answer);
  /// Says GoAway, forgets the View, takes no more requests, and closes when those it has are answered.
  void go_away(std::string_view reason, std::uint32_t retry_after_ms);
  /// Leaves every queue; the connection is gone.
  void abandon();

  /// Whether a View came that apply_view() has not looked at.
  [[nodiscard]] bool view_waits() const { return next_view_.has_value(); }
  void apply_view();
  /// Takes up as much work as the windows allow. Call it after anything above.
  void pump();
  /// Whether the generators' queue was full: pump() again in a while.
  [[nodiscard]] bool refused() const { return refused_; }

  // ---- what it has to say
  /// When something may be written, all other things equal: by `now` at once, later where a rate holds the
  /// chunks, never (max) where nothing waits or the client gives no credit.
  [[nodiscard]] Clock::time_point sendable_at(Clock::time_point now = Clock::now());
  /// Frames to write now, one after the other: `enough_bytes` and at most one frame more.
  /// Chunks of `shared_from` bytes and more are not copied.
  [[nodiscard]] Output take_output(std::size_t enough_bytes, Clock::time_point now = Clock::now(),
                                   std::size_t shared_from = Output::kCopyAll);
  /// What was taken is written, and its memory free.
  void written() {
    writing_bytes_ = 0;
    note_memory();
  }
  /// Bytes that wait and that the client did not have to give credit for; above the limit, read no more.
  [[nodiscard]] std::size_t queued_bytes() const {
    return outbox_.control_bytes() + requests_.heights_bytes();
  }

  /// Chunks that the client says it holds and that its View waits for.
  [[nodiscard]] std::size_t known_chunks() const { return known_.size(); }

  [[nodiscard]] bool greeted() const { return greeting_.has_value(); }
  [[nodiscard]] const std::optional<Greeting>& greeting() const { return greeting_; }
  /// What is sendable now is all that ever will be: write it and close.
  [[nodiscard]] bool closing() const { return closing_ || (going_away_ && requests_.empty()); }
  /// Why, for the log; empty where the client did nothing wrong.
  [[nodiscard]] const std::string& failure() const { return failure_; }

 private:
  /// Who of this session waits for a chunk.
  struct Awaited {
    Clock::time_point since = Clock::now();
    bool view = false;
    std::vector<std::uint32_t> requests;
  };

  void on(const wire::Hello& hello);
  void on(const wire::View& view);
  void on(const wire::GetChunks& get);
  void on(const wire::ChunkRequest& request);
  void on(const wire::Cancel& cancel);
  void on(const wire::GetHeights& get);
  void on(const wire::Credit& credit);
  void on(const wire::Edit& edit);
  void on(const wire::Ping& ping);

  /// `why` is added for the log alone.
  void fail(wire::ErrorCode code, std::string_view text, std::uint32_t retry_after_ms = 0,
            std::string_view why = {});
  void refuse(std::uint32_t request_id, wire::ErrorCode code, std::string_view text,
              std::uint32_t retry_after_ms = 0);
  [[nodiscard]] bool admit(std::uint32_t id);
  /// Whether the rates allow one request more; where not, it is refused here. `id` 0: it has none.
  [[nodiscard]] bool within_rates(std::uint32_t id);
  void take_up_work();
  void note_memory();
  void pass_over(const View& view);
  void note_known(const wire::KnownChunk& chunk);
  /// Whether one more chunk may come to wait for the client: those under way will, too.
  [[nodiscard]] bool has_room_for_chunk() const;
  void drop_from_view(const std::vector<ChunkKey>& keys);
  /// The chunk if it is at hand.
  [[nodiscard]] EncodedChunkPtr find(ChunkKey key);

  void start_request(std::uint32_t id);
  [[nodiscard]] bool start_view_chunk(ChunkKey key);
  /// Where the chunk is known to be uniform: says so, with all that is uniform in its column and still
  /// wanted.
  [[nodiscard]] bool answer_by_column(ChunkKey key);
  /// Where the client knows the chunk, and it is still the same: says so instead of sending it.
  [[nodiscard]] bool confirm_known(ChunkKey key, ContentHash hash);
  /// The View does not wait for the chunk any more; false where it did not.
  bool give_up_for_view(ChunkKey key);
  /// The entry of those who wait for the chunk; null where the queue is full.
  [[nodiscard]] Awaited* await(ChunkKey key);
  void stop_awaiting(ChunkKey key, const Awaited& awaited);
  void answer_request(std::uint32_t id, ChunkAnswer answer);
  void answer_view(ChunkKey key, ChunkAnswer answer);

  SessionContext context_;
  ChunkClientPtr client_;
  std::optional<Greeting> greeting_;
  Credit credit_{0};
  Outbox outbox_;
  RequestBook requests_;
  ViewStream view_;
  std::optional<View> next_view_;
  std::vector<AreaOfInterest> unseen_views_;         // that came before next_view_ and were not looked at
  std::unordered_map<ChunkKey, ContentHash> known_;  // by the client; of chunks that its View wants
  std::unordered_map<ChunkKey, Awaited> awaited_;
  SessionRates rates_;
  MemoryShare memory_;
  Clock::time_point received_at_{};  // what is being looked at
  std::size_t expected_chunk_bytes_ = kExpectedChunkBytes;
  std::size_t writing_bytes_ = 0;  // taken last
  std::size_t found_ = 0;          // chunks at hand since pump() began
  std::uint64_t heights_asked_ = 0;
  bool refused_ = false;
  bool going_away_ = false;
  bool closing_ = false;
  std::string failure_;
};

}  // namespace talus::server
