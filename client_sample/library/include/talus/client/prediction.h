// A player's own edits, seen at once. What the server has is kept apart, and own edits that it has not
// answered are made on it anew whenever it changes: where another's edit came before, or the server refuses,
// the store shows what is true again by itself. When all is answered and nobody edits, it holds what the
// server holds.
//
//   ChunkStore store{256 << 20};
//   Prediction own{store, [&](ChunkKey key) { remesh_around(key); }};
//   events.on_chunk = [&](const ReceivedChunk& chunk) { own.put(chunk); };
//   events.on_left_view = [&](ChunkKey key) { own.erase(key); };
//   ...
//   Edit dig;
//   dig.guards.push_back({voxel, stone});
//   dig.writes.push_back({voxel, kAir});
//   own.edit(client, dig, [&](const Result<EditDone>& done) {
//     if (!done) show(done.error().message);  // the stone is there again
//   });
//   // the voxel is air in `store` already
//
// What shows at once is level 0 of chunks that are held; coarser levels, and what is made as generated, show
// when the server has answered. An edit whose guards do not hold here, or look where no chunk is held, shows
// nothing until then.
//
// Not thread-safe: the client's executor. It costs as much as the edits without an answer name voxels, each
// time that a chunk comes or leaves which one of them touches; other chunks cost what the store costs.
#pragma once

#include <cstdint>
#include <functional>
#include <list>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include <talus/client/chunk_store.h>
#include <talus/client/client.h>

namespace talus::client {

class Prediction {
 public:
  /// `store` is what is drawn; it outlives this and is changed through this alone. `changed` is told each
  /// chunk of it that looks otherwise than before, put() included; it may ask the store, and must change
  /// neither.
  Prediction(ChunkStore& store, std::function<void(ChunkKey)> changed);
  ~Prediction();
  Prediction(const Prediction&) = delete;
  Prediction& operator=(const Prediction&) = delete;

  // ---- what comes from the server: Events::on_chunk and on_left_view
  void put(const ReceivedChunk& chunk);
  void erase(const ChunkKey& key);
  /// Forgets chunks and edits: revisions of another store (WorldInfo::store_id) mean nothing here. Edits that
  /// are answered later change nothing.
  void clear();

  // ---- own edits
  /// Sends the edit, and makes it here at once. `handler` is called as Client::edit() calls it, after the
  /// store is right about the edit; it is called also where this is gone. `client` stays where it is until
  /// then; chunks that the edit did not change after all it asks for again.
  void edit(Client& client, const Edit& edit, std::function<void(Result<EditDone>)> handler);

  /// The parts of it, for who sends edits otherwise. begin() makes the edit here; done() says what became of
  /// it: where it happened, the revision of EditDone.
  enum class Id : std::uint64_t {};
  Id begin(const Edit& edit);
  void done(Id id, const Result<EditDone>& result);
  /// Chunks that an edit that happened touches, and that are held as they were before it. Mostly they come
  /// soon; those that the edit did not change, as material slid into what it dug, never do. Such are to be
  /// asked for once more after done(), by Client::get(), and what comes is given to put() and then resolve().
  [[nodiscard]] std::vector<ChunkKey> behind(Id id) const;
  /// What is held of the chunk has the edit, or never will: it shows as it is.
  void resolve(Id id, const ChunkKey& key);

  /// Own edits that the store shows otherwise than the server's chunks do, or whose answer has not come.
  [[nodiscard]] std::size_t open() const;

 private:
  struct Open;
  struct Overlay;  // voxels of one chunk
  using Overlays = std::map<ChunkCoord, Overlay>;

  /// Asks for what is behind then.
  static void ask_later(const std::weak_ptr<Prediction*>& self, Client& client, Id id);
  /// Whether the chunk is held, and without the edit.
  [[nodiscard]] bool waits(const Open& open, ChunkCoord chunk) const;
  /// Whether an open edit names voxels of it.
  [[nodiscard]] bool is_touched(const ChunkKey& key) const;
  /// Whether the store has let go of a chunk that it showed otherwise.
  [[nodiscard]] bool covers_lost() const;
  /// What the server has of it; null where it is not held.
  [[nodiscard]] const ReceivedChunk* confirmed(ChunkCoord chunk) const;
  /// Makes all open edits anew on what the server has, and tells what changed; `came` has.
  void rebuild(std::optional<ChunkKey> came = std::nullopt);
  /// Makes one on what those before it left. Returns whether it is of no use any more.
  [[nodiscard]] bool apply(const Open& open, Overlays& overlays) const;
  /// Returns the chunks that look otherwise now.
  [[nodiscard]] std::vector<ChunkKey> show(const Overlays& overlays);

  ChunkStore& store_;
  std::function<void(ChunkKey)> changed_;
  std::list<Open> edits_;  // in the order in which they were begun
  std::uint64_t last_id_ = 0;
  std::map<ChunkCoord, ReceivedChunk> confirmed_;  // of chunks that the store shows otherwise
  std::shared_ptr<Prediction*> self_;              // for answers that come when this is gone
};

}  // namespace talus::client
