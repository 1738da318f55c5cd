#include "chunks/merged_chunks.h"

#include <exception>
#include <string>
#include <utility>

#include <fmt/format.h>

#include <talus/voxel/codec.h>

namespace talus::server {

ChunkAnswer MergedChunks::merged(ChunkKey key, const EncodedChunkPtr& base) noexcept {
  try {
    const std::uint64_t newest = edits_.revision(key);
    if (newest == kBaseRevision) return base;
    // Another client may have waited for it too, and have had it merged since.
    EncodedChunkPtr kept = cache_.find(key);
    if (kept != nullptr && kept->revision() >= newest) return kept;
    auto made = merge(key, *base);
    if (!made) {
      log_->error("chunk {} with its edits failed: {}", to_string(key), made.error());
      return tl::make_unexpected(GenerationError{"its edits cannot be read"});
    }
    if (kept == nullptr || kept->revision() < (*made)->revision()) cache_.put(key, *made);
    return *std::move(made);
  } catch (const std::exception&) {
    return tl::make_unexpected(GenerationError{});  // there is no memory for a reason
  }
}

tl::expected<EncodedChunkPtr, std::string> MergedChunks::merge(ChunkKey key, const EncodedChunk& base) const {
  const auto edited = edits_.load(key);
  if (!edited) return tl::make_unexpected(edited.error());
  if (edited->overrides == nullptr || edited->overrides->empty()) {
    return std::make_shared<const EncodedChunk>(base.hash(), base.payload(), edited->revision,
                                                base.uniform());
  }
  const auto generated = decode(base.payload());
  if (!generated) {
    return tl::make_unexpected(
        fmt::format("as generated it does not decode: {}", describe(generated.error())));
  }
  return encode_shared(edited->overrides->merged_over(*generated), edited->revision);
}

EncodedChunkPtr MergedChunks::newer(ChunkKey key, std::uint64_t revision) {
  EncodedChunkPtr kept = cache_.find(key);
  return kept != nullptr && kept->revision() > revision ? kept : nullptr;
}

}  // namespace talus::server
