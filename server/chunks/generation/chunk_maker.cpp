#include "chunks/generation/chunk_maker.h"

#include <exception>
#include <utility>

namespace talus::server {

EncodedChunkPtr ChunkMaker::known(ChunkKey key) const {
  if (EncodedChunkPtr chunk = generator_.instant(key)) return chunk;
  if (EncodedChunkPtr chunk = cache_.find(key)) return chunk;
  const auto rows = rows_.exact(key);
  const auto material = rows ? rows->uniform_at(key.coord.y) : std::nullopt;
  return material ? generator_.uniform(*material) : nullptr;
}

ChunkAnswer ChunkMaker::chunk(const terrain::Stacks* stacks, ChunkKey key) {
  if (stacks == nullptr) return tl::make_unexpected(GenerationError{"its patch could not be generated"});
  try {
    metrics_.chunks_made.add();
    EncodedChunkPtr chunk = generator_.make_chunk(*stacks, key);
    cache_.put(key, chunk);
    return chunk;
  } catch (const std::exception& error) {
    log_->error("chunk {} failed: {}", to_string(key), error.what());
    return tl::make_unexpected(GenerationError{error.what()});
  }
}

tl::expected<AfterStep, GenerationError> ChunkMaker::heights(HeightsTask& task,
                                                             const AskAfterStep& after_step) {
  try {
    const bool keeps = task.tile() && maps_ != nullptr;
    // Another client may have asked for it too, and it may have been drawn since.
    if (const PicturePtr drawn = keeps ? maps_->find(*task.tile()) : nullptr) {
      task.add({.picture = drawn});
      return AfterStep::go_on;
    }
    if (task.build() == nullptr) task.build() = generator_.start_heights(task.next_piece());
    while (task.build()->step()) {
      if (const AfterStep next = after_step(); next != AfterStep::go_on) return next;
    }
    const HeightsResult found = task.build()->take();
    metrics_.heights_made.add(found.heights_fx.size());
    if (task.tile()) metrics_.map_tiles_made.add();
    if (keeps) maps_->put(*task.tile(), found.picture);
    task.add(found);
    if (task.left() == 0) task.write_body();
    return AfterStep::go_on;
  } catch (const std::exception& error) {
    log_->error("{} of {} columns failed: {}", task.tile() ? "a map" : "heights", task.left(), error.what());
    return tl::make_unexpected(GenerationError{error.what()});
  }
}

}  // namespace talus::server
