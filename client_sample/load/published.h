// The server's published world, opened once for all players (--generate).
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include <talus/client/chunk_maker.h>
#include <talus/local_source/local_source.h>

namespace talus::load {

/// Thread-safe.
class Published {
 public:
  /// Opens the world of these files, and waits for it.
  [[nodiscard]] static tl::expected<std::shared_ptr<Published>, std::string> open(
      std::shared_ptr<const client::WorldFiles> files);

  /// Makes the mixed ones among these chunks of one column. `done` is called on another thread, unless stop()
  /// was called.
  void make_mixed(std::vector<ChunkKey> keys, std::function<void(std::vector<client::MadeChunk>)> done);

  /// Waits for the chunks being made. Nothing is called afterwards.
  void stop();

 private:
  std::unique_ptr<LocalSource> source_ = std::make_unique<LocalSource>(LocalSourceOptions{1});
  std::shared_ptr<client::LocalWorld> world_;
};

}  // namespace talus::load
