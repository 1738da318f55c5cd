// Prepares edits for the log: asks whether they keep the bounds, and looks up the base of every voxel that
// they touch, so that applying them never generates. Edits of one session go to the log in the order in which
// they came; those of others do not wait for them.
//
// In the log wait few entries, and all that a session has more waits here, for its turn: who has sent much
// waits for his own, and not others for him.
//
// One thread. Chunks that are not in memory are made by the generators, in the turns of the session's flow.
// A small edit whose session has no other under way, of chunks that are at hand decoded, needs no turn, nor
// that thread: while it rests the edit goes to the log on the thread that brought it.
//
// What comes from other threads is in edit_intake.cpp; turns, Attaches and edits have files of their own
// beside it.
#pragma once

#include <atomic>
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
#include <utility>
#include <variant>
#include <vector>

#include <talus/edits/edit.h>
#include <talus/edits/editors.h>
#include <talus/edits/settle.h>

#include "chunks/chunk_source.h"
#include "edits/decoded_bases.h"
#include "edits/edit_log.h"
#include "edits/edit_refusals.h"
#include "edits/edit_taker.h"
#include "limits/flows/fair_queue.h"
#include "runtime/clock.h"
#include "runtime/log/logger.h"
#include "runtime/metrics/metrics.h"

namespace talus::server {

class EditIntake final : public EditTaker {
 public:
  /// All outlive this. `editor` tells of the applied state, on any thread.
  struct Parts {
    ChunkSource& base;  // for chunks as generated
    EditLog& log;
    std::function<std::optional<edits::Editor>(edits::EditorId)> editor;
    const Clock& clock;
    Metrics& metrics;
    /// Whether the applied state has room for another editor, on any thread; null: it always has.
    std::function<tl::expected<void, LogFailure>()> room_for_editor{};
  };
  /// What a world lets edits write.
  struct Rules {
    HeightRange rows;
    std::vector<MaterialId> materials;  // by rising id
    edits::SettleRulesPtr settles{};    // null: nothing slides
  };
  /// Of decoded chunks that are kept, at most.
  static constexpr std::size_t kBaseBytes = std::size_t{16} << 20;
  /// In the log, waiting and being written: what two batches need to be worth their syncs. An entry alone may
  /// have more bytes. A small edit of a session that has none in the log waits for no room there, and so is
  /// in the next batch.
  static constexpr std::size_t kLogEntries = 256;
  static constexpr std::size_t kSmallVoxels = 64;
  static constexpr std::size_t kSmallChunks = 8;
  static constexpr std::size_t kLogBytes = std::size_t{256} << 10U;

  EditIntake(Parts parts, Rules rules, Logger log);
  ~EditIntake() override { stop(); }
  EditIntake(const EditIntake&) = delete;
  EditIntake& operator=(const EditIntake&) = delete;

  /// Starts the thread; once.
  void start();
  /// Ends the thread. What is not logged yet is not answered, nor is what comes from now on.
  void stop();

  /// The log takes entries again, or takes none any more: what waits for room there is looked at. Any thread.
  void look_at_log() { call(); }

  /// Of kBaseBytes no more than so many may be kept from now on. Any thread.
  void limit_bases(std::size_t bytes);
  /// Of decoded chunks that are kept. Any thread.
  [[nodiscard]] std::size_t base_bytes() const { return base_bytes_.load(std::memory_order_relaxed); }

  /// Does what waits now, as far as the log has room: what the thread does.
  void do_what_waits();

  void attach(const MailboxPtr& mailbox, AttachRequest request) override;
  void edit(const MailboxPtr& mailbox, EditRequest request) override;
  void input_ended(ClientId client) override;
  void forget(ClientId client) override;
  [[nodiscard]] bool knows(edits::EditorId id, const std::string& subject) const override;
  /// Counts it.
  [[nodiscard]] std::optional<EditRefusal> refuses_editors() const override;
  [[nodiscard]] bool settles() const override { return rules_.settles != nullptr; }

  /// Edits and Attaches that wait here. Any thread.
  [[nodiscard]] std::size_t waiting() const { return waiting_.load(std::memory_order_relaxed); }

 private:
  /// Until it is answered.
  struct Attaching {
    AttachRequest request;
    edits::EditorId editor;  // as which it goes to the log
    bool known = false;
    bool overtaken = false;  // a later one is for the same editor
    int tries = 0;
  };
  struct Editing {
    EditRequest request;
    Clock::time_point came;
  };
  /// An edit whose base is being looked up.
  struct Prepared {
    Editing edit;
    std::vector<edits::TouchedChunk> touched;
    edits::BaseVoxels base;
    std::set<ChunkCoord> missing;  // of `touched`, not in `base` yet
    std::set<ChunkCoord> asked;    // of `missing`, for which an answer comes
  };
  /// What one session has sent.
  struct Lane {
    MailboxPtr session;
    MailboxPtr look_ups;
    std::deque<Editing> waiting;
    std::optional<Prepared> first;       // before those
    std::optional<Attaching> attaching;  // before all edits
    bool attach_waits = false;           // and is not in the log
    bool entered = false;                // its turn comes
    std::size_t cost = 0;                // of that turn
    bool input_ended = false;
    /// Edits of it that the log has not answered.
    std::shared_ptr<std::atomic<std::uint32_t>> in_log = std::make_shared<std::atomic<std::uint32_t>>(0);
  };
  /// Flows have equal shares by what their edits cost, and so have the sessions of a flow. Costs are known,
  /// so that a small edit does not wait for large ones.
  using Turns = FairQueue<FlowId, ClientId>;
  using Came = std::pair<MailboxPtr, std::variant<AttachRequest, Editing>>;
  /// An Attach that the log has answered.
  struct Attached {
    ClientId client{};
    tl::expected<edits::Applied::Kind, LogFailure> outcome;
    EditorSession as;  // where it is attached; but for `known`
  };

  /// On the thread that brings it. False: it must go through the intake's thread, and nothing has happened.
  [[nodiscard]] bool log_at_once(const MailboxPtr& session, EditRequest& request);
  /// From any thread: the intake's looks what is there.
  void call();

  void work();
  /// False: the intake stops.
  bool take_in();
  /// Lets whose turn it is go on. False where it is nobody's, or the log has no room.
  bool take_turn();
  [[nodiscard]] std::optional<ClientId> next();
  [[nodiscard]] std::optional<ClientId> next(Turns& turns);
  [[nodiscard]] bool log_has_room() const;

  Lane& lane_of(const MailboxPtr& session);
  [[nodiscard]] Lane* find_lane(ClientId client);
  /// Its turn comes, where it has anything to do.
  void enter(Lane& lane);
  void end_input(Lane& lane);
  void forget_lane(ClientId client);
  void cancel_look_ups(const Lane& lane);

  void begin_attach(Lane& lane, AttachRequest request);
  void log_attach(Lane& lane);
  /// None where it is not known, or attached with another subject.
  [[nodiscard]] std::optional<edits::Editor> editor_of(edits::EditorId id, const std::string& subject) const;
  void attached(const Attached& answered);
  void end_attach(Lane& lane);
  void refuse_attach(Lane& lane, EditRefused why, std::string text);

  void take_look_ups(Lane& lane);
  /// One edit, as far as it goes.
  void advance(Lane& lane);
  /// None where it was refused.
  [[nodiscard]] std::optional<Prepared> prepare(const Lane& lane, Editing edit);
  /// False: it needs ground that is not generated for it.
  [[nodiscard]] bool look_up(const Lane& lane, Prepared& edit);
  /// Both refuse lane.first, and drop its look-ups.
  void refuse_half_closed(Lane& lane);
  void refuse_first(Lane& lane, EditRefused why, std::string text);
  void log_edit(const Lane& lane, Prepared edit);
  void refuse(const MailboxPtr& session, std::uint32_t id, EditRefused why, std::string text);
  /// Any thread. Where there is no memory for it the session ends, and its client asks again.
  static void tell(const MailboxPtr& session, Mail mail) noexcept;

  /// `done` as EditLog::Done, which it is a part of.
  template <typename Done>
  [[nodiscard]] tl::expected<void, LogFailure> append(LogEntry entry, Done done);

  const Parts parts_;
  const Rules rules_;
  const Logger log_;

  // From other threads.
  std::mutex mutex_;
  std::condition_variable comes_;
  bool called_ = false;
  bool stopping_ = false;
  std::vector<Came> came_;
  std::vector<Attached> attached_;
  std::vector<ClientId> input_ended_;
  std::vector<ClientId> forgotten_;
  std::unordered_set<std::uint64_t> looked_up_;  // owners of look-ups with mail

  std::atomic<std::size_t> waiting_{0};
  std::atomic<std::size_t> log_entries_{0};
  std::atomic<std::size_t> log_bytes_{0};
  std::atomic<bool> wants_room_{false};
  std::atomic<std::size_t> base_limit_{kBaseBytes};
  std::atomic<std::size_t> base_bytes_{0};  // as of the last turn

  std::atomic<bool> started_{false};
  std::mutex work_;                        // held while the thread works; locked before mutex_
  std::atomic<bool> thread_works_{false};  // holds that, or is about to

  // Of who holds that.
  std::vector<Came> taken_in_;  // and has no lane yet
  std::unordered_map<ClientId, Lane> lanes_;
  std::unordered_multimap<edits::EditorId, ClientId> attaching_as_;
  Turns small_;
  Turns large_;
  bool small_went_ = false;  // last
  DecodedBases bases_{kBaseBytes};

  std::thread thread_;
};

template <typename Done>
tl::expected<void, LogFailure> EditIntake::append(LogEntry entry, Done done) {
  const std::size_t bytes = bytes_of(entry);
  const auto leaves = [this, bytes] {
    --log_entries_;
    log_bytes_ -= bytes;
  };
  ++log_entries_;
  log_bytes_ += bytes;
  auto taken =
      parts_.log.append(std::move(entry), [this, leaves, done = std::move(done)](const auto& outcome) {
        done(outcome);
        leaves();
        if (wants_room_.exchange(false)) call();
      });
  if (!taken) leaves();
  return taken;
}

}  // namespace talus::server
