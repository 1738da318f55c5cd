// Mail from other threads to a session: chunks, heights, room in the generators' queue, changes of chunks,
// and the outcome of the session's own edits.
//
// One mailbox per session. Generator threads put() answers and wake() the owner; the owner takes all its mail
// at once. Waking a thread costs as much as generating several chunks, so put() does not wake, and a wake()
// while one is pending does nothing.
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

/// A client that waits for chunks. Never used twice in one process, so that no client inherits another's
/// place or debt.
enum class ClientId : std::uint64_t {};

/// The generator failed (out of memory); a retry may succeed.
struct GenerationError {
  std::string reason;
};
using ChunkAnswer = tl::expected<EncodedChunkPtr, GenerationError>;
using HeightsAnswer = tl::expected<HeightsResult, GenerationError>;

struct ChunkReady {
  ChunkKey key;
  ChunkAnswer answer;
};
struct HeightsReady {
  std::uint64_t ticket = 0;
  HeightsAnswer answer;
};
/// The queue was full when the owner submitted; a retry may succeed now.
struct QueueHasRoom {};
/// Chunks were edited, by the owner or by others. Null: any chunk may have changed. Their source returns the
/// new revisions already.
struct ChunksChanged {
  ChunkChangesPtr changes;
};
using Mail = std::variant<ChunkReady, HeightsReady, QueueHasRoom, ChunksChanged, AttachAnswer, EditAnswer>;

class Mailbox {
 public:
  /// `wake` is called on the thread that calls wake(), never twice without a take() in between. If it throws,
  /// the owner counts as not woken.
  Mailbox(ClientId owner, std::function<void()> wake)
      : Mailbox{owner, std::move(wake),
                std::make_shared<FlowUse>(FlowId{static_cast<std::uint64_t>(owner)}, FlowName{})} {}
  Mailbox(ClientId owner, std::function<void()> wake, FlowUsePtr flow)
      : owner_{owner}, flow_{std::move(flow)}, wake_{std::move(wake)} {}

  [[nodiscard]] ClientId owner() const { return owner_; }
  /// The flow in whose turns the owner's chunks are generated; one of its own by default.
  [[nodiscard]] FlowId flow() const { return flow_->id(); }
  /// The flow charged for that work.
  [[nodiscard]] const FlowUsePtr& flow_use() const { return flow_; }
  /// Call it before the owner submits anything to a source.
  void join(FlowUsePtr flow) { flow_ = std::move(flow); }

  /// Any thread. The owner's next take() returns it.
  void put(Mail mail) {
    const std::lock_guard lock{mutex_};
    mail_.push_back(std::move(mail));
  }

  /// Puts all of `mail`. Throws std::bad_alloc, and then `mail` is unchanged.
  void put(std::vector<Mail>&& mail) {
    const std::lock_guard lock{mutex_};
    if (mail_.empty()) {
      mail_ = std::move(mail);
    } else {
      mail_.insert(mail_.end(), std::make_move_iterator(mail.begin()), std::make_move_iterator(mail.end()));
    }
  }

  /// Maximum queued changes. On overflow they collapse into one ChunksChanged without a list ("any chunk may
  /// have changed"), which costs an owner less that takes its mail late.
  static constexpr std::size_t kMaxChanges = 4096;
  /// Any thread. `changes` null: any chunk may have changed. Throws std::bad_alloc, and then has no effect.
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

  /// Any thread. Wakes the owner if there is mail, or mail was lost, and no wake-up is pending.
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

  /// The owner's thread. True: the log is about to answer an edit of the owner.
  void expect_answer(bool expects) noexcept { expects_answer_.store(expects, std::memory_order_relaxed); }
  /// Any thread. If true, the owner is about to be woken, and mail put until then needs no wake-up of its
  /// own.
  [[nodiscard]] bool expects_answer() const noexcept {
    return expects_answer_.load(std::memory_order_relaxed);
  }

  /// Any thread. Records that there was no memory for mail for which the owner waits, and wakes the owner,
  /// which may wait for nothing else; if that fails, the next wake() does.
  void lose_mail() noexcept {
    lost_ = true;
    try {
      wake();
    } catch (const std::exception&) {
    }
  }
  /// True if mail was lost: an answer for which the owner waits may never come.
  [[nodiscard]] bool has_lost() const noexcept { return lost_; }

  /// The owner's thread. Returns all mail, oldest first. `memory`, which is empty, holds the mail that comes
  /// next.
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

/// A client that waits for a chunk in this version.
struct Waiter {
  MailboxPtr mailbox;
  Version version = Version::generated;
  bool operator==(const Waiter&) const = default;
};

}  // namespace talus::server
