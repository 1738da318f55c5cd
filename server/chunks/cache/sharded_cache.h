// A map bounded in bytes that evicts by CLOCK. Callable from any thread; a call locks one shard.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <mutex>
#include <optional>
#include <utility>

#include "chunks/cache/clock_cache.h"

namespace talus::server {

template <typename Key, typename Value>
class ShardedCache {
 public:
  static constexpr std::size_t kShards = 16;

  explicit ShardedCache(std::size_t capacity_bytes)
      : shards_{make_shards(capacity_bytes / kShards, std::make_index_sequence<kShards>{})} {}

  [[nodiscard]] std::optional<Value> find(const Key& key) {
    const std::size_t hash = std::hash<Key>{}(key);
    Shard& shard = shard_of(hash);
    const std::lock_guard lock{shard.mutex};
    const Value* const value = shard.values.find(key, hash);
    return value == nullptr ? std::nullopt : std::optional{*value};
  }

  /// Does not count as a use.
  [[nodiscard]] bool holds(const Key& key) {
    Shard& shard = shard_of(std::hash<Key>{}(key));
    const std::lock_guard lock{shard.mutex};
    return shard.values.holds(key);
  }

  /// `value_bytes`: memory of the value in addition to its own size.
  void put(const Key& key, Value value, std::size_t value_bytes) {
    Shard& shard = shard_of(std::hash<Key>{}(key));
    const std::lock_guard lock{shard.mutex};
    shard.values.put(key, std::move(value), value_bytes);
  }

  /// Returns at once: call fit() until everything fits.
  void set_capacity(std::size_t capacity_bytes) {
    for (Shard& shard : shards_) {
      const std::lock_guard lock{shard.mutex};
      shard.values.set_capacity(capacity_bytes / kShards);
    }
  }

  /// As ClockCache::fit(). Never holds a lock for more than kProbesPerLock entries.
  [[nodiscard]] bool fit(std::size_t& probes) {
    return std::all_of(shards_.begin(), shards_.end(), [&](Shard& shard) { return shard.fit(probes); });
  }

  /// Bytes held now, with overhead. More than the capacity only after set_capacity(), until fit() has evicted
  /// the excess.
  [[nodiscard]] std::size_t bytes() const {
    std::size_t sum = 0;
    for (const Shard& shard : shards_) {
      const std::lock_guard lock{shard.mutex};
      sum += shard.values.bytes();
    }
    return sum;
  }

 private:
  static constexpr std::size_t kProbesPerLock = 64;

  struct Shard {
    explicit Shard(std::size_t capacity_bytes) : values{capacity_bytes} {}
    [[nodiscard]] bool fit(std::size_t& probes) {
      for (;;) {
        const std::size_t most = std::min(probes, kProbesPerLock);
        std::size_t left = most;
        const std::lock_guard lock{mutex};
        const bool fits = values.fit(left);
        probes -= most - left;
        if (fits || probes == 0) return fits;
      }
    }
    mutable std::mutex mutex;
    ClockCache<Key, Value> values;
  };

  template <std::size_t... kShard>
  static std::array<Shard, kShards> make_shards(std::size_t capacity_bytes, std::index_sequence<kShard...>) {
    return {((void)kShard, Shard{capacity_bytes})...};
  }

  // The map inside the shard uses the low bits of the same hash.
  [[nodiscard]] Shard& shard_of(std::size_t hash) { return shards_[(hash >> 40) % kShards]; }

  std::array<Shard, kShards> shards_;
};

}  // namespace talus::server
