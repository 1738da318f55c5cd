#include "cluster/entry_codec.h"

#include <utility>

#include <talus/edits/runs.h>
#include <talus/store/bytes.h>
#include <talus/voxel/codec.h>

namespace talus::server::cluster {
namespace {

enum class EntryKind : std::uint8_t { attach, edit, bind };

// Flags of an edit.
constexpr std::uint8_t kSettles = 1;
constexpr std::uint8_t kHasPaste = 2;
constexpr std::uint8_t kWithAir = 4;
constexpr std::uint8_t kHasSecrets = 8;  // only in worlds with secrets, which older talusd cannot join

/// Encodes voxels as differences from the previous one, modulo 2^64. Positions are validated when the edit is
/// evaluated.
class VoxelWriter {
 public:
  explicit VoxelWriter(store::ByteWriter& out) : out_{out} {}
  void put(VoxelPos voxel) {
    put(voxel.x, last_.x);
    put(voxel.y, last_.y);
    put(voxel.z, last_.z);
    last_ = voxel;
  }

 private:
  void put(std::int64_t now, std::int64_t before) {
    out_.zigzag(
        static_cast<std::int64_t>(static_cast<std::uint64_t>(now) - static_cast<std::uint64_t>(before)));
  }
  store::ByteWriter& out_;
  VoxelPos last_{};
};

class VoxelReader {
 public:
  explicit VoxelReader(store::ByteReader& in) : in_{in} {}
  VoxelPos get() {
    for (std::int64_t* const at : {&last_.x, &last_.y, &last_.z}) {
      *at = static_cast<std::int64_t>(static_cast<std::uint64_t>(*at) +
                                      static_cast<std::uint64_t>(in_.zigzag()));
    }
    return last_;
  }

 private:
  store::ByteReader& in_;
  VoxelPos last_{};
};

MaterialId get_material(store::ByteReader& in) {
  return MaterialId{static_cast<std::uint16_t>(in.varint(UINT16_MAX))};
}

/// nullopt is encoded as 0.
void put_optional(std::optional<MaterialId> material, store::ByteWriter& out) {
  out.varint(material ? to_integer(*material) + std::uint64_t{1} : 0);
}
std::optional<MaterialId> get_optional(store::ByteReader& in) {
  const std::uint64_t value = in.varint(std::uint64_t{UINT16_MAX} + 1);
  return value == 0 ? std::nullopt : std::optional{MaterialId{static_cast<std::uint16_t>(value - 1)}};
}

/// Reads a count of items that take at least `bytes` each.
std::size_t count_of(store::ByteReader& in, std::size_t bytes, std::size_t max_count) {
  const std::size_t count = in.count();
  if (count > max_count || count > in.left() / bytes) in.fail();
  return in.ok() ? count : 0;
}

void put_writes(const std::vector<edits::VoxelWrite>& writes, store::ByteWriter& out) {
  out.varint(writes.size());
  VoxelWriter voxels{out};
  for (const edits::VoxelWrite& each : writes) {
    voxels.put(each.voxel);
    out.varint(to_integer(each.material));
  }
}
std::vector<edits::VoxelWrite> get_writes(store::ByteReader& in) {
  std::vector<edits::VoxelWrite> writes;
  const std::size_t count = count_of(in, 4, edits::kMaxVoxels);
  writes.reserve(count);
  VoxelReader voxels{in};
  while (writes.size() < count && in.ok()) {
    const VoxelPos voxel = voxels.get();
    writes.push_back({voxel, get_material(in)});
  }
  return writes;
}

void put_fills(const std::vector<edits::Fill>& fills, store::ByteWriter& out) {
  out.varint(fills.size());
  VoxelWriter corners{out};
  for (const edits::Fill& fill : fills) {
    corners.put(fill.first);
    corners.put(fill.last);
    put_optional(fill.material, out);
    put_optional(fill.only, out);
  }
}
std::vector<edits::Fill> get_fills(store::ByteReader& in) {
  std::vector<edits::Fill> fills;
  const std::size_t count = count_of(in, 8, edits::kMaxVoxels);
  fills.reserve(count);
  VoxelReader corners{in};
  while (fills.size() < count && in.ok()) {
    edits::Fill& fill = fills.emplace_back();
    fill.first = corners.get();
    fill.last = corners.get();
    fill.material = get_optional(in);
    fill.only = get_optional(in);
  }
  return fills;
}

void put_base(const edits::BaseVoxels& base, store::ByteWriter& out) {
  out.varint(base.size());
  store::Bytes runs;
  for (const auto& [chunk, voxels] : base) {
    for (const std::int32_t at : {chunk.x, chunk.y, chunk.z}) out.zigzag(at);
    runs.clear();
    edits::encode_runs(voxels, runs);
    out.counted(runs);
  }
}
edits::BaseVoxels get_base(store::ByteReader& in, std::size_t voxels_left = kMaxBaseVoxels) {
  edits::BaseVoxels base;
  for (std::size_t chunks = count_of(in, 6, kMaxBaseChunks); chunks > 0 && in.ok(); --chunks) {
    ChunkCoord chunk{};
    for (std::int32_t* const at : {&chunk.x, &chunk.y, &chunk.z}) {
      *at = static_cast<std::int32_t>(in.zigzag(UINT32_MAX));
    }
    auto voxels = edits::decode_runs(in.counted(), voxels_left);
    if (!voxels || (!base.empty() && chunk <= base.rbegin()->first)) in.fail();
    if (!in.ok()) break;
    voxels_left -= voxels->size();
    base.emplace_hint(base.end(), chunk, *std::move(voxels));
  }
  return base;
}

void put_secrets(const edits::SecretVoxels& secrets, store::ByteWriter& out) {
  out.varint(secrets.see_through.size());
  for (const MaterialId material : secrets.see_through) out.varint(to_integer(material));
  put_base(secrets.hidden, out);
  put_base(secrets.base, out);
}
edits::SecretVoxels get_secrets(store::ByteReader& in) {
  edits::SecretVoxels secrets;
  for (std::size_t left = count_of(in, 1, kMaxSeeThrough); left > 0 && in.ok(); --left) {
    const MaterialId material = get_material(in);
    if (!secrets.see_through.empty() && material <= secrets.see_through.back()) in.fail();
    secrets.see_through.push_back(material);
  }
  secrets.hidden = get_base(in, kMaxSecretVoxels);
  secrets.base = get_base(in, kMaxSecretVoxels);
  if (secrets.empty()) in.fail();
  return secrets;
}

void put_editor(edits::EditorId editor, store::ByteWriter& out) {
  out.fixed64(editor.low);
  out.fixed64(editor.high);
}
edits::EditorId get_editor(store::ByteReader& in) {
  const std::uint64_t low = in.fixed64();
  return {low, in.fixed64()};
}

void put(const edits::AttachEntry& entry, store::ByteWriter& out) {
  out.byte(static_cast<std::uint8_t>(EntryKind::attach));
  put_editor(entry.editor, out);
  out.varint(entry.epoch);
  out.counted(entry.subject);
}
edits::AttachEntry get_attach(store::ByteReader& in) {
  edits::AttachEntry entry;
  entry.editor = get_editor(in);
  entry.epoch = in.varint();
  entry.subject = in.text(edits::kMaxSubjectBytes);
  return entry;
}

void put(const edits::EditEntry& entry, store::ByteWriter& out) {
  out.byte(static_cast<std::uint8_t>(EntryKind::edit));
  put_editor(entry.editor, out);
  out.varint(entry.epoch);
  out.varint(entry.sequence);
  out.counted(entry.subject);
  const auto& paste = entry.edit.paste;
  out.byte(static_cast<std::uint8_t>((entry.settles != nullptr ? kSettles : 0) | (paste ? kHasPaste : 0) |
                                     (paste && paste->with_air ? kWithAir : 0) |
                                     (entry.secrets.empty() ? 0 : kHasSecrets)));
  put_writes(entry.edit.guards, out);
  put_writes(entry.edit.writes, out);
  put_fills(entry.edit.fills, out);
  if (paste) {
    VoxelWriter{out}.put(paste->origin);
    store::Bytes payload;
    talus::encode(paste->voxels, payload);
    out.counted(payload);
  }
  put_base(entry.base, out);
  if (!entry.secrets.empty()) put_secrets(entry.secrets, out);
}
/// `is_newer` is set if the paste uses an unknown codec.
edits::EditEntry get_edit(store::ByteReader& in, const edits::SettleRulesPtr& settles, bool& is_newer) {
  edits::EditEntry entry;
  entry.editor = get_editor(in);
  entry.epoch = in.varint();
  entry.sequence = in.varint();
  entry.subject = in.text(edits::kMaxSubjectBytes);
  const std::uint8_t flags = in.byte();
  const bool pastes = (flags & kHasPaste) != 0;
  if (flags > (kSettles | kHasPaste | kWithAir | kHasSecrets) || (!pastes && (flags & kWithAir) != 0))
    in.fail();
  if ((flags & kSettles) != 0) {
    entry.settles = settles;
    if (settles == nullptr) in.fail();
  }
  entry.edit.guards = get_writes(in);
  entry.edit.writes = get_writes(in);
  entry.edit.fills = get_fills(in);
  if (pastes) {
    const VoxelPos origin = VoxelReader{in}.get();
    auto voxels = talus::decode(in.counted());
    if (!voxels) {
      is_newer = in.ok() && (voxels.error() == DecodeError::unknown_version ||
                             voxels.error() == DecodeError::unknown_encoding);
      in.fail();
    }
    if (in.ok()) entry.edit.paste = edits::Paste{origin, *std::move(voxels), (flags & kWithAir) != 0};
  }
  entry.base = get_base(in);
  if ((flags & kHasSecrets) != 0) entry.secrets = get_secrets(in);
  return entry;
}

void put(const edits::BindEntry& entry, store::ByteWriter& out) {
  out.byte(static_cast<std::uint8_t>(EntryKind::bind));
  out.varint(entry.names.size());
  for (const std::string& name : entry.names) out.counted(name);
}
edits::BindEntry get_bind(store::ByteReader& in) {
  edits::BindEntry entry;
  for (std::size_t left = count_of(in, 1, kMaxNames); left > 0 && in.ok(); --left) {
    entry.names.push_back(in.text(edits::kMaxMaterialNameBytes));
  }
  return entry;
}

}  // namespace

void encode(const LogEntry& entry, store::Bytes& out) {
  store::ByteWriter writer{out};
  writer.byte(kEntryFormat);
  std::visit([&](const auto& each) { put(each, writer); }, entry);
}

tl::expected<LogEntry, EntryFault> decode_entry(std::span<const std::byte> bytes,
                                                const edits::SettleRulesPtr& settles) {
  store::ByteReader in{bytes};
  const std::uint8_t format = in.byte();
  const std::uint8_t kind = in.byte();
  if (!in.ok() || format == 0) return tl::unexpected{EntryFault::damaged};
  if (format > kEntryFormat) return tl::unexpected{EntryFault::newer};
  bool is_newer = false;
  LogEntry entry;
  switch (static_cast<EntryKind>(kind)) {
    case EntryKind::attach:
      entry = get_attach(in);
      break;
    case EntryKind::edit:
      entry = get_edit(in, settles, is_newer);
      break;
    case EntryKind::bind:
      entry = get_bind(in);
      break;
    default:
      return tl::unexpected{EntryFault::newer};
  }
  if (is_newer) return tl::unexpected{EntryFault::newer};
  if (!in.ended()) return tl::unexpected{EntryFault::damaged};
  return entry;
}

}  // namespace talus::server::cluster
