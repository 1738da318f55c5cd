// Shows a player's own edits at once. The server's chunks are kept apart, and unanswered own edits are
// reapplied to them whenever they change: if another player's edit came first, or the server refuses, the
// store corrects itself. When all edits are answered, it holds exactly the server's chunks.
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
// Only level 0 of held chunks is predicted; coarser levels, and fills with generated material, appear when
// the server has answered. An edit whose guards fail here, or refer to chunks that are not held, shows
// nothing until then.
//
// Not thread-safe: use it on the client's executor. Each time a chunk that an unanswered edit touches arrives
// or leaves, the cost is proportional to the voxels of all unanswered edits; other chunks cost only the
// store's work.
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
  /// `store` is what the game draws; it must outlive this object and be changed only through it. `changed` is
  /// called for each chunk whose contents in `store` changed, also by put(); it may read the store, but must
  /// change neither object.
  Prediction(ChunkStore& store, std::function<void(ChunkKey)> changed);
  ~Prediction();
  Prediction(const Prediction&) = delete;
  Prediction& operator=(const Prediction&) = delete;

  // ---- chunks from the server: Events::on_chunk and on_left_view
  void put(const ReceivedChunk& chunk);
  void erase(const ChunkKey& key);
  /// Drops all chunks and edits: revisions of another store (WorldInfo::store_id) are not comparable. Edits
  /// answered later change nothing.
  void clear();

  // ---- own edits
  /// Sends the edit and applies it here at once. `handler` is called as by Client::edit(), after the store
  /// reflects the result, even if this object is gone. `client` must not move until then; chunks that the
  /// edit turned out not to change are requested from it again.
  void edit(Client& client, const Edit& edit, std::function<void(Result<EditDone>)> handler);

  /// The parts of edit(), for callers that send edits by other means. begin() applies the edit here; done()
  /// passes its result: if it was applied, EditDone with its revision.
  enum class Id : std::uint64_t {};
  Id begin(const Edit& edit);
  void done(Id id, const Result<EditDone>& result);
  /// Chunks touched by an applied edit but held at an older revision. Most arrive soon; a chunk that the edit
  /// did not change, as loose material slid into a dug hole, never does. Request them once after done() by
  /// Client::get(), and pass the answer to put() and then resolve().
  [[nodiscard]] std::vector<ChunkKey> behind(Id id) const;
  /// The held chunk includes the edit, or never will: show it as it is.
  void resolve(Id id, const ChunkKey& key);

  /// Number of own edits that are unanswered, or that the store shows differently from the server's chunks.
  [[nodiscard]] std::size_t open() const;

 private:
  struct PredictedEdit;
  struct Overlay;  // voxels of one chunk
  using Overlays = std::map<ChunkCoord, Overlay>;

  /// Schedules requests for the chunks in behind().
  static void ask_later(const std::weak_ptr<Prediction*>& self, Client& client, Id id);
  /// True if the chunk is held without the edit.
  [[nodiscard]] bool waits(const PredictedEdit& open, ChunkCoord chunk) const;
  /// True if an open edit names voxels of the chunk.
  [[nodiscard]] bool is_touched(const ChunkKey& key) const;
  /// True if the store evicted a chunk that it showed with an edit.
  [[nodiscard]] bool covers_lost() const;
  /// The server's version of the chunk; null if not held.
  [[nodiscard]] const ReceivedChunk* confirmed(ChunkCoord chunk) const;
  /// Reapplies all open edits to the server's chunks and reports changes; `came` has changed.
  void rebuild(std::optional<ChunkKey> came = std::nullopt);
  /// Applies one edit on top of the earlier ones. Returns true if it is no longer needed.
  [[nodiscard]] bool apply(const PredictedEdit& open, Overlays& overlays) const;
  /// Returns the chunks whose voxels changed.
  [[nodiscard]] std::vector<ChunkKey> show(const Overlays& overlays);

  ChunkStore& store_;
  std::function<void(ChunkKey)> changed_;
  std::list<PredictedEdit> edits_;  // in the order of begin()
  std::uint64_t last_id_ = 0;
  std::map<ChunkCoord, ReceivedChunk> confirmed_;  // chunks that the store shows differently
  std::shared_ptr<Prediction*> self_;              // for answers that arrive after destruction
};

}  // namespace talus::client
