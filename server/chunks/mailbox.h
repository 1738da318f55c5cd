// What other threads tell a session: chunks, heights, that the generators' queue has room again, which chunks
// were edited, and what became of its own edits.
//
// One mailbox a session. Generator threads put() answers and wake() the owner; the owner takes all that
// waits at once. Waking a thread costs as much as generating many a chunk, so put() does not wake, and a
// wake() while one is pending does nothing.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <iterator>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <tl/expected.hpp>

#include <talus/voxel/coords.h>

#include "chunks/chunk_change.h"
#include "chunks/edit_answers.h"
#include "chunks/encoded_chunk.h"
#include "chunks/heights_query.h"
#include "limits/flows/flow_use.h"

namespace talus::server {

/// Who waits for chunks. Never used twice in one process, so nobody inherits another's place or debt.
enum class ClientId : std::uint64_t {};

/// The generator could not answer (out of memory); asking again may help.
struct GenerationFailed {
  std::string reason;
};
using ChunkAnswer = tl::expected<EncodedChunkPtr, GenerationFailed>;
using HeightsAnswer = tl::expected<HeightsFound, GenerationFailed>;

struct ChunkReady {
  ChunkKey key;
  ChunkAnswer answer;
};
struct HeightsReady {
  std::uint64_t ticket = 0;
  HeightsAnswer answer;
};
/// A submission was refused because the queue was full; it may be tried again.
struct QueueHasRoom {};
/// Chunks were edited, the owner's and others. Null: any may have been. Their source says so already.
struct ChunksChanged {
  ChunkChangesPtr changes;
};
using Mail = std::variant<ChunkReady, HeightsReady, QueueHasRoom, ChunksChanged, AttachAnswer, EditAnswer>;

class Mailbox {
 public:
  /// `wake` is called on the thread that calls wake(), never twice without a take() between. It may throw;
  /// then the owner counts as not woken.
  Mailbox(ClientId owner, std::function<void()> wake)
      : Mailbox{owner, std::move(wake),
                std::make_shared<FlowUse>(FlowId{static_cast<std::uint64_t>(owner)}, FlowName{})} {}
  Mailbox(ClientId owner, std::function<void()> wake, FlowUsePtr flow)
      : owner_{owner}, flow_{std::move(flow)}, wake_{std::move(wake)} {}

  [[nodiscard]] ClientId owner() const { return owner_; }
  /// In whose turns the owner's chunks are generated; one of its own where none was given.
  [[nodiscard]] FlowId flow() const { return flow_->id(); }
  /// To which is added what that costs.
  [[nodiscard]] const FlowUsePtr& flow_use() const { return flow_; }
  /// Before the owner asks any source for anything.
  void join(FlowUsePtr flow) { flow_ = std::move(flow); }

  /// Whether chunks come to it with their edits; a source that has edits says so before it submits anything.
  [[nodiscard]] bool sees_edits() const { return sees_edits_; }
  void see_edits() { sees_edits_ = true; }

  /// Any thread. The owner finds it at its next take().
  void put(Mail mail) {
    const std::lock_guard lock{mutex_};
    mail_.push_back(std::move(mail));
  }

  /// As many at once. Throws std::bad_alloc, and then `mail` is what it was.
  void put(std::vector<Mail>&& mail) {
    const std::lock_guard lock{mutex_};
    if (mail_.empty()) {
      mail_ = std::move(mail);
    } else {
      mail_.insert(mail_.end(), std::make_move_iterator(mail.begin()), std::make_move_iterator(mail.end()));
    }
  }

  /// So many changes wait at most. What comes beyond them turns all into one ChunksChanged of any chunk,
  /// which an owner that takes its mail late reads for less.
  static constexpr std::size_t kMaxChanges = 4096;
  /// Any thread. `changes` null: any chunk may have changed. Throws std::bad_alloc, and then nothing was put.
  void put_changes(const ChunkChangesPtr& changes) {
    const std::lock_guard lock{mutex_};
    if (any_changed_) return;
    const bool any = changes == nullptr || changes_ + changes->size() > kMaxChanges;
    mail_.push_back(ChunksChanged{any ? nullptr : changes});
    if (any) {
      any_changed_ = true;
      std::erase_if(mail_, [](const Mail& mail) {
        const auto* const changed = std::get_if<ChunksChanged>(&mail);
        return changed != nullptr && changed->changes != nullptr;
      });
    } else {
      changes_ += changes->size();
    }
  }

  /// Any thread. Wakes the owner where mail waits, or was lost, and no wake-up is pending.
  void wake() {
    {
      const std::lock_guard lock{mutex_};
      if ((mail_.empty() && !lost_) || std::exchange(woken_, true)) return;
    }
    try {
      wake_();
    } catch (...) {
      const std::lock_guard lock{mutex_};
      woken_ = false;
      throw;
    }
  }

  /// The owner's thread: whether the log is to answer an edit of it.
  void expect_answer(bool expects) noexcept { expects_answer_.store(expects, std::memory_order_relaxed); }
  /// Any thread. Then it is about to be woken, and what is put until then costs it no turn of its own.
  [[nodiscard]] bool expects_answer() const noexcept {
    return expects_answer_.load(std::memory_order_relaxed);
  }

  /// Any thread. There is no memory for mail that the owner waits for. Wakes the owner, who may wait for
  /// nothing else; where that fails the next wake() does.
  void lose_mail() noexcept {
    lost_ = true;
    try {
      wake();
    } catch (const std::exception&) {
    }
  }
  /// Whether mail was lost: what the owner waits for may never come.
  [[nodiscard]] bool has_lost() const noexcept { return lost_; }

  /// The owner's thread. All that waits, oldest first. `memory`, which is empty, is used for what comes next.
  [[nodiscard]] std::vector<Mail> take(std::vector<Mail> memory = {}) {
    const std::lock_guard lock{mutex_};
    woken_ = false;
    changes_ = 0;
    any_changed_ = false;
    return std::exchange(mail_, std::move(memory));
  }

 private:
  const ClientId owner_;
  FlowUsePtr flow_;
  bool sees_edits_ = false;  // changes before anything is submitted
  const std::function<void()> wake_;
  std::mutex mutex_;
  std::vector<Mail> mail_;
  std::size_t changes_ = 0;   // in all lists of mail_
  bool any_changed_ = false;  // a ChunksChanged without a list is in mail_
  bool woken_ = false;
  std::atomic<bool> lost_{false};
  std::atomic<bool> expects_answer_{false};
};
using MailboxPtr = std::shared_ptr<Mailbox>;

}  // namespace talus::server
