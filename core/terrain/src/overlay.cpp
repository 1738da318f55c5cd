#include "overlay.h"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <utility>
#include <vector>

#include <talus/vectors/instruction_set.h>

#include "kernels/chunk_planes.h"

namespace talus::terrain {
namespace {

constexpr ChunkPlane plane_of(std::uint8_t row) {
  ChunkPlane plane{};
  for (std::uint8_t& each : plane) each = row;
  return plane;
}

constexpr ChunkPlane kFloor = plane_of(0);
constexpr ChunkPlane kCeiling = plane_of(kChunkSize);

// A list of layers, built from the bottom up. Skips empty layers and merges adjacent ones of one material.
class LayerList {
 public:
  explicit LayerList(std::size_t planes) {
    layers_.materials.reserve(planes);
    layers_.tops.resize(planes * kChunkArea);
  }

  /// Memory for the next layer's plane, to be written before add().
  [[nodiscard]] std::uint8_t* next() { return layers_.tops.data() + count() * kChunkArea; }

  void add(MaterialId material) {
    const std::uint8_t* const top = next();
    const std::uint8_t* const below = count() == 0 ? kFloor.data() : top - kChunkArea;
    if (std::memcmp(top, below, kChunkArea) == 0) return;
    if (count() > 0 && layers_.materials.back() == material) {
      std::memcpy(next() - kChunkArea, top, kChunkArea);
    } else {
      layers_.materials.push_back(material);
    }
  }

  /// Drops the last plane: it is the chunk's ceiling, which lists do not hold.
  [[nodiscard]] Layers take() && {
    layers_.tops.resize(layers_.plane_count() * kChunkArea);
    return std::move(layers_);
  }

 private:
  [[nodiscard]] std::size_t count() const { return layers_.materials.size(); }
  Layers layers_;
};

const std::uint8_t* top_of(const Layers& layers, std::size_t layer) {
  return layer == layers.plane_count() ? kCeiling.data() : layers.plane(layer).data();
}

// The layer that contains the most of the overlay's columns.
std::size_t host_of(const ChunkPlaneKernels& kernels, const Layers& layers, const Overlay& overlay) {
  std::size_t host = 0;
  std::size_t max_hosted = 0;
  const std::uint8_t* bottom = kFloor.data();
  for (std::size_t layer = 0; layer < layers.materials.size(); ++layer) {
    const std::uint8_t* const top = top_of(layers, layer);
    const std::size_t hosted = kernels.count_inside(overlay.from.data(), overlay.to.data(), bottom, top);
    if (hosted > max_hosted) {
      max_hosted = hosted;
      host = layer;
    }
    bottom = top;
  }
  return host;
}

void write_layers(const Layers& layers, std::span<MaterialId, kChunkVolume> voxels) {
  ChunkPlane bottom{};
  for (std::size_t layer = 0; layer < layers.materials.size(); ++layer) {
    ChunkPlane top;
    std::copy_n(top_of(layers, layer), kChunkArea, top.begin());
    write(Overlay{layers.materials[layer], bottom, top}, voxels);
    bottom = top;
  }
}

}  // namespace

void write(const Overlay& overlay, std::span<MaterialId, kChunkVolume> voxels) {
  for (std::size_t column = 0; column < kChunkArea; ++column) {
    for (std::size_t y = overlay.from[column]; y < overlay.to[column]; ++y) {
      voxels[y * kChunkArea + column] = overlay.material;
    }
  }
}

void apply(const Overlay& overlay, Layers& layers) {
  const ChunkPlaneKernels& kernels = chunk_plane_kernels(instruction_set());
  // Most chunks of a patch with caves have no cave.
  if (!kernels.any(overlay.from.data(), overlay.to.data())) return;
  // In a column without an interval the list may be cut in two at any row. At the host's top the layers above
  // the host stay whole above the cut, and the host stays whole below it.
  const std::uint8_t* const host_top = top_of(layers, host_of(kernels, layers, overlay));
  ChunkPlane from;
  ChunkPlane to;
  kernels.interval(overlay.from.data(), overlay.to.data(), host_top, from.data(), to.data());
  // Each layer appears at most twice, the overlay's once.
  LayerList list{2 * layers.materials.size() + 2};
  for (std::size_t layer = 0; layer < layers.materials.size(); ++layer) {
    kernels.lower_of(top_of(layers, layer), from.data(), list.next());
    list.add(layers.materials[layer]);
  }
  std::copy(to.begin(), to.end(), list.next());
  list.add(overlay.material);
  for (std::size_t layer = 0; layer < layers.materials.size(); ++layer) {
    kernels.higher_of(top_of(layers, layer), to.data(), list.next());
    list.add(layers.materials[layer]);
  }
  layers = std::move(list).take();
}

Chunk chunk_with(Layers layers, std::span<const Overlay> overlays) {
  while (!overlays.empty() && layers.materials.size() <= Layers::kMaxMaterials) {
    apply(overlays.front(), layers);
    overlays = overlays.subspan(1);
  }
  if (layers.materials.size() <= Layers::kMaxMaterials) return Chunk::from_layers(std::move(layers));
  // More layers than the boundary view can hold are thinner than a voxel each; dense voxels are smaller then.
  std::vector<MaterialId> voxels(kChunkVolume);
  const std::span<MaterialId, kChunkVolume> all{voxels};
  write_layers(layers, all);
  for (const Overlay& each : overlays) write(each, all);
  return Chunk::from_dense(all);
}

}  // namespace talus::terrain
