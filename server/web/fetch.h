// Gets chunks and heights for a request that waits for them; a session does this for many at once.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

#include <asio/any_io_executor.hpp>
#include <asio/awaitable.hpp>
#include <tl/expected.hpp>

#include "chunks/chunk_source.h"
#include "chunks/mailbox.h"
#include "limits/flows/flow_use.h"
#include "net/timed_event.h"
#include "runtime/clock.h"

namespace talus::server::web {

enum class FetchError : std::uint8_t {
  busy,    // the generators' queue stayed full
  late,    // no answer by the deadline
  failed,  // generation failed
  gone,    // abandon() was called
};

/// On one executor. Create it by std::make_shared.
class Fetch : public std::enable_shared_from_this<Fetch> {
 public:
  /// `chunks` and `clock` outlive it. `owner` must be unique.
  Fetch(const asio::any_io_executor& executor, ChunkSource& chunks, const Clock& clock, ClientId owner,
        FlowUsePtr flow);
  /// Cancels nothing at the source: before destroying a waiting Fetch call abandon().
  ~Fetch() = default;
  Fetch(const Fetch&) = delete;
  Fetch& operator=(const Fetch&) = delete;

  /// Returns the chunks in the order of `keys`. Only one call of get(), heights() or map() at a time.
  [[nodiscard]] asio::awaitable<tl::expected<std::vector<EncodedChunkPtr>, FetchError>> get(
      std::vector<ChunkKey> keys, Version version, Clock::time_point deadline);
  [[nodiscard]] asio::awaitable<tl::expected<HeightsResult, FetchError>> heights(HeightsQuery query,
                                                                                 Clock::time_point deadline);

  /// Draws a tile of the map.
  [[nodiscard]] asio::awaitable<tl::expected<PicturePtr, FetchError>> map(const map::Tile& tile,
                                                                          Clock::time_point deadline);

  /// Ends the call in progress with FetchError::gone.
  void abandon();

 private:
  [[nodiscard]] const MailboxPtr& mailbox();
  void take_mail();
  void leave_queues();

  ChunkSource& chunks_;
  const Clock& clock_;
  const asio::any_io_executor executor_;
  const ClientId owner_;
  const FlowUsePtr flow_;
  MailboxPtr mailbox_;  // made by the first call
  TimedEvent mail_;
  std::unordered_map<ChunkKey, EncodedChunkPtr> waits_;  // null: not received yet
  std::size_t missing_ = 0;
  std::optional<std::uint64_t> ticket_;
  std::uint64_t last_ticket_ = 0;
  std::optional<HeightsResult> heights_;
  bool failed_ = false;
  bool gone_ = false;
};

}  // namespace talus::server::web
