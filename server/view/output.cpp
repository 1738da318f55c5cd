#include "view/output.h"

#include <utility>

namespace talus::server {
namespace {

// Of one thread: as many as are written at once, as a rule. No larger than a usual write, because an output
// of a few bytes may hold one of them for as long as its client reads nothing.
constexpr std::size_t kMaxSpares = 4;
constexpr std::size_t kMaxSpareBytes = std::size_t{32} * 1024;

std::vector<std::vector<std::byte>>& spares() {
  thread_local std::vector<std::vector<std::byte>> mine;
  return mine;
}

}  // namespace

Output::Output(std::size_t shared_from) : shared_from_{shared_from} {
  auto& memory = spares();
  if (memory.empty()) return;
  copied_ = std::move(memory.back());
  memory.pop_back();
}

Output::~Output() {
  if (copied_.capacity() == 0 || copied_.capacity() > kMaxSpareBytes || spares().size() >= kMaxSpares) return;
  copied_.clear();
  spares().push_back(std::move(copied_));
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
  for (const Shared& shared : shared_) {
    pieces.push_back(copied.subspan(from, shared.after - from));
    pieces.push_back(shared.chunk->tail());
    from = shared.after;
  }
  if (from < copied.size()) pieces.push_back(copied.subspan(from));
  return pieces;
}

}  // namespace talus::server
