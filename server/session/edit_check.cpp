#include "session/edit_check.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include <talus/edits/editors.h>
#include <talus/voxel/codec.h>

namespace talus::server {
namespace {

constexpr std::uint8_t kFillOfAny = 1;
constexpr std::uint8_t kFillAsGenerated = 2;

VoxelPos voxel_of(const wire::Voxel& at) {
  return {at.x(), at.y(), at.z()};
}

std::vector<edits::VoxelWrite> writes_of(const flatbuffers::Vector<const wire::VoxelWrite*>* wire) {
  std::vector<edits::VoxelWrite> writes;
  if (wire == nullptr) return writes;
  writes.reserve(wire->size());
  for (const wire::VoxelWrite* each : *wire) {
    writes.push_back({voxel_of(each->voxel()), MaterialId{each->material()}});
  }
  return writes;
}

/// Of a box; past `most` only that it is more.
std::uint64_t volume(const edits::Fill& fill, std::uint64_t most) {
  std::uint64_t product = 1;
  for (const auto& [first, last] :
       {std::pair{fill.first.x, fill.last.x}, std::pair{fill.first.y, fill.last.y},
        std::pair{fill.first.z, fill.last.z}}) {
    if (first > last) return 0;  // refused where it is prepared
    const std::uint64_t length = static_cast<std::uint64_t>(last) - static_cast<std::uint64_t>(first);
    product *= std::min(length, most) + 1;  // at most 2^17 each time
    product = std::min(product, most + 1);
  }
  return product;
}

}  // namespace

tl::expected<CheckedEdit, Rejection> check_edit(const wire::Edit& wire) {
  CheckedEdit checked;
  if (wire.subject() != nullptr) checked.subject = wire.subject()->str();
  if (checked.subject.size() > edits::kMaxSubjectBytes) {
    return rejected(wire::ErrorCode::too_large, fmt::format("Edit.subject has {} bytes, over the limit {}",
                                                            checked.subject.size(), edits::kMaxSubjectBytes));
  }
  edits::Edit& edit = checked.edit;
  edit.guards = writes_of(wire.guards());
  edit.writes = writes_of(wire.writes());
  checked.voxels = edit.guards.size() + edit.writes.size();
  if (wire.fills() != nullptr) {
    edit.fills.reserve(wire.fills()->size());
    for (const wire::Fill* each : *wire.fills()) {
      if ((each->flags() & ~(kFillOfAny | kFillAsGenerated)) != 0) {
        return rejected(wire::ErrorCode::malformed,
                        fmt::format("Edit.fills: flags {} are not known; 1 and 2 are", each->flags()));
      }
      edits::Fill fill{voxel_of(each->first()), voxel_of(each->last()), std::nullopt, std::nullopt};
      if ((each->flags() & kFillAsGenerated) == 0) fill.material = MaterialId{each->material()};
      if ((each->flags() & kFillOfAny) == 0) fill.only = MaterialId{each->only()};
      checked.voxels += volume(fill, edits::kMaxVoxels);
      edit.fills.push_back(fill);
    }
  }
  if (const wire::Paste* const paste = wire.paste()) {
    if (paste->origin() == nullptr || paste->payload() == nullptr) {
      return rejected(wire::ErrorCode::malformed, "Edit.paste: it needs origin and payload");
    }
    auto chunk =
        decode({reinterpret_cast<const std::byte*>(paste->payload()->data()), paste->payload()->size()});
    if (!chunk) {
      return rejected(wire::ErrorCode::malformed,
                      fmt::format("Edit.paste: its payload is no chunk: {}", describe(chunk.error())));
    }
    edit.paste = edits::Paste{voxel_of(*paste->origin()), *std::move(chunk), paste->with_air()};
    checked.voxels += kChunkVolume;
  }
  if (checked.voxels > edits::kMaxVoxels) {
    return rejected(
        wire::ErrorCode::too_large,
        fmt::format("the edit names {} or more voxels, over the limit {}",
                    std::min<std::uint64_t>(checked.voxels, edits::kMaxVoxels + 1), edits::kMaxVoxels));
  }
  if (checked.voxels == 0) {
    return rejected(wire::ErrorCode::out_of_range, "the edit names no voxel; give writes, fills or a paste");
  }
  return checked;
}

}  // namespace talus::server
