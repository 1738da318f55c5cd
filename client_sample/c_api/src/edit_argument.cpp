#include "edit_argument.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <talus/voxel/chunk.h>

namespace talus::c_api {

tl::expected<edits::Edit, std::string> plain_edit_of(const talus_edit& edit) {
  if ((edit.flags & ~std::uint32_t{TALUS_PASTE_AIR}) != 0) {
    return tl::unexpected{"edit.flags is " + std::to_string(edit.flags) + "; it may hold TALUS_PASTE_AIR"};
  }
  if (edit.reserved != 0) return tl::unexpected<std::string>{"edit.reserved is not 0"};
  for (const auto& [name, count] :
       {std::pair{"guard_count", edit.guard_count}, std::pair{"write_count", edit.write_count},
        std::pair{"fill_count", edit.fill_count}}) {
    if (count <= edits::kMaxVoxels) continue;
    return tl::unexpected{"edit." + std::string{name} + " is " + std::to_string(count) +
                          "; an edit has at most " + std::to_string(edits::kMaxVoxels) + " voxels"};
  }
  const auto is_missing = [](std::uint32_t count, auto... lists) {
    return count > 0 && ((lists == nullptr) || ...);
  };
  if (is_missing(edit.guard_count, edit.guard_voxels) || is_missing(edit.guard_count, edit.guard_materials) ||
      is_missing(edit.write_count, edit.write_voxels) || is_missing(edit.write_count, edit.write_materials) ||
      is_missing(edit.fill_count, edit.fill_corners) || is_missing(edit.fill_count, edit.fill_materials)) {
    return tl::unexpected<std::string>{"a list of edit is NULL but its count is not 0"};
  }
  const auto voxel_at = [](const std::int64_t* numbers) {
    return VoxelPos{numbers[0], numbers[1], numbers[2]};
  };
  edits::Edit own;
  const auto take = [&](std::vector<edits::VoxelWrite>& list, const std::int64_t* voxels,
                        const std::uint16_t* materials, std::uint32_t count) {
    list.reserve(count);
    for (std::uint32_t i = 0; i < count; ++i)
      list.push_back({voxel_at(voxels + 3 * i), MaterialId{materials[i]}});
  };
  take(own.guards, edit.guard_voxels, edit.guard_materials, edit.guard_count);
  take(own.writes, edit.write_voxels, edit.write_materials, edit.write_count);
  for (std::uint32_t i = 0; i < edit.fill_count; ++i) {
    const std::int32_t only = edit.fill_only == nullptr ? std::int32_t{TALUS_ANY} : edit.fill_only[i];
    for (const std::int32_t material : {edit.fill_materials[i], only}) {
      if (material >= -1 && material <= std::numeric_limits<std::uint16_t>::max()) continue;
      return tl::unexpected{"fill " + std::to_string(i) + " of edit names material " +
                            std::to_string(material) +
                            "; ids are 0 to 65535, and -1 stands for TALUS_AS_GENERATED or TALUS_ANY"};
    }
    const auto id_of = [](std::int32_t material) {
      return material < 0 ? std::nullopt : std::optional{MaterialId{static_cast<std::uint16_t>(material)}};
    };
    own.fills.push_back({voxel_at(edit.fill_corners + 6 * i), voxel_at(edit.fill_corners + 6 * i + 3),
                         id_of(edit.fill_materials[i]), id_of(only)});
  }
  if (edit.paste_voxels != nullptr) {
    const auto voxels = std::make_unique<DenseVoxels>();
    std::transform(edit.paste_voxels, edit.paste_voxels + kChunkVolume, voxels->begin(),
                   [](std::uint16_t id) { return MaterialId{id}; });
    own.paste = edits::Paste{{edit.paste_x, edit.paste_y, edit.paste_z},
                             Chunk::from_dense(*voxels),
                             (edit.flags & TALUS_PASTE_AIR) != 0};
  }
  return own;
}

}  // namespace talus::c_api
