// A connection to a Talus server.
//
// Everything runs on the executor passed to the constructor; no thread is started. A Client is not
// thread-safe: call it only on that executor, where its callbacks run too (a single-threaded io_context, or a
// strand). Callbacks may call the client, even close() or destroy it; they must not throw. If memory runs
// out, std::bad_alloc leaves through the call or through the executor's run(); the client must then be
// destroyed.
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
// Everything from the server is checked before use: frames against limits, answers against requests, chunks
// against their hash. A chunk that fails is never delivered; a server that breaks the protocol is
// disconnected.
//
// Chunks that left the View are kept for a while, up to Options::keep_bytes. When they return unchanged, only
// their hashes are sent.
//
// Requests, Views and pings above the server's advertised rates wait inside the client. If the server still
// refuses one and gives a delay, the client repeats it after that delay.
//
// With Options::generate, and a server that publishes its world, the client makes the chunks of the View
// itself, on the maker's threads, and receives only edits. It fetches the world's file, compares
// fingerprints, and until the world is open receives chunks as without. on_chunk and on_view_complete are the
// same wherever a chunk is made. Some of the chunks made here are compared with the server's (kFirstProofs at
// first, then one for kChunksPerProof made). If one differs, or the world cannot be opened, on_error says so
// once, by ErrorKind::cannot_generate, and until the next connect() the server sends the chunks: all of the
// View, also those made here.
//
// If the connection breaks or the server goes away, and Options::reconnect allows it, the client reconnects,
// to the next of Options::more_servers if there are any. If that server asked for a delay before, the client
// waits for it, at most kLongestRetryAfter. If the world has the same fingerprint, the current View and every
// unanswered request are sent again, and on_chunk is called again for all chunks of the View, except
// unedited ones if the client makes chunks itself; the caller sees only on_disconnect and on_reconnect.
// Otherwise, or when attempts run out, every unanswered request fails.
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

/// Data of several columns, in the order of the request.
struct ColumnPlaces {
  std::vector<std::int32_t> heights_fx;  // ground, 1/256 voxel above y = 0
  std::vector<std::uint8_t> looks;       // biomes, as indexes into WorldInfo::looks
  std::vector<float> values;             // all fields of a column, in requested order, then of the next
};

/// Callbacks, all optional.
struct Events {
  /// A chunk of the current View arrived or changed.
  std::function<void(const ReceivedChunk&)> on_chunk;
  /// A chunk that on_chunk delivered left the View and will no longer be updated.
  std::function<void(ChunkKey)> on_left_view;
  /// All chunks of the View arrived, except any reported by on_error. Called at most once per View sent, not
  /// for a View replaced before; again after a reconnect.
  std::function<void(const View&)> on_view_complete;
  /// An error that the connection survives: a bad chunk of the View, or a refused View.
  std::function<void(const ClientError&)> on_error;
  /// An established connection was lost. `retrying`: the client is reconnecting.
  std::function<void(const ClientError&, bool retrying)> on_disconnect;
  /// The world's files were fetched for Options::generate, and opened. Kept, they need not be fetched again
  /// (Options::kept_files).
  std::function<void(ContentHash fingerprint, const std::shared_ptr<const WorldFiles>&)> on_world_files;
  /// The connection is back, to the same world.
  std::function<void(const WorldInfo&)> on_reconnect;
};

/// Totals since the client was created.
struct Stats {
  std::uint64_t received_bytes = 0;  // everything the server sent
  std::uint64_t sent_bytes = 0;
  std::uint64_t chunk_frames = 0;
  std::uint64_t chunk_bytes = 0;     // bytes of chunk frames
  std::uint64_t uniform_chunks = 0;  // received as whole columns
  std::uint64_t kept_chunks = 0;     // chunks of a View that were already held and not sent again
  std::uint64_t bad_chunks = 0;      // failed to decode, or did not match their hash
  std::uint64_t connections = 0;
  std::uint64_t made_chunks = 0;    // of Views, made here (Options::generate)
  std::uint64_t proofs = 0;         // chunks made here that were compared with the server's
  std::uint64_t failed_proofs = 0;  // and differed
  std::uint64_t file_bytes = 0;     // of the world's files, received
};

/// Chunks compared with the server's after each connect and reconnect, and chunks made here for each further
/// one.
inline constexpr std::size_t kFirstProofs = 16;
inline constexpr std::size_t kChunksPerProof = 1000;
/// Proofs that come together, of chunks that lie together: the server generates them as one patch of columns.
inline constexpr std::size_t kProofsTogether = 4;

/// Identifies a request for cancel().
enum class RequestId : std::uint32_t {};

class Core;  // internal to the library

class Client {
 public:
  explicit Client(asio::any_io_executor executor, Options options = {}, Events events = {});
  /// Like close(): every unanswered request still fails with an error. No event follows.
  ~Client();
  Client(Client&&) noexcept;
  Client& operator=(Client&&) noexcept;

  /// Connects and joins, without a View at first. `port` is a number or a service name. May be called again
  /// only after an error, after on_disconnect with `retrying` false, or after close().
  [[nodiscard]] asio::awaitable<Result<WorldInfo>> connect(std::string host, std::string port);
  void connect(std::string host, std::string port, std::function<void(Result<WorldInfo>)> handler);

  [[nodiscard]] bool connected() const;
  /// Contents of the last Welcome; null until connect() has succeeded.
  [[nodiscard]] const WorldInfo* world() const;

  /// Requests one chunk. If `known`, the hash of the caller's copy, still matches, the answer is unchanged().
  /// Any number of requests may be open; requests above the server's limit or rate wait here. Answers arrive
  /// in any order, exactly one for each request.
  [[nodiscard]] asio::awaitable<Result<ReceivedChunk>> get(ChunkKey key,
                                                           std::optional<ContentHash> known = std::nullopt);
  RequestId get(ChunkKey key, std::optional<ContentHash> known,
                std::function<void(Result<ReceivedChunk>)> handler);

  /// Cancels a request. Its handler is still called once: with ErrorKind::cancelled, or with the chunk if it
  /// was already in flight. No effect on an answered request.
  void cancel(RequestId request);

  /// Heights of the ground at `columns`, in 1/256 voxel above y = 0, in the same order. At most
  /// limits.heights_per_request columns.
  [[nodiscard]] asio::awaitable<Result<std::vector<std::int32_t>>> get_heights(std::vector<Column> columns);
  void get_heights(std::vector<Column> columns,
                   std::function<void(Result<std::vector<std::int32_t>>)> handler);

  /// Like get_heights(), with the biome of each column and its values of `fields`, which are names from
  /// WorldInfo::fields: quantities such as temperature, and fields that the world defines. At most
  /// protocol::kMaxFieldsPerRequest fields.
  [[nodiscard]] asio::awaitable<Result<ColumnPlaces>> get_places(std::vector<Column> columns,
                                                                 std::vector<std::string> fields);
  void get_places(std::vector<Column> columns, std::vector<std::string> fields,
                  std::function<void(Result<ColumnPlaces>)> handler);

  /// Replaces the View. Cheap: only the newest View is sent, and only if it differs. Fails and leaves the
  /// View unchanged if it exceeds the server's limits, or before connect() has delivered a world. While
  /// reconnecting, the View is kept and sent later.
  [[nodiscard]] Result<void> set_view(const View& view);

  /// Changes voxels. Edits are applied in the order of the calls, each exactly once, however often the
  /// connection breaks. At most as many as the server allows are in flight; the rest wait here. An edit that
  /// the server refuses temporarily is sent again and may then be applied after later ones: if order matters,
  /// use guards. The answer arrives when the edit is stored; changed chunks of the View arrive through
  /// on_chunk, before or after it. Errors: conflict; out_of_range; outcome_unknown if the edit was sent, and
  /// the client was closed or gave up before an answer, or the server no longer knows the editor; refused if
  /// the token lacks the right, or the server stores no edits.
  [[nodiscard]] asio::awaitable<Result<EditDone>> edit(Edit edit);
  void edit(Edit edit, std::function<void(Result<EditDone>)> handler);

  /// Measures the round-trip time.
  [[nodiscard]] asio::awaitable<Result<std::chrono::nanoseconds>> ping();
  void ping(std::function<void(Result<std::chrono::nanoseconds>)> handler);

  /// Closes the connection. Unanswered requests fail; the View and its chunks are dropped without
  /// on_left_view. connect() may be called again, to any server.
  void close();

  [[nodiscard]] const Stats& stats() const;

  /// True while chunks of the View are made here.
  [[nodiscard]] bool generates() const;

 private:
  std::shared_ptr<Core> core_;
};

}  // namespace talus::client
