// Any bytes given as a .vox file: an error of one line, or models that are within their bounds, and that an
// [[object]] can stand on the ground.
#include <array>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <string_view>
#include <vector>

#include <talus/world_files/world_files.h>

#include "features/object_models.h"

namespace {

void require(bool holds, std::string_view what) {
  if (holds) return;
  std::cerr << "decode_vox: " << what << '\n';
  std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace talus;
  // An exact copy on the heap, so that a read past the end is one past an allocation too.
  const auto* first = reinterpret_cast<const std::byte*>(data);
  const std::vector<std::byte> file(first, first + size);
  const auto models = world_files::decode_vox(file);
  if (!models) {
    require(!models.error().empty() && models.error().find('\n') == std::string::npos,
            "an error is one line");
    return 0;
  }
  require(!models->empty() && models->size() <= terrain::kMaxModels, "a file has 1 to 256 models");
  std::array<std::uint8_t, 256> parts{};
  for (std::size_t i = 0; i < parts.size(); ++i) parts[i] = static_cast<std::uint8_t>(i / 2);
  for (const terrain::VoxelModel& model : *models) {
    require(model.width >= 1 && model.width <= terrain::kMaxModelWidth, "width");
    require(model.depth >= 1 && model.depth <= terrain::kMaxModelWidth, "depth");
    require(model.height >= 1 && model.height <= terrain::kMaxModelHeight, "height");
    const terrain::ObjectModel object = terrain::model_of(model, parts);
    const terrain::ModelColumns columns{object};
    std::size_t seen = 0;
    for (int z = -terrain::kObjectReach; z <= terrain::kObjectReach; ++z) {
      for (int x = -terrain::kObjectReach; x <= terrain::kObjectReach; ++x) seen += columns.at(x, z).size();
    }
    require(seen == object.size(), "each voxel is in its column");
    for (const terrain::ModelVoxel& voxel : object) {
      require(voxel.y >= -terrain::kObjectRoot && voxel.y < terrain::kObjectTop, "rows are within bounds");
    }
  }
  return 0;
}
