// Ground computed for one region that neighbouring regions also need.
#pragma once

#include <cstddef>
#include <memory>

namespace talus::terrain {

struct GroundTiles;

/// The lock of a shared cache. An interface because core/terrain uses no threads.
class GroundLock {
 public:
  virtual ~GroundLock() = default;
  virtual void lock() = 0;
  virtual void unlock() = 0;
};

/// Heights, looks and shares of tiles of 32 x 32 columns, for generators of one world. A patch of the default
/// world reads more columns around it than it has, which are the ground of neighbouring patches: with a cache
/// each column is computed once. Results do not depend on it. Threads may share a cache that has a lock.
class GroundCache {
 public:
  /// Keeps the most recently used tiles, about `max_bytes` in all.
  explicit GroundCache(std::size_t max_bytes, std::unique_ptr<GroundLock> lock = nullptr);
  ~GroundCache();

  [[nodiscard]] std::size_t bytes() const;
  /// Private to core/terrain.
  [[nodiscard]] GroundTiles& tiles() { return *tiles_; }

 private:
  std::unique_ptr<GroundTiles> tiles_;
};

}  // namespace talus::terrain
