// Prepares edits for the log: checks the bounds of the world, and looks up the base of every voxel that they
// touch, so that applying them never generates. Edits of one session go to the log in order of arrival, and
// never wait for edits of other sessions.
//
// At most kLogEntries edits are queued in the log; the rest wait here, per session, so a flooding session
// delays only itself.
//
// One thread. Chunks that are not in memory are generated in the turns of the session's flow. A small edit
// needs neither a turn nor that thread if its session has no other in progress and its chunks are decoded:
// while the thread is idle the edit goes to the log on the calling thread.
//
// Calls from other threads are in edit_intake.cpp; turns, Attaches and edits have files of their own.
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
#include "edits/edit_taker.h"
#include "limits/flows/fair_queue.h"
#include "runtime/clock.h"
#include "runtime/log/logger.h"
#include "runtime/metrics/metrics.h"

namespace talus::server {

class EditIntake final : public EditTaker {
 public:
  /// All outlive this. `editor` reads the applied state, on any thread.
  struct Parts {
    ChunkSource& base;  // for chunks as generated
    EditLog& log;
    std::function<std::optional<edits::Editor>(edits::EditorId)> editor;
    const Clock& clock;
    Metrics& metrics;
    /// Fails if the applied state has no room for another editor; any thread. Null: it always has.
    std::function<tl::expected<void, EditError>()> room_for_editor{};
  };
  /// Bounds of the world.
  struct Rules {
    HeightRange rows;
    std::vector<MaterialId> materials;  // writable ones, by ascending id
    edits::SettleRulesPtr settles{};    // null: nothing slides
    /// Secret materials of chunks, and those that hide nothing, by ascending id; null: no secrets.
    DecodedBases::Hidden hidden{};
    std::vector<MaterialId> see_through{};
  };
  /// Maximum bytes of decoded chunks.
  static constexpr std::size_t kBaseBytes = std::size_t{16} << 20;
  /// Maximum entries and bytes in the log, queued and being written: enough for two batches to be worth their
  /// syncs. A single entry may have more bytes. A small edit of a session without an entry in the log is
  /// exempt, so that it joins the next batch.
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
  /// Ends the thread. Edits that are not logged yet are not answered, and neither are later ones.
  void stop();

  /// EditLog::takes_entries() has changed: resumes edits that wait for room in the log. Any thread.
  void resume() { call(); }

  /// Lowers the maximum of decoded chunks from kBaseBytes to `bytes`. Any thread.
  void limit_bases(std::size_t bytes);
  /// Bytes of decoded chunks. Any thread.
  [[nodiscard]] std::size_t base_bytes() const { return base_bytes_.load(std::memory_order_relaxed); }

  /// Handles everything that waits, as far as the log has room. The thread calls it.
  void do_what_waits();

  void attach(const MailboxPtr& mailbox, AttachRequest request) override;
  void edit(const MailboxPtr& mailbox, EditRequest request) override;
  void input_ended(ClientId client) override;
  void forget(ClientId client) override;
  [[nodiscard]] bool knows(edits::EditorId id, const std::string& subject) const override;
  /// Counts a refusal.
  [[nodiscard]] tl::expected<void, EditError> room_for_editor() const override;
  [[nodiscard]] bool settles() const override { return rules_.settles != nullptr; }
  [[nodiscard]] bool reveals() const override { return rules_.hidden != nullptr; }

  /// Number of edits and Attaches that wait here. Any thread.
  [[nodiscard]] std::size_t waiting() const { return waiting_.load(std::memory_order_relaxed); }

 private:
  /// An Attach that is not answered.
  struct PendingAttach {
    AttachRequest request;
    edits::EditorId editor;  // in its entry of the log
    bool known = false;
    bool overtaken = false;  // by a later one for the same editor
    int tries = 0;
  };
  struct WaitingEdit {
    EditRequest request;
    Clock::time_point received_at;
  };
  /// An edit whose base is being looked up.
  struct Preparation {
    WaitingEdit edit;
    std::vector<edits::TouchedChunk> touched;   // computed once, and kept for the log's entry
    std::vector<edits::TouchedChunk> settling;  // with voxels that may slide; empty if settling is off
    edits::BaseVoxels base;
    std::set<ChunkCoord> missing;               // chunks not looked up yet
    std::set<ChunkCoord> asked;                 // missing chunks that the source has accepted
    std::vector<edits::TouchedChunk> around{};  // with voxels that it may reveal; empty without secrets
    edits::SecretVoxels secrets{};

    /// The voxels that `base` needs.
    [[nodiscard]] const std::vector<edits::TouchedChunk>& needed() const {
      return settling.empty() ? touched : settling;
    }
    /// The voxels to look up.
    [[nodiscard]] const std::vector<edits::TouchedChunk>& looked_up() const {
      return around.empty() ? needed() : around;
    }
    /// Takes what it needs of a chunk of looked_up().
    void take(ChunkCoord coord, const DecodedBase& base);
  };
  /// The queue of one session.
  struct Lane {
    MailboxPtr session;
    MailboxPtr look_ups;
    std::deque<WaitingEdit> waiting;
    std::optional<Preparation> first;        // before `waiting`
    std::optional<PendingAttach> attaching;  // before all edits
    bool attach_waits = false;               // and is not in the log
    bool entered = false;                    // waits for its turn
    bool may_log = false;                    // in that turn
    std::size_t cost = 0;                    // of that turn
    bool input_ended = false;
    /// Number of its edits that the log has not answered.
    std::shared_ptr<std::atomic<std::uint32_t>> in_log = std::make_shared<std::atomic<std::uint32_t>>(0);
  };
  /// Flows have equal shares by what their edits cost, and so have the sessions of a flow. Costs are known,
  /// so that a small edit does not wait for large ones. Ground that was looked up is decoded in turns, too.
  using Turns = FairQueue<FlowId, ClientId>;
  using Arrival = std::pair<MailboxPtr, std::variant<AttachRequest, WaitingEdit>>;
  /// The log's answer to an Attach.
  struct AttachOutcome {
    ClientId client{};
    tl::expected<edits::EntryResult::Kind, EditError> outcome;
    EditorSession as;  // if attached; without `known`
  };

  /// Logs or refuses the edit on the calling thread. Returns false, without any effect, if the intake's
  /// thread has to.
  [[nodiscard]] bool log_at_once(const MailboxPtr& session, EditRequest& request);
  /// Wakes the intake's thread. Any thread.
  void call();

  void work();
  /// Returns false if the intake stops.
  bool take_in();
  /// Continues the lane whose turn it is. Returns false if all are idle or the log has no room.
  bool take_turn();
  [[nodiscard]] std::optional<ClientId> next();
  [[nodiscard]] std::optional<ClientId> next(Turns& turns);
  [[nodiscard]] bool log_has_room() const;

  Lane& lane_of(const MailboxPtr& session);
  [[nodiscard]] Lane* find_lane(ClientId client);
  /// Queues the lane for a turn if it has work.
  void enter(Lane& lane);
  void end_input(Lane& lane);
  void forget_lane(ClientId client);
  void cancel_look_ups(const Lane& lane);

  void begin_attach(Lane& lane, AttachRequest request);
  void log_attach(Lane& lane);
  /// nullopt if it does not exist or belongs to another subject.
  [[nodiscard]] std::optional<edits::Editor> editor_of(edits::EditorId id, const std::string& subject) const;
  void attached(const AttachOutcome& answered);
  void end_attach(Lane& lane);
  void refuse_attach(Lane& lane, EditError error);

  /// Decodes the chunks that came.
  void take_look_ups(Lane& lane);
  /// Takes one edit as far as possible without blocking.
  void advance(Lane& lane);
  /// Checks the bounds of the world and of edits. Returns the voxels that the edit touches.
  [[nodiscard]] tl::expected<std::vector<edits::TouchedChunk>, EditError> admit(
      const edits::Edit& edit) const;
  /// Sets `around`, if the world has secrets. An error if that reaches too many chunks.
  [[nodiscard]] tl::expected<void, EditError> look_around(Preparation& edit) const;
  /// nullopt if it was refused.
  [[nodiscard]] std::optional<Preparation> prepare(const Lane& lane, WaitingEdit edit);
  /// Returns false if it needs chunks that are no longer generated for this session.
  [[nodiscard]] bool look_up(const Lane& lane, Preparation& edit);
  /// Both refuse lane.first, and cancel its look-ups.
  void refuse_half_closed(Lane& lane);
  void refuse_first(Lane& lane, EditError error);
  void log_edit(const Lane& lane, Preparation edit);
  void refuse(const MailboxPtr& session, std::uint32_t id, EditError error);
  /// Any thread. If there is no memory for the mail the session ends, and its client retries.
  static void send(const MailboxPtr& session, Mail mail) noexcept;

  /// `done` is called as part of an EditLog::Callback.
  template <typename Callback>
  [[nodiscard]] tl::expected<void, EditError> append(LogEntry entry, Callback done);

  const Parts parts_;
  const Rules rules_;
  const Logger log_;

  // From other threads.
  std::mutex mutex_;
  std::condition_variable comes_;
  bool called_ = false;
  bool stopping_ = false;
  std::vector<Arrival> arrivals_;
  std::vector<AttachOutcome> attached_;
  std::vector<ClientId> input_ended_;
  std::vector<ClientId> forgotten_;
  std::unordered_set<std::uint64_t> looked_up_;  // clients whose look-ups have mail

  std::atomic<std::size_t> waiting_{0};
  std::atomic<std::size_t> log_entries_{0};
  std::atomic<std::size_t> log_bytes_{0};
  std::atomic<bool> wants_room_{false};
  std::atomic<std::size_t> base_limit_{kBaseBytes};
  std::atomic<std::size_t> base_bytes_{0};  // as of the last turn

  std::atomic<bool> started_{false};
  std::mutex work_;                        // held while the thread works; locked before mutex_
  std::atomic<bool> thread_works_{false};  // holds work_, or is about to

  // Guarded by work_.
  std::vector<Arrival> taken_in_;  // without a lane yet
  std::unordered_map<ClientId, Lane> lanes_;
  std::unordered_multimap<edits::EditorId, ClientId> attaching_as_;
  Turns small_;
  Turns large_;
  bool small_went_ = false;  // the last turn was of small_
  DecodedBases bases_;

  std::thread thread_;
};

template <typename Callback>
tl::expected<void, EditError> EditIntake::append(LogEntry entry, Callback done) {
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
