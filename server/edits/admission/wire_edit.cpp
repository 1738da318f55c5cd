#include "edits/admission/wire_edit.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include <talus/edits/editors.h>
#include <talus/edits/settle.h>
#include <talus/voxel/codec.h>

#include "runtime/log/escape.h"

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

std::size_t bytes_as_it_came(const edits::Edit& edit, const edits::Extent& extent) {
  constexpr std::size_t kAnyEdit = 512;
  return kAnyEdit + edit.fills.size() * sizeof(edits::Fill) +
         (edit.guards.size() + edit.writes.size()) * sizeof(edits::VoxelWrite) +
         (extent.chunks.size() + extent.loose_chunks.size()) * sizeof(ChunkCoord) +
         (edit.paste ? sizeof(DenseVoxels) : 0);
}

std::size_t bytes_prepared(std::uint64_t voxels, bool settles, bool reveals) {
  if (settles) voxels += edits::kSettleVoxels;
  constexpr std::size_t kChunk = 256;  // its places in the lists of what is touched and looked up
  constexpr std::uint64_t kReach = 7;  // a voxel and those beside it
  const std::uint64_t around = reveals ? kReach * voxels : 0;
  // Touched voxels by chunk, and their materials as generated; around them, the ore and what it shows as.
  const std::size_t voxel_bytes = (settles ? 2 : 1) * sizeof(std::uint16_t) + sizeof(Override);
  const std::size_t around_bytes = sizeof(std::uint16_t) + 2 * sizeof(Override);
  return std::min<std::uint64_t>(std::max(voxels, around), edits::kMaxChunks) * kChunk +
         voxels * voxel_bytes + around * around_bytes;
}

}  // namespace

tl::expected<AdmittedEdit, EditError> read_edit(const wire::Edit& wire, bool settles, bool reveals) {
  AdmittedEdit checked;
  if (wire.subject() != nullptr) checked.subject = wire.subject()->str();
  if (checked.subject.size() > edits::kMaxSubjectBytes) {
    return edit_error(EditErrorCode::too_large, fmt::format("Edit.subject has {} bytes, over the limit {}",
                                                            checked.subject.size(), edits::kMaxSubjectBytes));
  }
  // History shows it in a terminal, and operators type it to roll back.
  if (on_one_line(checked.subject) != checked.subject) {
    return edit_error(EditErrorCode::out_of_range,
                      "Edit.subject has control characters, or is not UTF-8; give a printable name");
  }
  edits::Edit& edit = checked.edit;
  edit.guards = writes_of(wire.guards());
  edit.writes = writes_of(wire.writes());
  if (wire.fills() != nullptr) {
    edit.fills.reserve(wire.fills()->size());
    for (const wire::Fill* each : *wire.fills()) {
      if ((each->flags() & ~(kFillOfAny | kFillAsGenerated)) != 0) {
        return edit_error(
            EditErrorCode::out_of_range,
            fmt::format("fill {}: unknown flags {}; 1 and 2 are known", edit.fills.size(), each->flags()));
      }
      edits::Fill fill{voxel_of(each->first()), voxel_of(each->last()), std::nullopt, std::nullopt};
      if ((each->flags() & kFillAsGenerated) == 0) fill.material = MaterialId{each->material()};
      if ((each->flags() & kFillOfAny) == 0) fill.only = MaterialId{each->only()};
      edit.fills.push_back(fill);
    }
  }
  if (const wire::Paste* const paste = wire.paste()) {
    if (paste->origin() == nullptr || paste->payload() == nullptr) {
      return edit_error(EditErrorCode::malformed, "Edit.paste: origin and payload are required");
    }
    auto chunk =
        decode({reinterpret_cast<const std::byte*>(paste->payload()->data()), paste->payload()->size()});
    if (!chunk) {
      return edit_error(EditErrorCode::malformed,
                        fmt::format("Edit.paste: the payload is not a chunk: {}", describe(chunk.error())));
    }
    edit.paste = edits::Paste{voxel_of(*paste->origin()), *std::move(chunk), paste->with_air()};
  }
  checked.extent = extent_of(edit, settles);
  const std::size_t voxels = checked.extent.voxels;
  if (voxels > edits::kMaxVoxels) {
    return edit_error(EditErrorCode::too_large,
                      fmt::format("the edit names {} or more voxels, over the limit {}",
                                  std::min(voxels, edits::kMaxVoxels + 1), edits::kMaxVoxels));
  }
  if (voxels == 0) {
    // Boxes without voxels have reversed corners.
    if (const auto touched = edits::touched_voxels(edit); !touched) {
      return edit_error(EditErrorCode::out_of_range, touched.error().message);
    }
    return edit_error(EditErrorCode::out_of_range, "the edit names no voxels; give writes, fills or a paste");
  }
  checked.bytes = bytes_as_it_came(edit, checked.extent);
  checked.prepared_bytes = bytes_prepared(voxels, settles, reveals);
  return checked;
}

}  // namespace talus::server
