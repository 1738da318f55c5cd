// Makes a published world's chunks inside the client, so that the server sends only edits (Options::maker).
// The client library knows no generator: talus/local_source/local_source.h implements this by Talus' own.
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include <talus/voxel/chunk.h>
#include <talus/voxel/content_hash.h>
#include <talus/voxel/coords.h>

namespace talus::client {

/// The files of a world: its world file by the name "", and the files that this names. None is null.
using WorldFiles = std::map<std::string, std::shared_ptr<const std::vector<std::byte>>>;

/// A chunk as generated.
struct MadeChunk {
  ChunkKey key;
  ContentHash hash;
  std::shared_ptr<const Chunk> chunk;
};

/// A world that was opened here. Clients and threads may share it.
class LocalWorld {
 public:
  virtual ~LocalWorld() = default;

  /// As the server computes it: equal fingerprints have equal voxels everywhere.
  [[nodiscard]] virtual ContentHash fingerprint() const = 0;

  /// Either the chunks of the call, or one line that says why they cannot be made.
  using Made = std::function<void(tl::expected<std::vector<MadeChunk>, std::string>)>;
  /// Makes chunks of the world, all of one level. Returns at once. `done` is called once, on any thread, with
  /// all chunks, or with fewer if `cancel` was set; or never if the maker is destroyed before.
  virtual void make(std::vector<ChunkKey> keys, std::shared_ptr<const std::atomic<bool>> cancel,
                    Made done) = 0;
};

class ChunkMaker {
 public:
  virtual ~ChunkMaker() = default;

  struct OpenFailure {
    std::set<std::string>
        missing_files;    // the world names them, and they are not here; empty: another failure
    std::string message;  // one line
  };
  using Opened = std::function<void(tl::expected<std::shared_ptr<LocalWorld>, OpenFailure>)>;
  /// Reads a world. Returns at once. `done` is called once, on any thread, soon with any failure if `cancel`
  /// was set; or never if the maker is destroyed before.
  virtual void open(std::shared_ptr<const WorldFiles> files, std::shared_ptr<const std::atomic<bool>> cancel,
                    Opened done) = 0;
};

}  // namespace talus::client
