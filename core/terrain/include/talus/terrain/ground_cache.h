// Ground that was computed for one region and that regions around it need, too.
#pragma once

#include <cstddef>
#include <memory>

namespace talus::terrain {

struct GroundTiles;

/// How threads that share a cache wait for each other: core/terrain knows none.
class GroundLock {
 public:
  virtual ~GroundLock() = default;
  virtual void lock() = 0;
  virtual void unlock() = 0;
};

/// Heights, looks and shares of tiles of 32 x 32 columns, for generators of one world. A patch of the default
/// world looks at more columns around it than it has, which are the ground of the patches beside it: with a
/// cache each column is computed once. Results do not depend on it. Threads may share it where it has a lock.
class GroundCache {
 public:
  /// Keeps the tiles that were used last, of about `max_bytes`.
  explicit GroundCache(std::size_t max_bytes, std::unique_ptr<GroundLock> lock = nullptr);
  ~GroundCache();

  [[nodiscard]] std::size_t bytes() const;
  /// Private to core/terrain.
  [[nodiscard]] GroundTiles& tiles() { return *tiles_; }

 private:
  std::unique_ptr<GroundTiles> tiles_;
};

}  // namespace talus::terrain
