#include "edits/edit_log.h"

namespace talus::server {

std::size_t bytes_of(const LogEntry& entry) {
  constexpr std::size_t kEntry = 64;
  if (const auto* const attach = std::get_if<edits::AttachEntry>(&entry)) {
    return kEntry + attach->subject.size();
  }
  const auto* const edit = std::get_if<edits::EditEntry>(&entry);
  if (edit == nullptr) {
    std::size_t bytes = kEntry;
    for (const std::string& name : std::get<edits::BindEntry>(entry).names) bytes += kEntry + name.size();
    return bytes;
  }
  std::size_t bytes = kEntry +
                      (edit->edit.guards.size() + edit->edit.writes.size()) * sizeof(edits::VoxelWrite) +
                      edit->edit.fills.size() * sizeof(edits::Fill);
  if (edit->edit.paste) bytes += sizeof(DenseVoxels);
  for (const auto* voxels : {&edit->base, &edit->secrets.hidden, &edit->secrets.base}) {
    for (const auto& [chunk, list] : *voxels) bytes += kEntry + list.size() * sizeof(Override);
  }
  for (const auto& [chunk, voxels] : edit->touched) bytes += kEntry + voxels.size() * sizeof(std::uint16_t);
  return bytes;
}

}  // namespace talus::server
