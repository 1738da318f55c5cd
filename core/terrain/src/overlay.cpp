#include "overlay.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace talus::terrain {
namespace {

// Adds planes to a list from the bottom up and leaves out what bounds nothing.
class LayerList {
 public:
  explicit LayerList(std::size_t planes) { layers_.tops.reserve(planes * kChunkArea); }

  void add(MaterialId material, const ChunkPlane& top) {
    if (top == below_) return;
    below_ = top;
    if (!layers_.materials.empty() && layers_.materials.back() == material) {
      layers_.tops.resize(layers_.tops.size() - kChunkArea);
    } else {
      layers_.materials.push_back(material);
    }
    layers_.tops.insert(layers_.tops.end(), top.begin(), top.end());
  }

  /// The last plane is the chunk's ceiling, which no list holds.
  [[nodiscard]] Layers take() && {
    layers_.tops.resize(layers_.plane_count() * kChunkArea);
    return std::move(layers_);
  }

 private:
  Layers layers_;
  ChunkPlane below_{};
};

ChunkPlane ceiling() {
  ChunkPlane plane;
  plane.fill(kChunkSize);
  return plane;
}

ChunkPlane top_of(const Layers& layers, std::size_t layer) {
  if (layer == layers.plane_count()) return ceiling();
  ChunkPlane plane;
  std::copy_n(layers.plane(layer).begin(), kChunkArea, plane.begin());
  return plane;
}

// The layer inside which most of the overlay's columns lie.
std::size_t host_of(const Layers& layers, const Overlay& overlay) {
  std::size_t host = 0;
  std::ptrdiff_t most_hosted = -1;
  ChunkPlane bottom{};
  for (std::size_t layer = 0; layer < layers.materials.size(); ++layer) {
    const ChunkPlane top = top_of(layers, layer);
    std::ptrdiff_t hosted = 0;
    for (std::size_t row = 0; row < kChunkArea; row += kChunkSize) {
      std::uint8_t in_row = 0;  // a byte, as what it counts, so that a vector counts many
      for (std::size_t i = row; i < row + kChunkSize; ++i) {
        const int any = overlay.from[i] < overlay.to[i] ? 1 : 0;
        const int above = bottom[i] <= overlay.from[i] ? 1 : 0;
        const int below = overlay.to[i] <= top[i] ? 1 : 0;
        in_row = static_cast<std::uint8_t>(in_row + (any & above & below));
      }
      hosted += in_row;
    }
    if (hosted > most_hosted) {
      most_hosted = hosted;
      host = layer;
    }
    bottom = top;
  }
  return host;
}

void write(const Overlay& overlay, std::span<MaterialId, kChunkVolume> voxels) {
  for (std::size_t column = 0; column < kChunkArea; ++column) {
    for (std::size_t y = overlay.from[column]; y < overlay.to[column]; ++y) {
      voxels[y * kChunkArea + column] = overlay.material;
    }
  }
}

void write(const Layers& layers, std::span<MaterialId, kChunkVolume> voxels) {
  ChunkPlane bottom{};
  for (std::size_t layer = 0; layer < layers.materials.size(); ++layer) {
    const ChunkPlane top = top_of(layers, layer);
    write({layers.materials[layer], bottom, top}, voxels);
    bottom = top;
  }
}

}  // namespace

void apply(const Overlay& overlay, Layers& layers) {
  // In a column without an interval the list is cut in two at a row of choice. At the host's top the layers
  // above the host are whole above the cut and the host is whole below it.
  ChunkPlane from = top_of(layers, host_of(layers, overlay));
  ChunkPlane to = from;
  std::uint8_t any = 0;
  for (std::size_t i = 0; i < kChunkArea; ++i) {
    const bool here = overlay.from[i] < overlay.to[i];
    any |= static_cast<std::uint8_t>(here);
    from[i] = here ? overlay.from[i] : from[i];
    to[i] = here ? overlay.to[i] : to[i];
  }
  if (any == 0) return;
  LayerList list{layers.plane_count() + 3};
  ChunkPlane plane;
  for (std::size_t layer = 0; layer < layers.materials.size(); ++layer) {
    const ChunkPlane top = top_of(layers, layer);
    std::transform(top.begin(), top.end(), from.begin(), plane.begin(),
                   [](std::uint8_t a, std::uint8_t b) { return std::min(a, b); });
    list.add(layers.materials[layer], plane);
  }
  list.add(overlay.material, to);
  for (std::size_t layer = 0; layer < layers.materials.size(); ++layer) {
    const ChunkPlane top = top_of(layers, layer);
    std::transform(top.begin(), top.end(), to.begin(), plane.begin(),
                   [](std::uint8_t a, std::uint8_t b) { return std::max(a, b); });
    list.add(layers.materials[layer], plane);
  }
  layers = std::move(list).take();
}

Chunk chunk_with(Layers layers, std::span<const Overlay> overlays) {
  while (!overlays.empty() && layers.materials.size() <= Layers::kMaxMaterials) {
    apply(overlays.front(), layers);
    overlays = overlays.subspan(1);
  }
  if (layers.materials.size() <= Layers::kMaxMaterials) return Chunk::from_layers(std::move(layers));
  // More layers than the boundary view holds: thinner than a voxel each, so dense voxels say it shorter.
  std::vector<MaterialId> voxels(kChunkVolume);
  const std::span<MaterialId, kChunkVolume> all{voxels};
  write(layers, all);
  for (const Overlay& each : overlays) write(each, all);
  return Chunk::from_dense(all);
}

}  // namespace talus::terrain
