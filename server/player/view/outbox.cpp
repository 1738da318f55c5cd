#include "player/view/outbox.h"

#include <utility>

namespace talus::server {
namespace {

// Of a frame beside its bytes: its vector, and what the allocator adds.
constexpr std::size_t kFrameOverheadBytes = 48;

}  // namespace

void Outbox::push_control(protocol::Frame frame) {
  control_bytes_ += frame.size() + kFrameOverheadBytes;
  control_.push_back(std::move(frame));
}

void Outbox::push_chunk(Entry&& entry) {
  entry.chunk->prefetch();  // it is written soon, among others that lie as far apart in memory
  Queue& lane = entry.request_id == 0 ? view_ : requests_;
  lane.bytes += cost(*entry.chunk);
  lane.entries.push_back(std::move(entry));
}

bool Outbox::sendable(const Credit& credit) const {
  const bool waits = updates() > 0 || !requests_.entries.empty() || !view_.entries.empty();
  return !control_.empty() || (waits && credit.may_send());
}

void Outbox::take_control(std::size_t enough_bytes, Output& output) {
  while (!control_.empty() && output.size() < enough_bytes) {
    const protocol::Frame& frame = control_.front();
    output.append(frame);
    control_bytes_ -= frame.size() + kFrameOverheadBytes;
    control_.pop_front();
  }
}

std::size_t Outbox::bytes_to_copy(std::size_t shared_from) const {
  constexpr std::size_t kHeadBytes = 160;  // more than what stands before a chunk's payload
  const std::size_t count = chunks(Lane::requests) + chunks(Lane::view);
  const bool shares = shared_from == 0 || chunk_bytes() / shared_from > count;
  return control_bytes_ + (shares ? kHeadBytes * count : chunk_bytes());
}

}  // namespace talus::server
