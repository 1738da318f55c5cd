#include "view/output.h"

namespace talus::server {

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
  for (const Shared& shared : shared_) {
    pieces.push_back(copied.subspan(from, shared.after - from));
    pieces.push_back(shared.chunk->tail());
    from = shared.after;
  }
  if (from < copied.size()) pieces.push_back(copied.subspan(from));
  return pieces;
}

}  // namespace talus::server
