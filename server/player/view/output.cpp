#include "player/view/output.h"

#include <array>
#include <utility>

namespace talus::server {
namespace {

// Larger buffers are freed: an output of a few bytes may hold a spare one for as long as its client reads
// nothing.
constexpr std::size_t kMaxSpareBytes = std::size_t{32} * 1024;

/// Spare buffers of one thread: usually as many as are written at once. An array, so that keeping one needs
/// no allocation.
struct Spares {
  std::array<std::vector<std::byte>, 4> memory;
  std::size_t count = 0;
};

Spares& spares() {
  thread_local Spares mine;
  return mine;
}

}  // namespace

Output::Output(std::size_t shared_from) : shared_from_{shared_from} {
  Spares& spare = spares();
  if (spare.count > 0) copied_ = std::move(spare.memory[--spare.count]);
}

Output::~Output() {
  Spares& spare = spares();
  if (copied_.capacity() == 0 || copied_.capacity() > kMaxSpareBytes || spare.count == spare.memory.size())
    return;
  copied_.clear();
  spare.memory[spare.count++] = std::move(copied_);
}

void Output::append(std::span<const std::byte> frame) {
  copied_.insert(copied_.end(), frame.begin(), frame.end());
  size_ += frame.size();
}

void Output::append(const EncodedChunkPtr& chunk, std::uint32_t request_id, ChunkKey key) {
  if (chunk->frame_bytes() < shared_from_) {
    chunk->append_frame(copied_, request_id, key);
  } else {
    chunk->append_head(copied_, request_id, key);
    shared_.push_back({copied_.size(), chunk});
  }
  size_ += chunk->frame_bytes();
}

std::vector<std::span<const std::byte>> Output::pieces() const {
  std::vector<std::span<const std::byte>> pieces;
  pieces.reserve(2 * shared_.size() + 1);
  const std::span copied{copied_};
  std::size_t from = 0;
  for (const SharedChunk& shared : shared_) {
    pieces.push_back(copied.subspan(from, shared.after - from));
    pieces.push_back(shared.chunk->tail());
    from = shared.after;
  }
  if (from < copied.size()) pieces.push_back(copied.subspan(from));
  return pieces;
}

}  // namespace talus::server
