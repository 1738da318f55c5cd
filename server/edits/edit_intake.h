// Prepares edits for the log: asks whether they keep the bounds, and looks up the base of every voxel that
// they touch, so that applying them never generates. Edits of one session go to the log in the order in which
// they came; those of others do not wait for them.
//
// One thread. Chunks that are not in memory are made by the generators, in the turns of the session's flow.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <thread>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include <talus/edits/edit.h>
#include <talus/edits/editors.h>

#include "chunks/chunk_source.h"
#include "edits/decoded_bases.h"
#include "edits/edit_log.h"
#include "edits/edit_taker.h"
#include "log/logger.h"

namespace talus::server {

class EditIntake final : public EditTaker {
 public:
  /// All outlive this. `editor` and `revision` tell of the applied state, on any thread.
  struct Parts {
    ChunkSource& base;  // chunks as generated
    EditLog& log;
    std::function<std::optional<edits::Editor>(edits::EditorId)> editor;
    std::function<std::uint64_t()> revision;
  };
  /// What a world lets edits write.
  struct Rules {
    HeightRange rows;
    std::vector<MaterialId> materials;  // by rising id
  };
  /// Of decoded chunks that are kept.
  static constexpr std::size_t kBaseBytes = std::size_t{16} << 20;

  EditIntake(Parts parts, Rules rules, Logger log);
  ~EditIntake() override { stop(); }
  EditIntake(const EditIntake&) = delete;
  EditIntake& operator=(const EditIntake&) = delete;

  /// Starts the thread; once.
  void start();
  /// Ends the thread. What is not logged yet is not answered, nor is what comes from now on.
  void stop();

  /// Does what waits now: what the thread does.
  void do_what_waits();

  void attach(const MailboxPtr& mailbox, AttachRequest request) override;
  void edit(const MailboxPtr& mailbox, EditRequest request) override;
  void forget(ClientId client) override;

 private:
  /// An edit whose base is being looked up.
  struct Prepared {
    EditRequest request;
    std::vector<edits::TouchedChunk> touched;
    edits::BaseVoxels base;
    std::set<ChunkCoord> missing;  // of `touched`, not in `base` yet
    std::set<ChunkCoord> asked;    // of `missing`, for which an answer comes
  };
  /// The edits of one session.
  struct Lane {
    MailboxPtr session;
    MailboxPtr look_ups;
    std::deque<EditRequest> waiting;
    std::optional<Prepared> first;
  };
  struct Attaching {
    MailboxPtr mailbox;
    AttachRequest request;
    edits::EditorId editor;
    bool known = false;
    int tries = 0;
  };

  void work();
  void attach_now(Attaching attaching);
  void attached(const Attaching& attaching, const tl::expected<const edits::Applied*, LogFailure>& outcome);
  void take_look_ups(Lane& lane);
  /// Logs what of the lane is ready, in order.
  void advance(Lane& lane);
  /// Begins the next edit; none where it was refused.
  [[nodiscard]] std::optional<Prepared> prepare(const Lane& lane, EditRequest request);
  void look_up(const Lane& lane, Prepared& edit);
  void log_edit(const Lane& lane, Prepared edit);

  const Parts parts_;
  const Rules rules_;
  const Logger log_;

  // From other threads.
  std::mutex mutex_;
  std::condition_variable comes_;
  std::vector<Attaching> attaching_;
  std::vector<std::pair<MailboxPtr, EditRequest>> edits_;
  std::vector<ClientId> forgotten_;
  std::unordered_set<std::uint64_t> looked_up_;  // owners of look-ups with mail
  bool stopping_ = false;

  // Of the thread alone.
  std::unordered_map<std::uint64_t, Lane> lanes_;  // by the session's client
  DecodedBases bases_{kBaseBytes};

  std::thread thread_;
};

}  // namespace talus::server
