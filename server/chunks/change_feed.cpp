#include "chunks/change_feed.h"

#include <algorithm>
#include <exception>
#include <memory>
#include <new>
#include <utility>

#include "runtime/signals.h"

namespace talus::server {

ChangeFeed::~ChangeFeed() {
  {
    const std::lock_guard lock{gathering_};
    stopping_ = true;
  }
  changed_.notify_all();
  if (thread_.joinable()) thread_.join();
}

void ChangeFeed::start() {
  thread_ = std::thread{[this] { run(); }};
}

void ChangeFeed::run() {
  block_signals();
  std::unique_lock lock{gathering_};
  for (;;) {
    thread_waits_ = true;
    changed_.wait(lock, [this] { return stopping_ || has_gathered(); });
    thread_waits_ = false;
    if (stopping_) return;
    lock.unlock();
    send();
    lock.lock();
    auto left = kInterval;
    if (has_held()) {
      changed_.wait_for(lock, kWithAnswer, [this] { return stopping_; });
      lock.unlock();
      wake_held();
      lock.lock();
      left -= kWithAnswer;
    }
    changed_.wait_for(lock, left, [this] { return stopping_; });
  }
}

void ChangeFeed::on_changed(std::span<const ChunkChange> changes) noexcept {
  if (changes.empty()) return;
  bool wakes = false;
  {
    const std::lock_guard lock{gathering_};
    wakes = thread_waits_ && !has_gathered();
    try {
      for (const ChunkChange& change : changes) {
        if (any_changed_) break;
        const auto [known, is_new] = gathered_.try_emplace(change.key, change);
        if (!is_new) known->second.revision = change.revision;
        any_changed_ = gathered_.size() > kMaxGathered;
      }
    } catch (const std::bad_alloc&) {
      any_changed_ = true;
    }
    if (any_changed_) gathered_.clear();
  }
  if (wakes) changed_.notify_one();
}

void ChangeFeed::send() {
  std::unordered_map<ChunkKey, ChunkChange> gathered;
  bool any = false;
  {
    const std::lock_guard lock{gathering_};
    gathered.swap(gathered_);
    any = std::exchange(any_changed_, false);
  }
  if (gathered.empty() && !any) return;
  std::vector<Notification> notifications;
  try {
    if (any) {
      notifications = notify_all();
    } else {
      std::vector<ChunkChange> changes;
      changes.reserve(gathered.size());
      for (const auto& [key, change] : gathered) changes.push_back(change);
      notifications = notify_watchers(changes);
    }
  } catch (const std::bad_alloc&) {
    log_->error("no memory to notify sessions of {} edited chunks; retrying", gathered.size());
    const std::lock_guard lock{gathering_};
    any_changed_ = true;
    return;
  }
  for (const auto& [mailbox, changes] : notifications) {
    try {
      mailbox->put_changes(changes);
      if (mailbox->expects_answer()) {
        held_.push_back(mailbox);
      } else {
        mailbox->wake();
      }
    } catch (const std::exception& error) {
      lose(*mailbox, error);
    }
  }
}

void ChangeFeed::wake_held() {
  for (const MailboxPtr& mailbox : held_) {
    try {
      mailbox->wake();
    } catch (const std::exception& error) {
      lose(*mailbox, error);
    }
  }
  held_.clear();
}

void ChangeFeed::lose(Mailbox& mailbox, const std::exception& error) const {
  mailbox.lose_mail();
  log_->error("changes could not be sent: {}", error.what());
}

std::vector<ChangeFeed::Notification> ChangeFeed::notify_all() {
  std::vector<Notification> notifications;
  const std::lock_guard lock{watching_};
  notifications.reserve(watchers_.size());
  for (const auto& [client, watcher] : watchers_) notifications.push_back({watcher.mailbox, nullptr});
  return notifications;
}

std::vector<ChangeFeed::Notification> ChangeFeed::notify_watchers(std::span<const ChunkChange> changes) {
  std::vector<Notification> notifications;
  std::vector<Watcher*> watchers;
  const std::lock_guard lock{watching_};
  try {
    for (const ChunkChange& change : changes) find_watchers(change, watchers);
    notifications.reserve(watchers.size());
    for (Watcher* const watcher : watchers) {
      notifications.push_back(
          {watcher->mailbox, std::make_shared<const std::vector<ChunkChange>>(watcher->own)});
    }
  } catch (const std::bad_alloc&) {
    for (auto& [client, watcher] : watchers_) watcher.own.clear();
    throw;
  }
  for (Watcher* const watcher : watchers) watcher->own.clear();
  return notifications;
}

void ChangeFeed::find_watchers(const ChunkChange& change, std::vector<Watcher*>& watchers) {
  for (int scale = 0; scale < BoxCell::kScales; ++scale) {
    if (entries_of_scale_[static_cast<std::size_t>(scale)] == 0) continue;
    const auto cell = cells_.find(BoxCell::of(change.key, scale));
    if (cell == cells_.end()) continue;
    for (Watcher* const watcher : cell->second) {
      const auto has = [&](const LevelBox& box) {
        return box.lod == change.key.lod && box.contains(change.key.coord);
      };
      // Two of its boxes may be in one cell.
      const bool known = !watcher->own.empty() && watcher->own.back().key == change.key;
      if (known || std::none_of(watcher->boxes.begin(), watcher->boxes.end(), has)) continue;
      watcher->own.push_back(change);
      if (watcher->own.size() == 1) watchers.push_back(watcher);
    }
  }
}

void ChangeFeed::watch(const MailboxPtr& mailbox, std::span<const LevelBox> boxes) {
  const std::lock_guard lock{watching_};
  if (const auto known = watchers_.find(mailbox->owner()); known != watchers_.end()) {
    const std::vector<LevelBox>& before = known->second.boxes;
    if (std::equal(boxes.begin(), boxes.end(), before.begin(), before.end())) return;
    remove(known->second);
    watchers_.erase(known);
  }
  if (boxes.empty()) return;
  const auto added = watchers_.try_emplace(mailbox->owner()).first;
  Watcher& watcher = added->second;
  try {
    watcher.boxes.assign(boxes.begin(), boxes.end());
    watcher.mailbox = mailbox;
    for (const LevelBox& box : boxes) {
      for_each_cell(box, [&](const BoxCell& cell) {
        cells_[cell].push_back(&watcher);
        ++entries_of_scale_[static_cast<std::size_t>(cell.scale)];
      });
    }
  } catch (...) {
    remove(watcher);
    watchers_.erase(added);
    throw;
  }
}

void ChangeFeed::remove(const Watcher& watcher) {
  for (const LevelBox& box : watcher.boxes) {
    for_each_cell(box, [&](const BoxCell& cell) {
      const auto found = cells_.find(cell);
      if (found == cells_.end()) return;
      entries_of_scale_[static_cast<std::size_t>(cell.scale)] -= std::erase(found->second, &watcher);
      if (found->second.empty()) cells_.erase(found);
    });
  }
}

std::size_t ChangeFeed::watchers() const {
  const std::lock_guard lock{watching_};
  return watchers_.size();
}

}  // namespace talus::server
