// Edits of chunks of the View that are not made here yet, until they are. Pure.
#pragma once

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include <talus/voxel/chunk.h>
#include <talus/voxel/coords.h>

namespace talus::client {

class PendingEdits {
 public:
  struct Edits {
    std::uint64_t revision = 0;
    std::vector<Override> voxels;  // the last of a voxel counts
  };

  /// Adds what changed between the chunk as generated, or an edit added before, and `revision`. False, and
  /// the chunk's edits are forgotten, if they do not follow each other or are too many: the chunk must then
  /// come from the server.
  [[nodiscard]] bool add(const ChunkKey& key, std::uint64_t previous, std::uint64_t revision,
                         const std::vector<Override>& voxels) {
    const auto found = edits_.find(key);
    if (found != edits_.end() && revision <= found->second.revision) return true;
    const std::uint64_t has = found == edits_.end() ? 0 : found->second.revision;
    const std::size_t before = found == edits_.end() ? 0 : found->second.voxels.size();
    if (previous > has || before + voxels.size() > kMaxVoxels || voxels_ + voxels.size() > kMaxVoxelsOfAll) {
      erase(key);
      return false;
    }
    Edits& edits = edits_[key];
    if (previous == 0) {  // it has all that changed since the chunk was generated
      voxels_ -= edits.voxels.size();
      edits.voxels.clear();
    }
    edits.revision = revision;
    edits.voxels.insert(edits.voxels.end(), voxels.begin(), voxels.end());
    voxels_ += voxels.size();
    return true;
  }

  /// Null if the chunk has none.
  [[nodiscard]] const Edits* find(const ChunkKey& key) const {
    const auto found = edits_.find(key);
    return found == edits_.end() ? nullptr : &found->second;
  }
  void erase(const ChunkKey& key) {
    const auto found = edits_.find(key);
    if (found == edits_.end()) return;
    voxels_ -= found->second.voxels.size();
    edits_.erase(found);
  }
  void clear() {
    edits_.clear();
    voxels_ = 0;
  }
  [[nodiscard]] bool empty() const { return edits_.empty(); }
  [[nodiscard]] std::vector<ChunkKey> keys() const {
    std::vector<ChunkKey> keys;
    for (const auto& [key, edits] : edits_) keys.push_back(key);
    return keys;
  }

 private:
  static constexpr std::size_t kMaxVoxels = std::size_t{2} * kChunkVolume;  // of a chunk
  static constexpr std::size_t kMaxVoxelsOfAll = std::size_t{4} << 20;      // 16 MiB

  std::unordered_map<ChunkKey, Edits> edits_;
  std::size_t voxels_ = 0;  // of all chunks
};

}  // namespace talus::client
