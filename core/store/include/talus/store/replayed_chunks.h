// Applies unflushed log records to chunks. A stored chunk may include some of them already, because chunks
// are written one by one and a power cut may come at any time.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <unordered_map>

#include <tl/expected.hpp>

#include <talus/edits/chunk_overrides.h>
#include <talus/store/log_records.h>
#include <talus/store/records.h>

namespace talus::store {

class ReplayedChunks {
 public:
  /// Loads a stored chunk; nullopt if it was never flushed. An error is one line.
  using Load = std::function<tl::expected<std::optional<StoredChunk>, std::string>(ChunkKey)>;
  struct Chunk {
    std::uint64_t revision = 0;
    edits::ChunkOverrides overrides;
  };

  explicit ReplayedChunks(Load load) : load_{std::move(load)} {}

  /// Applies the next record. Fails if a chunk cannot be read.
  [[nodiscard]] tl::expected<void, std::string> apply(const LogRecord& record);
  [[nodiscard]] std::unordered_map<ChunkKey, Chunk> take() { return std::move(chunks_); }

 private:
  Load load_;
  std::unordered_map<ChunkKey, Chunk> chunks_;
};

}  // namespace talus::store
