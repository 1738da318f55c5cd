// Gets chunks and heights for a request that can wait for them: what a session does for many at once.
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
  late,    // no answer within the time
  failed,  // the generator could not
  gone,    // abandon() was called
};

/// On one executor. Made with std::make_shared.
class Fetch : public std::enable_shared_from_this<Fetch> {
 public:
  /// `chunks` and `clock` outlive it. `owner` is used by nobody else.
  Fetch(const asio::any_io_executor& executor, ChunkSource& chunks, const Clock& clock, ClientId owner,
        FlowUsePtr flow);
  /// Asks the source for nothing more: whoever lets go of a Fetch that waits calls abandon().
  ~Fetch() = default;
  Fetch(const Fetch&) = delete;
  Fetch& operator=(const Fetch&) = delete;

  /// In the order of `keys`. One call at a time, as of heights().
  [[nodiscard]] asio::awaitable<tl::expected<std::vector<EncodedChunkPtr>, FetchError>> get(
      std::vector<ChunkKey> keys, Clock::time_point deadline);
  [[nodiscard]] asio::awaitable<tl::expected<HeightsFound, FetchError>> heights(HeightsQuery query,
                                                                                Clock::time_point deadline);

  /// A tile of the map.
  [[nodiscard]] asio::awaitable<tl::expected<PicturePtr, FetchError>> map(const map::Tile& tile,
                                                                          Clock::time_point deadline);

  /// Whoever waits gets FetchError::gone.
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
  MailboxPtr mailbox_;  // made with the first call
  TimedEvent mail_;
  std::unordered_map<ChunkKey, EncodedChunkPtr> waits_;  // null: not there yet
  std::size_t missing_ = 0;
  std::optional<std::uint64_t> ticket_;
  std::uint64_t last_ticket_ = 0;
  std::optional<HeightsFound> heights_;
  bool failed_ = false;
  bool gone_ = false;
};

}  // namespace talus::server::web
