#include "web/fetch.h"

#include <algorithm>
#include <utility>
#include <variant>

#include <asio/post.hpp>

namespace talus::server::web {

Fetch::Fetch(const asio::any_io_executor& executor, ChunkSource& chunks, const Clock& clock, ClientId owner,
             FlowUsePtr flow)
    : chunks_{chunks},
      clock_{clock},
      executor_{executor},
      owner_{owner},
      flow_{std::move(flow)},
      mail_{executor, clock} {}

const MailboxPtr& Fetch::mailbox() {
  if (mailbox_ == nullptr) {
    const auto wake = [executor = executor_, self = weak_from_this()] {
      asio::post(executor, [self] {
        if (const auto alive = self.lock()) alive->take_mail();
      });
    };
    mailbox_ = std::make_shared<Mailbox>(owner_, wake, flow_);
  }
  return mailbox_;
}

void Fetch::abandon() {
  gone_ = true;
  leave_queues();
  mail_.notify();
}

void Fetch::leave_queues() {
  if (mailbox_ == nullptr) return;
  std::vector<ChunkKey> unanswered;
  for (const auto& [key, chunk] : waits_) {
    if (chunk == nullptr) unanswered.push_back(key);
  }
  if (!unanswered.empty()) chunks_.cancel(owner_, unanswered);
  waits_.clear();
  missing_ = 0;
  if (ticket_) chunks_.cancel_heights(owner_, *std::exchange(ticket_, std::nullopt));
}

void Fetch::take_mail() {
  for (Mail& each : mailbox_->take()) {
    if (auto* const chunk = std::get_if<ChunkReady>(&each)) {
      const auto waiting = waits_.find(chunk->key);
      if (waiting == waits_.end() || waiting->second != nullptr) continue;
      --missing_;
      if (chunk->answer) {
        waiting->second = *std::move(chunk->answer);
      } else {
        waits_.erase(waiting);
        failed_ = true;
      }
    } else if (auto* const heights = std::get_if<HeightsReady>(&each)) {
      if (ticket_ != heights->ticket) continue;
      ticket_.reset();
      if (heights->answer) {
        heights_ = *std::move(heights->answer);
      } else {
        failed_ = true;
      }
    }
  }
  mail_.notify();
}

asio::awaitable<tl::expected<std::vector<EncodedChunkPtr>, FetchError>> Fetch::get(
    std::vector<ChunkKey> keys, Version version, Clock::time_point deadline) {
  const auto self = shared_from_this();
  std::vector<EncodedChunkPtr> chunks(keys.size());
  std::vector<ChunkKey> to_submit;
  failed_ = false;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    chunks[i] = chunks_.find(keys[i], version);
    if (chunks[i] == nullptr) to_submit.push_back(keys[i]);
  }
  while (!gone_ && !failed_ && (!to_submit.empty() || missing_ > 0)) {
    if (!to_submit.empty()) {
      const std::size_t taken = chunks_.submit(mailbox(), to_submit, Urgency::later, version);
      for (std::size_t i = 0; i < taken; ++i) waits_.emplace(to_submit[i], nullptr);
      missing_ += taken;
      to_submit.erase(to_submit.begin(), to_submit.begin() + static_cast<std::ptrdiff_t>(taken));
    }
    if (missing_ == 0 && to_submit.empty()) break;
    if (clock_.now() >= deadline) {
      const bool queued = missing_ > 0;
      leave_queues();
      co_return tl::make_unexpected(queued ? FetchError::late : FetchError::busy);
    }
    co_await mail_.wait_until(deadline);
  }
  for (std::size_t i = 0; !gone_ && !failed_ && i < keys.size(); ++i) {
    if (chunks[i] == nullptr) chunks[i] = waits_.at(keys[i]);
  }
  leave_queues();
  if (gone_) co_return tl::make_unexpected(FetchError::gone);
  if (failed_ || (mailbox_ != nullptr && mailbox_->has_lost())) {
    co_return tl::make_unexpected(FetchError::failed);
  }
  co_return chunks;
}

asio::awaitable<tl::expected<HeightsResult, FetchError>> Fetch::heights(HeightsQuery query,
                                                                        Clock::time_point deadline) {
  const auto self = shared_from_this();
  failed_ = false;
  heights_.reset();
  ticket_ = ++last_ticket_;
  chunks_.submit_heights(mailbox(), *ticket_, std::move(query));
  while (!gone_ && !failed_ && !heights_ && clock_.now() < deadline) co_await mail_.wait_until(deadline);
  leave_queues();
  if (gone_) co_return tl::make_unexpected(FetchError::gone);
  if (failed_) co_return tl::make_unexpected(FetchError::failed);
  if (!heights_) co_return tl::make_unexpected(FetchError::late);
  co_return *std::exchange(heights_, std::nullopt);
}

asio::awaitable<tl::expected<PicturePtr, FetchError>> Fetch::map(const map::Tile& tile,
                                                                 Clock::time_point deadline) {
  const auto self = shared_from_this();
  auto found = co_await heights({.tile = tile}, deadline);
  if (!found) co_return tl::make_unexpected(found.error());
  co_return std::move(found->picture);
}

}  // namespace talus::server::web
