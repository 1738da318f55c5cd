// What the tests of the work queue share.
#pragma once

#include <catch2/catch.hpp>
#include <cstdint>
#include <memory>
#include <utility>
#include <variant>

#include "chunks/generation/work_queue.h"

namespace talus::server {

/// Of a client that nobody wakes; each has an id and a flow of its own.
inline MailboxPtr client_box() {
  static std::uint64_t last = 0;
  return std::make_shared<Mailbox>(ClientId{++last}, [] {});
}

/// Of a client in that flow.
inline MailboxPtr client_box(FlowId flow) {
  auto box = client_box();
  box->join(std::make_shared<FlowUse>(flow, FlowName{}));
  return box;
}

inline constexpr FlowId kFlow{1'000'000};
inline constexpr FlowId kOtherFlow{2'000'000};

inline ChunkKey at(std::int32_t x, std::int32_t y = 0) {
  return {{x, y, 0}, Lod{}};
}

inline WorkQueue::Batch take_batch(WorkQueue& queue) {
  auto work = queue.take();
  REQUIRE(work.has_value());
  return std::move(std::get<WorkQueue::Batch>(work->what));
}

inline bool add(WorkQueue& queue, const MailboxPtr& client, ChunkKey key) {
  return queue.add({client}, {&key, 1}) == 1;
}

/// Ends the job. Returns the mailboxes of its waiters.
inline std::vector<MailboxPtr> end_job(WorkQueue& queue, ChunkKey key) {
  std::vector<MailboxPtr> mailboxes;
  for (const Waiter& waiter : queue.finish(key)) mailboxes.push_back(waiter.mailbox);
  return mailboxes;
}

inline constexpr int kPatch = 4;

}  // namespace talus::server
