#include "generation/chunk_maker.h"

#include <exception>
#include <utility>

namespace talus::server {

EncodedChunkPtr ChunkMaker::known(ChunkKey key) const {
  if (EncodedChunkPtr chunk = cache_.find(key)) return chunk;
  const auto rows = rows_.exact(key);
  const auto material = rows ? rows->uniform_at(key.coord.y) : std::nullopt;
  return material ? generator_.uniform(*material) : nullptr;
}

ChunkAnswer ChunkMaker::chunk(const terrain::Stacks* stacks, ChunkKey key) {
  if (stacks == nullptr) return tl::make_unexpected(GenerationFailed{"its patch could not be generated"});
  try {
    metrics_.chunks_made.add();
    EncodedChunkPtr chunk = generator_.make_chunk(*stacks, key);
    cache_.put(key, chunk);
    return chunk;
  } catch (const std::exception& error) {
    log_->error("chunk {} failed: {}", to_string(key), error.what());
    return tl::make_unexpected(GenerationFailed{error.what()});
  }
}

std::optional<HeightsAnswer> ChunkMaker::heights(std::span<const terrain::BaseColumn> columns,
                                                 const GoOn& go_on) {
  try {
    auto heights = generator_.heights(columns, go_on);
    if (!heights) return std::nullopt;
    metrics_.heights_made.add(columns.size());
    return HeightsAnswer{*std::move(heights)};
  } catch (const std::exception& error) {
    log_->error("heights of {} columns failed: {}", columns.size(), error.what());
    return HeightsAnswer{tl::unexpect, GenerationFailed{error.what()}};
  }
}

}  // namespace talus::server
