// Implementation of Client: the state that outlives a connection, and the coroutines that maintain one. Held
// by shared_ptr, so that a Client may be destroyed inside its own callbacks.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include <asio/awaitable.hpp>

#include <talus/client/client.h>
#include <talus/protocol/message.h>

#include "connection.h"
#include "local_chunks.h"
#include "open_edits.h"
#include "request_pace.h"
#include "requests.h"
#include "view_tracker.h"

namespace talus::client {

inline const ClientError kNoHorizon{
    ErrorKind::out_of_range,
    "this server does not support a View with a horizon (ServerLimits::view_horizon)",
    {}};

inline const ClientError kOutcomeUnknown{ErrorKind::outcome_unknown,
                                         "the connection broke before the edit was answered, and the server "
                                         "no longer knows its editor: the edit's outcome is unknown",
                                         {}};

/// Error of an edit that was sent and is given up because of `why`.
[[nodiscard]] inline ClientError unknown_outcome(const ClientError& why) {
  return {ErrorKind::outcome_unknown,
          why.message + "; the edit was sent before, and its outcome is unknown",
          {},
          why.waited_for};
}

/// Checks a View against the server's rules: the client must not adopt one that the server would refuse.
[[nodiscard]] Result<void> check_view(const View& view, const WorldInfo& world);

using ConnectHandler = std::function<void(Result<WorldInfo>)>;
using PingHandler = std::function<void(Result<std::chrono::nanoseconds>)>;

class Core : public std::enable_shared_from_this<Core>, public LocalChunks::Host {
 public:
  Core(asio::any_io_executor executor, Options options, Events events);

  void connect(std::string host, std::string port, ConnectHandler handler);
  RequestId get(ChunkKey key, std::optional<ContentHash> known,
                std::function<void(Result<ReceivedChunk>)> handler);
  void cancel(RequestId request);
  void get_heights(std::vector<Column> columns,
                   std::function<void(Result<std::vector<std::int32_t>>)> handler);
  void get_places(std::vector<Column> columns, std::vector<std::string> fields,
                  std::function<void(Result<ColumnPlaces>)> handler);
  [[nodiscard]] Result<void> set_view(const View& view);
  void edit(Edit edit, std::function<void(Result<EditDone>)> handler);
  void ping(PingHandler handler);
  void close();

  [[nodiscard]] bool connected() const { return joined_; }
  [[nodiscard]] const WorldInfo* world() const { return world_ ? &*world_ : nullptr; }
  [[nodiscard]] const Stats& stats() const { return stats_; }
  /// True if the View's chunks are made here.
  [[nodiscard]] bool generates() const { return local_ != nullptr && local_->active(); }

 private:
  using ConnectionPtr = std::shared_ptr<Connection>;
  // Incremented by close(): a run whose number differs must stop. A run takes its number in connect(),
  // because its coroutine may start only after close().
  using Generation = std::uint64_t;

  [[nodiscard]] asio::awaitable<void> run(Generation mine, std::string host, std::string port,
                                          ConnectHandler handler);
  [[nodiscard]] asio::awaitable<Result<WorldInfo>> join(ConnectionPtr connection,
                                                        std::shared_ptr<Servers> servers);
  [[nodiscard]] asio::awaitable<ClientError> read_until_broken(ConnectionPtr connection);
  [[nodiscard]] asio::awaitable<void> write_loop(ConnectionPtr connection);
  [[nodiscard]] asio::awaitable<void> ping_loop(ConnectionPtr connection, std::chrono::milliseconds interval);

  [[nodiscard]] Result<void> accept_world(const WorldInfo& world);
  /// Checks the View against the limits of the last server met.
  [[nodiscard]] Result<void> check_kept_view() const;
  void keep_view(Generation mine);
  void start_session(const ConnectionPtr& connection);
  void end_session();
  void end_run(const ClientError& why);

  // Each function handles one message; an error ends the connection.
  [[nodiscard]] Result<void> handle(std::span<const std::byte> frame);
  [[nodiscard]] Result<void> handle_chunk(const wire::Chunk& chunk, std::size_t frame_bytes);
  [[nodiscard]] Result<void> handle_unchanged(const wire::Unchanged& unchanged);
  [[nodiscard]] Result<void> handle_column(const wire::UniformColumn& column);
  void add(HeightsRequest request);
  [[nodiscard]] Result<void> handle_heights(const wire::Heights& heights);
  [[nodiscard]] Result<void> handle_file_part(const wire::FilePart& part);
  [[nodiscard]] Result<void> handle_error(const wire::Error& error);
  [[nodiscard]] Result<void> handle_broadcast(const wire::EditBroadcast& edit);
  [[nodiscard]] Result<void> handle_attached(const wire::Attached& attached);
  [[nodiscard]] Result<void> handle_edit_result(const wire::EditResult& result);
  [[nodiscard]] Result<void> edit_refused(const wire::Error& error, bool comes_back);
  void attach_refused(const ClientError& why, bool comes_back);
  void fail_edits(std::vector<OpenEdit> edits, const ClientError& why);
  /// The outcome of edits already sent is unknown.
  void fail_all_edits(const ClientError& why);
  void refetch(ChunkKey key);
  [[nodiscard]] Result<void> handle_pong(const wire::Pong& pong);
  void ping_refused(const ClientError& why);
  [[nodiscard]] Result<void> handle_go_away(const wire::GoAway& away);
  [[nodiscard]] Result<void> handle_complete(const wire::ViewComplete& complete);
  void tell_complete();
  void deliver(const ReceivedChunk& chunk);
  [[nodiscard]] Result<void> confirm(ChunkKey key, ContentHash hash, std::uint64_t revision);
  void tell_left(Generation mine);
  void bring_back(Generation mine);
  void report(const ClientError& error);

  // Chunks made here: generation.cpp.
  /// Fails if Options::generate is `always` and chunks cannot be made in this world.
  [[nodiscard]] Result<void> check_generation(const WorldInfo& world) const;
  void begin_generation();
  /// Reports once that chunks cannot be made for want of a maker.
  void require_maker();
  void stop_generation();
  /// Returns true if the broadcast was taken for a chunk that is to be made.
  [[nodiscard]] Result<bool> add_to_made(const ChunkKey& key, const wire::EditBroadcast& edit);
  void ask(Request request) override;
  [[nodiscard]] const ViewTracker& tracker() const override { return tracker_; }
  void deliver_local(const ReceivedChunk& chunk, bool made) override;
  void world_opened(const std::shared_ptr<const WorldFiles>& fetched) override;
  void cannot_generate(const std::string& why) override;
  void made_some() override { tell_complete(); }
  void pass_by(const ChunkKey& key) override;
  Stats& counts() override { return stats_; }
  [[nodiscard]] Result<ReceivedChunk> uniform(ChunkKey key, MaterialId material, std::uint64_t revision);

  // Everything that may be sent now, as bytes.
  [[nodiscard]] std::vector<std::byte> compose();
  void compose_view(std::vector<std::byte>& out);
  void compose_pings(std::vector<std::byte>& out);
  void compose_requests(std::vector<std::byte>& out);
  void compose_edits(std::vector<std::byte>& out);
  [[nodiscard]] bool waits_for_pace() const;
  void wake();
  void wake_at(Clock::Time when);

  asio::any_io_executor executor_;
  Options options_;
  Events events_;
  Stats stats_;

  Generation generation_ = 0;
  bool running_ = false;
  bool joined_ = false;
  bool useful_ = false;   // the connection answered something: its failure starts a new count
  bool leaving_ = false;  // GoAway was received: the server finishes what it has, and accepts nothing new
  ConnectionPtr connection_;
  RequestPace pace_;
  std::unique_ptr<Timer> pace_timer_;  // wakes the writer when the pace allows a request
  std::shared_ptr<Timer> retry_timer_;
  std::optional<WorldInfo> world_;
  std::optional<ClientError> close_reason_;  // the server's reason, received before it closed

  Requests requests_;
  OpenEdits edits_;
  std::string edits_wait_for_;  // the server's reason for asking to retry an edit or Attach later; empty: no
                                // such request
  ViewTracker tracker_;
  bool view_to_send_ = false;
  bool view_sent_ = false;                             // on this connection
  ViewShape sent_shape_;                               // the last View sent
  std::uint32_t view_number_ = 0;                      // number of that View; never reused
  std::uint32_t completed_number_ = 0;                 // last View that the server reported complete
  bool complete_to_tell_ = false;                      // for the last View sent
  std::shared_ptr<LocalChunks> local_;                 // null: chunks are not made here
  std::optional<ClientError> no_generation_;           // why, if it was given up since connect()
  bool sent_base_ = false;                             // the last View sent has its base here
  bool says_delivered_ = false;                        // the next View's known chunks include delivered ones
  std::unordered_set<ChunkKey> left_since_view_sent_;  // left the View after it was last sent, or arrived
                                                       // after leaving: the server still counts them
  std::unordered_set<ChunkKey> left_to_tell_;  // delivered by on_chunk, not yet reported by on_left_view
  std::vector<std::uint32_t> cancels_to_send_;
  std::map<ChunkKey, bool> refetching_;  // edited chunks requested again; true if edited again since
  std::vector<std::uint64_t> pings_to_send_;
  struct OpenPing {
    Clock::Time sent;
    PingHandler handler;  // empty: keep-alive only
    bool is_sent = false;
  };
  std::map<std::uint64_t, OpenPing> open_pings_;
  std::uint64_t last_nonce_ = 0;
  std::uint64_t taken_bytes_ = 0;  // bytes of chunk frames on this connection
  std::uint64_t credited_bytes_ = 0;
  struct UniformChunk {
    std::shared_ptr<const Chunk> chunk;
    ContentHash hash;
  };
  std::unordered_map<MaterialId, UniformChunk> uniform_chunks_;  // at most one per material of the world
};

}  // namespace talus::client
