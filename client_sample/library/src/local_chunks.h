// Makes the chunks of the View here (Options::generate): opens the published world, has its chunks made, adds
// their edits, and compares some with the server's. Used on the client's executor alone.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <set>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include <talus/client/client.h>

#include "gate.h"
#include "make_queue.h"
#include "pending_edits.h"
#include "proofs.h"
#include "published_files.h"
#include "requests.h"
#include "view_tracker.h"

namespace talus::client {

class LocalChunks : public std::enable_shared_from_this<LocalChunks> {
 public:
  /// The client. Each function may stop() the object.
  class Host {
   public:
    virtual ~Host() = default;
    /// Asks the server.
    virtual void ask(Request request) = 0;
    [[nodiscard]] virtual const ViewTracker& tracker() const = 0;
    /// Gives the caller a chunk of the View. `made`: it was made now; otherwise it was held.
    virtual void deliver_local(const ReceivedChunk& chunk, bool made) = 0;
    /// The world is open and the server's. `fetched`: its files, if they came from the server; else null.
    virtual void world_opened(const std::shared_ptr<const WorldFiles>& fetched) = 0;
    /// The server must send the chunks, also those made here.
    virtual void cannot_generate(const std::string& why) = 0;
    /// Some chunks were made, or none is missing.
    virtual void made_some() = 0;
    /// The server's update of this chunk was dropped, as the chunk left the View.
    virtual void pass_by(const ChunkKey& key) = 0;
    virtual Stats& counts() = 0;
  };

  /// `host` outlives what it holds of `alive`.
  LocalChunks(Host& host, std::weak_ptr<void> alive, const asio::any_io_executor& executor,
              const Options& options, ContentHash fingerprint);
  ~LocalChunks() { stop(); }
  LocalChunks(const LocalChunks&) = delete;
  LocalChunks& operator=(const LocalChunks&) = delete;

  /// Opens the world soon.
  void start();
  /// Nothing is called any more.
  void stop();
  [[nodiscard]] bool is_open() const { return world_ != nullptr; }

  /// A connection began, on which Views have their base here; proofs are due again.
  void begin_session();
  void end_session() { active_ = false; }
  /// True if the chunks of Views are made here now.
  [[nodiscard]] bool active() const { return active_; }

  /// The View or the chunks held have changed.
  void view_changed();
  /// The server will confirm or replace these held chunks of the View, unless they are as generated.
  void announced(const std::vector<ReceivedChunk>& known);
  /// The server has sent all edits of the View.
  void all_edits_came();
  /// Adds an edit of a chunk that is to be made. False if the server must send the chunk.
  [[nodiscard]] bool add_edit(const ChunkKey& key, std::uint64_t previous, std::uint64_t revision,
                              const std::vector<Override>& voxels);
  [[nodiscard]] bool has_edits(const ChunkKey& key) const { return edits_.find(key) != nullptr; }
  /// The server sent the chunk.
  void came(const ChunkKey& key, std::uint64_t revision);
  /// The server has another chunk as generated than the one made here.
  void differs(const ChunkKey& key);
  /// True if no chunk of the View is to be made.
  [[nodiscard]] bool done() const { return host_.tracker().complete() && edits_.empty(); }

 private:
  /// Chunks being made. At most this many, plus one batch: so few results wait for the executor.
  static constexpr std::size_t kMaxInFlight = 1024;
  struct Batch {
    std::vector<ChunkKey> keys;
    std::shared_ptr<std::atomic<bool>> cancel;
  };

  /// Runs `call(*this)` on the executor unless stopped.
  template <typename Call>
  [[nodiscard]] auto later(Call call);
  /// Fetches these files, then opens the world.
  void fetch(std::set<std::string> names);
  void fetch_next();
  void ask_part();
  void take_part(const Result<FileRequest::Part>& part);
  void open(bool fetched);
  void opened(bool fetched, tl::expected<std::shared_ptr<LocalWorld>, ChunkMaker::OpenFailure> world);
  void fail(const std::string& why);

  void pump_soon();
  void pump();
  void plan();
  [[nodiscard]] bool wanted(const ChunkKey& key) const;
  void start(std::vector<ChunkKey> keys);
  void take(std::uint64_t batch, tl::expected<std::vector<MadeChunk>, std::string> made);
  void deliver(const MadeChunk& made, std::vector<Proofs::Proof>& mixed);
  void prove(const Proofs::Proof& proof);
  void judge(const Proofs::Proof& proof, const Result<ReceivedChunk>& answer);

  Host& host_;
  std::weak_ptr<void> alive_;
  std::shared_ptr<Gate> gate_;
  std::shared_ptr<ChunkMaker> maker_;
  std::function<std::shared_ptr<const WorldFiles>(ContentHash)> kept_files_;
  ContentHash fingerprint_;
  bool stopped_ = false;
  bool active_ = false;

  PublishedFiles files_;
  std::set<std::string> to_fetch_;
  std::shared_ptr<std::atomic<bool>> cancel_open_ = std::make_shared<std::atomic<bool>>(false);
  std::shared_ptr<LocalWorld> world_;

  MakeQueue queue_;
  bool plan_is_stale_ = true;
  bool pump_posted_ = false;
  std::unordered_map<std::uint64_t, Batch> batches_;  // being made
  std::unordered_set<ChunkKey> making_;               // their chunks
  std::uint64_t last_batch_ = 0;
  PendingEdits edits_;
  std::unordered_set<ChunkKey> announced_;
  Proofs proofs_;
};

}  // namespace talus::client
