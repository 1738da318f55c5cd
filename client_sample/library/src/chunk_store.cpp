#include <talus/client/chunk_store.h>

#include <algorithm>
#include <cassert>

namespace talus::client {
namespace {

constexpr std::size_t kBookkeepingBytes = 256;

std::size_t bytes_of(const ReceivedChunk& chunk) {
  const Layers* layers = chunk.chunk->layers();
  return kBookkeepingBytes +
         (layers == nullptr ? sizeof(DenseVoxels)
                            : layers->tops.capacity() + layers->materials.capacity() * sizeof(MaterialId));
}

// Rows or columns `from` to `to` (exclusive) of a neighbour, and their place in the cube.
struct Overlap {
  int from = 0;
  int to = 0;
  int offset = 0;  // cube coordinate = chunk coordinate + offset
};

Overlap overlap(int side, int width) {
  if (side < 0) return {kChunkSize - width, kChunkSize, width - kChunkSize};
  if (side > 0) return {0, width, width + kChunkSize};
  return {0, kChunkSize, width};
}

class Cube {
 public:
  Cube(std::span<MaterialId> voxels, int width) : voxels_{voxels}, edge_{kChunkSize + 2 * width} {}

  [[nodiscard]] MaterialId& at(int x, int y, int z) const {
    return voxels_[static_cast<std::size_t>((y * edge_ + z) * edge_ + x)];
  }

 private:
  std::span<MaterialId> voxels_;
  int edge_;
};

struct Part {
  Overlap x, y, z;
};

void fill(const Cube& cube, const Part& part, MaterialId material) {
  for (int y = part.y.from; y < part.y.to; ++y) {
    for (int z = part.z.from; z < part.z.to; ++z) {
      auto* row = &cube.at(part.x.from + part.x.offset, y + part.y.offset, z + part.z.offset);
      std::fill_n(row, part.x.to - part.x.from, material);
    }
  }
}

void copy_layers(const Cube& cube, const Part& part, const Layers& layers) {
  for (int z = part.z.from; z < part.z.to; ++z) {
    for (int x = part.x.from; x < part.x.to; ++x) {
      int y = part.y.from;
      for (std::size_t m = 0; m < layers.materials.size() && y < part.y.to; ++m) {
        const int top = m < layers.plane_count() ? layers.plane(m)[column_index(x, z)] : kChunkSize;
        for (; y < std::min(top, part.y.to); ++y) {
          cube.at(x + part.x.offset, y + part.y.offset, z + part.z.offset) = layers.materials[m];
        }
      }
    }
  }
}

void copy_dense(const Cube& cube, const Part& part, const Chunk& chunk) {
  for (int y = part.y.from; y < part.y.to; ++y) {
    for (int z = part.z.from; z < part.z.to; ++z) {
      for (int x = part.x.from; x < part.x.to; ++x) {
        const LocalPos pos{static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(y),
                           static_cast<std::uint8_t>(z)};
        cube.at(x + part.x.offset, y + part.y.offset, z + part.z.offset) = chunk.at(pos);
      }
    }
  }
}

void copy(const Cube& cube, const Part& part, const Chunk& chunk) {
  if (chunk.is_uniform()) {
    fill(cube, part, chunk.at({}));
  } else if (const Layers* layers = chunk.layers()) {
    copy_layers(cube, part, *layers);
  } else {
    copy_dense(cube, part, chunk);
  }
}

}  // namespace

void ChunkStore::put(const ReceivedChunk& chunk) {
  if (chunk.unchanged()) {
    (void)find(chunk.key);
    return;
  }
  if (const auto held = held_.find(chunk.key); held != held_.end() && held->second->revision > chunk.revision)
    return;
  erase(chunk.key);
  by_use_.push_front(chunk);
  held_.emplace(chunk.key, by_use_.begin());
  bytes_ += bytes_of(chunk);
  while (bytes_ > max_bytes_ && by_use_.size() > 1) erase(ChunkKey{by_use_.back().key});
}

void ChunkStore::erase(const ChunkKey& key) {
  const auto held = held_.find(key);
  if (held == held_.end()) return;
  bytes_ -= bytes_of(*held->second);
  by_use_.erase(held->second);
  held_.erase(held);
}

void ChunkStore::clear() {
  held_.clear();
  by_use_.clear();
  bytes_ = 0;
}

std::shared_ptr<const Chunk> ChunkStore::find(const ChunkKey& key) {
  const auto held = held_.find(key);
  if (held == held_.end()) return nullptr;
  by_use_.splice(by_use_.begin(), by_use_, held->second);
  return held->second->chunk;
}

const ReceivedChunk* ChunkStore::look(const ChunkKey& key) const {
  const auto held = held_.find(key);
  return held == held_.end() ? nullptr : &*held->second;
}

ApronGaps ChunkStore::apron(const ChunkKey& key, int width, MaterialId filler, std::span<MaterialId> out) {
  assert(width >= 0 && width <= kMaxApron && out.size() == apron_volume(width));
  const Cube cube{out, width};
  const int reach = width > 0 ? 1 : 0;
  ApronGaps gaps;
  for (int dy = -reach; dy <= reach; ++dy) {
    for (int dz = -reach; dz <= reach; ++dz) {
      for (int dx = -reach; dx <= reach; ++dx) {
        const Part part{overlap(dx, width), overlap(dy, width), overlap(dz, width)};
        const auto neighbour = checked_chunk(std::int64_t{key.coord.x} + dx, std::int64_t{key.coord.y} + dy,
                                             std::int64_t{key.coord.z} + dz, key.lod);
        const auto chunk = neighbour ? find(*neighbour) : nullptr;
        if (chunk) {
          copy(cube, part, *chunk);
        } else {
          gaps.set(neighbour_index(dx, dy, dz));
          fill(cube, part, filler);
        }
      }
    }
  }
  return gaps;
}

}  // namespace talus::client
