#include "stream/outbox.h"

#include <utility>

#include "stream/chunk_frame.h"

namespace talus::server {
namespace {

// A small frame costs more than its bytes: its vector and what the allocator adds.
constexpr std::size_t kFrameOverheadBytes = 48;

}  // namespace

void Outbox::push_control(protocol::Frame frame) {
  control_bytes_ += frame.size() + kFrameOverheadBytes;
  control_.push_back(std::move(frame));
}

void Outbox::push_chunk(Entry entry) {
  chunk_bytes_ += cost(*entry.chunk);
  chunks_.push_back(std::move(entry));
}

bool Outbox::sendable(const Credit& credit) const {
  return !control_.empty() || (!chunks_.empty() && credit.may_send());
}

Outbox::Taken Outbox::take(std::size_t enough_bytes, Credit& credit, ChunkAllowance allowance) {
  Taken taken;
  std::size_t bytes = 0;
  while (!control_.empty() && bytes < enough_bytes) {
    bytes += control_.front().size();
    control_bytes_ -= control_.front().size() + kFrameOverheadBytes;
    taken.frames.push_back(std::move(control_.front()));
    control_.pop_front();
  }
  while (!chunks_.empty() && bytes < enough_bytes && credit.may_send() &&
         taken.chunks.size() < allowance.chunks && taken.chunk_bytes < allowance.bytes) {
    Entry entry = std::move(chunks_.front());
    chunks_.pop_front();
    chunk_bytes_ -= cost(*entry.chunk);
    taken.frames.push_back(chunk_frame(entry.request_id, entry.key, *entry.chunk));
    credit.sent(taken.frames.back().size());
    bytes += taken.frames.back().size();
    taken.chunk_bytes += taken.frames.back().size();
    taken.chunks.push_back(std::move(entry));
  }
  taken.bytes = bytes;
  return taken;
}

std::size_t Outbox::cost(const EncodedChunk& chunk) {
  return sizeof(Entry) + sizeof(EncodedChunk) + chunk.payload.size();
}

}  // namespace talus::server
