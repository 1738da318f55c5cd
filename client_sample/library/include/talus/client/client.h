// A connection to a Talus server.
//
// Everything runs on the executor given to the constructor, and nothing starts a thread. A Client is not
// thread-safe: call it, and expect its callbacks, on that executor only (a single-threaded io_context, or
// a strand). Callbacks may call the client, even close() it or destroy it; they must not throw. Where memory
// runs out, std::bad_alloc leaves by the call or by the executor's run(); the client is then to be destroyed.
//
// In a coroutine:
//
//   asio::awaitable<void> visit(asio::any_io_executor executor) {
//     Client client{executor, Options{}};
//     const auto world = co_await client.connect("localhost", "4780");
//     if (!world) { std::cerr << world.error().message << '\n'; co_return; }
//     const auto chunk = co_await client.get(ChunkKey{{0, 1, 0}, Lod{}});
//     if (chunk) use(*chunk->chunk);
//   }
//
// In a game loop that owns an io_context and polls it once a frame:
//
//   asio::io_context io;
//   Events events;
//   events.on_chunk = [&](const ReceivedChunk& chunk) { store.put(chunk); };
//   events.on_left_view = [&](ChunkKey key) { store.erase(key); };
//   Client client{io.get_executor(), Options{}, events};
//   client.connect("localhost", "4780", [&](const Result<WorldInfo>& world) {
//     if (world) player.place_at(world->spawn); else show(world.error().message);
//   });
//   while (running) {
//     io.poll();                                                  // callbacks run in here
//     if (client.connected()) (void)client.set_view(player.view());  // every frame is fine
//     draw(store);
//   }
//
// What comes from the server is checked before anything is done with it: frames against limits, answers
// against what was asked, chunks against their hash. A chunk that fails is never delivered; a server that
// breaks the protocol is dropped.
//
// Chunks that left the View are kept for a while, within Options::keep_bytes: when they come back, only
// their hashes travel, unless they have changed.
//
// Requests, Views and pings beyond the rate that the server told wait inside the client. Where the server
// refuses one all the same and says when to come back, the client asks again then by itself.
//
// When the connection breaks, or the server goes away, and Options::reconnect allows it, the client connects
// again: to the next of Options::more_servers where there are some; where the server that is next asked for a
// wait first, up to kLongestRetryAfter, after that. If the world has the same fingerprint, the
// current View and every unanswered request are sent again, and on_chunk comes again for all chunks of the
// View; the caller sees only on_disconnect and on_reconnect. Otherwise, and when attempts run out, every
// unanswered request fails.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <asio/any_io_executor.hpp>
#include <asio/awaitable.hpp>

#include <talus/client/edit.h>
#include <talus/client/error.h>
#include <talus/client/options.h>
#include <talus/client/received_chunk.h>
#include <talus/client/view.h>
#include <talus/client/world_info.h>

namespace talus::client {

/// A base column.
struct Column {
  std::int64_t x = 0;
  std::int64_t z = 0;
};

/// What there is at some columns, in the order in which they were asked for.
struct ColumnPlaces {
  std::vector<std::int32_t> heights_fx;  // of the ground, 1/256 voxel above y = 0
  std::vector<std::uint8_t> looks;       // places in WorldInfo::looks: which biome it is
  std::vector<float> values;             // of each column those of all fields, in the order of the request
};

/// Callbacks, all optional.
struct Events {
  /// A chunk of the current View has come, or has changed.
  std::function<void(const ReceivedChunk&)> on_chunk;
  /// A chunk that on_chunk delivered is no longer in the View, and will not be kept up to date.
  std::function<void(ChunkKey)> on_left_view;
  /// All chunks of the View have come, but for those of which on_error told. At most once for each View that
  /// is sent, and not for one that was replaced before; again after a reconnect. Never from a server of 0.1.
  std::function<void(const View&)> on_view_complete;
  /// Something that the connection survives: a chunk of the View that was bad, a View that was refused.
  std::function<void(const ClientError&)> on_error;
  /// The connection is gone after having been up. `retrying`: the client is trying to come back.
  std::function<void(const ClientError&, bool retrying)> on_disconnect;
  /// It has come back, to the same world.
  std::function<void(const WorldInfo&)> on_reconnect;
};

/// Running totals since the client was made.
struct Stats {
  std::uint64_t received_bytes = 0;  // everything the server sent
  std::uint64_t sent_bytes = 0;
  std::uint64_t chunk_frames = 0;
  std::uint64_t chunk_bytes = 0;     // of chunk frames
  std::uint64_t uniform_chunks = 0;  // that came in whole columns
  std::uint64_t kept_chunks = 0;     // of a View, held since before and not sent again
  std::uint64_t bad_chunks = 0;      // that did not decode, or did not match their hash
  std::uint64_t connections = 0;
};

/// Names a request for cancel().
enum class RequestId : std::uint32_t {};

class Core;  // the library's own

class Client {
 public:
  explicit Client(asio::any_io_executor executor, Options options = {}, Events events = {});
  /// As close(): every unanswered request still gets its error; no event comes any more.
  ~Client();
  Client(Client&&) noexcept;
  Client& operator=(Client&&) noexcept;

  /// Connects and joins, without a View at first. `port` is a number or a service name. Once at a time;
  /// after an error, on_disconnect that does not retry, or close() it may be called again.
  [[nodiscard]] asio::awaitable<Result<WorldInfo>> connect(std::string host, std::string port);
  void connect(std::string host, std::string port, std::function<void(Result<WorldInfo>)> handler);

  [[nodiscard]] bool connected() const;
  /// What the last Welcome said; null until connect() has brought one.
  [[nodiscard]] const WorldInfo* world() const;

  /// One chunk. With `known`, the hash of what the caller holds, the answer may be unchanged(). Any number
  /// of requests may be open; those beyond the server's limit or rate wait their turn here. Answers come in
  /// any order, each exactly once.
  [[nodiscard]] asio::awaitable<Result<ReceivedChunk>> get(ChunkKey key,
                                                           std::optional<ContentHash> known = std::nullopt);
  RequestId get(ChunkKey key, std::optional<ContentHash> known,
                std::function<void(Result<ReceivedChunk>)> handler);

  /// Gives a request up. Its handler is still called once: with ErrorKind::cancelled, or with the chunk if
  /// that was in flight already. A request that was answered is left alone.
  void cancel(RequestId request);

  /// Heights of the ground at `columns`, in 1/256 voxel above y = 0, in the same order. At most
  /// limits.heights_per_request columns.
  [[nodiscard]] asio::awaitable<Result<std::vector<std::int32_t>>> get_heights(std::vector<Column> columns);
  void get_heights(std::vector<Column> columns,
                   std::function<void(Result<std::vector<std::int32_t>>)> handler);

  /// As get_heights(), with the look of each column and the values there of `fields`, names of
  /// WorldInfo::fields: quantities such as temperature, and the world's own. At most
  /// protocol::kMaxFieldsPerRequest.
  [[nodiscard]] asio::awaitable<Result<ColumnPlaces>> get_places(std::vector<Column> columns,
                                                                 std::vector<std::string> fields);
  void get_places(std::vector<Column> columns, std::vector<std::string> fields,
                  std::function<void(Result<ColumnPlaces>)> handler);

  /// Says what the player wants around it, in place of what it wanted before. Cheap: only the newest View
  /// is sent, and an equal one is not. An error, which leaves the View before, when it goes beyond the
  /// server's limits, or before connect() has brought a world; while reconnecting it is kept.
  [[nodiscard]] Result<void> set_view(const View& view);

  /// Changes voxels. Edits happen in the order of the calls, each once, however often the connection breaks
  /// meanwhile; at most as many as the server allows are on their way, the others wait here. One that the
  /// server refuses for now is sent again, and may then happen behind later ones: where order matters, use
  /// guards. The answer comes when the edit is stored; chunks of the View change by on_chunk, before or after
  /// it. Errors: conflict, out_of_range; outcome_unknown where it was sent, and the client was closed or has
  /// given up before an answer came, or the server has forgotten who sent it; refused where the token does
  /// not give the right, or the server stores no edits.
  [[nodiscard]] asio::awaitable<Result<EditDone>> edit(Edit edit);
  void edit(Edit edit, std::function<void(Result<EditDone>)> handler);

  /// Round-trip time.
  [[nodiscard]] asio::awaitable<Result<std::chrono::nanoseconds>> ping();
  void ping(std::function<void(Result<std::chrono::nanoseconds>)> handler);

  /// Closes the connection for good. Unanswered requests fail; the View and what came for it are forgotten,
  /// without on_left_view. connect() may be called again, to any server.
  void close();

  [[nodiscard]] const Stats& stats() const;

 private:
  std::shared_ptr<Core> core_;
};

}  // namespace talus::client
