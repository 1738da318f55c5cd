#include "outgoing.h"

#include <algorithm>
#include <array>

#include <talus/protocol/limits.h>
#include <talus/voxel/codec.h>

namespace talus::client {
namespace {

// Upper bound of prefix, root, tables and alignment in any message with one list.
constexpr std::size_t kEnvelopeBytes = 128;

std::size_t fitting(std::uint32_t frame_bytes, std::size_t element_bytes) {
  return frame_bytes <= kEnvelopeBytes ? 0 : (frame_bytes - kEnvelopeBytes) / element_bytes;
}

wire::ChunkKey wire_key(const ChunkKey& key) {
  return {key.coord.x, key.coord.y, key.coord.z, static_cast<std::uint8_t>(key.lod.value())};
}

wire::Voxel wire_voxel(VoxelPos at) {
  return {at.x, at.y, at.z};
}

}  // namespace

protocol::Frame hello_frame(const Options& options) {
  return protocol::make_frame([&](auto& b) {
    const auto codec_list = b.CreateVector(std::vector{kCodecVersion});
    const auto token = b.CreateString(options.token);
    const auto name = b.CreateString(options.client_name);
    return wire::CreateHello(b, protocol::kOldestProtocol, protocol::kProtocolVersion, codec_list, token,
                             name, options.window_bytes);
  });
}

protocol::Frame view_frame(const View& view, std::uint32_t number, const std::vector<ReceivedChunk>& known,
                           bool has_base) {
  return protocol::make_frame([&](auto& b) {
    const wire::Voxel centre{view.centre.x, view.centre.y, view.centre.z};
    const wire::Direction direction{view.direction.x, view.direction.y, view.direction.z};
    std::vector<wire::LodRing> rings;
    for (const auto& ring : view.rings) {
      rings.emplace_back(static_cast<std::uint8_t>(ring.lod.value()), ring.radius);
    }
    const auto ring_list = b.CreateVectorOfStructs(rings);
    std::vector<wire::KnownChunk> held;
    held.reserve(known.size());
    for (const ReceivedChunk& chunk : known) {
      held.emplace_back(wire_key(chunk.key), wire::Hash128{chunk.hash.low, chunk.hash.high});
    }
    const auto held_list = held.empty() ? 0 : b.CreateVectorOfStructs(held);
    return wire::CreateView(b, &centre, &direction, view.horizontal_radius, view.vertical_radius, ring_list,
                            held_list, number, view.horizon, has_base);
  });
}

protocol::Frame heights_frame(std::uint32_t id, const HeightsRequest& request, const WorldInfo& world) {
  return protocol::make_frame([&](auto& b) {
    std::vector<wire::ColumnPos> columns;
    columns.reserve(request.columns.size());
    for (const auto& column : request.columns) columns.emplace_back(column.x, column.z);
    std::vector<std::uint8_t> fields;
    for (const std::string& name : request.fields) {
      const auto found = std::find(world.fields.begin(), world.fields.end(), name);
      fields.push_back(static_cast<std::uint8_t>(found - world.fields.begin()));
    }
    const auto column_list = b.CreateVectorOfStructs(columns);
    const auto field_list = fields.empty() ? 0 : b.CreateVector(fields);
    return wire::CreateGetHeights(b, id, column_list, request.looks, field_list);
  });
}

protocol::Frame file_frame(std::uint32_t id, const FileRequest& request) {
  return protocol::make_frame([&](auto& b) {
    const auto name = request.name.empty() ? 0 : b.CreateString(request.name);
    return wire::CreateGetFile(b, id, name, request.offset);
  });
}

protocol::Frame get_chunks_frame(const std::vector<wire::ChunkRequest>& requests) {
  return protocol::make_frame(
      [&](auto& b) { return wire::CreateGetChunks(b, b.CreateVectorOfStructs(requests)); });
}

protocol::Frame cancel_frame(std::span<const std::uint32_t> ids) {
  return protocol::make_frame(
      [&](auto& b) { return wire::CreateCancel(b, b.CreateVector(ids.data(), ids.size())); });
}

protocol::Frame credit_frame(std::uint64_t total_bytes) {
  return protocol::make_frame([&](auto& b) { return wire::CreateCredit(b, total_bytes); });
}

protocol::Frame attach_frame(edits::EditorId editor, std::uint64_t seen_revision) {
  return protocol::make_frame([&](auto& b) {
    const wire::Hash128 id{editor.low, editor.high};
    return wire::CreateAttach(b, &id, seen_revision);
  });
}

protocol::Frame edit_frame(std::uint32_t id, const OpenEdit& open) {
  const Edit& edit = open.edit;
  return protocol::make_frame([&](auto& b) {
    const auto voxels = [&](const std::vector<VoxelWrite>& list) {
      std::vector<wire::VoxelWrite> wire;
      wire.reserve(list.size());
      for (const VoxelWrite& each : list)
        wire.emplace_back(wire_voxel(each.voxel), to_integer(each.material));
      return wire.empty() ? 0 : b.CreateVectorOfStructs(wire);
    };
    std::vector<wire::Fill> fills;
    for (const Fill& fill : edit.fills) {
      constexpr unsigned kOfAny = 1;
      constexpr unsigned kAsGenerated = 2;
      const unsigned flags = (fill.only ? 0 : kOfAny) | (fill.material ? 0 : kAsGenerated);
      fills.emplace_back(wire_voxel(fill.first), wire_voxel(fill.last),
                         to_integer(fill.material.value_or(kAir)), to_integer(fill.only.value_or(kAir)),
                         static_cast<std::uint8_t>(flags));
    }
    const auto writes = voxels(edit.writes);
    const auto guards = voxels(edit.guards);
    const auto fill_list = fills.empty() ? 0 : b.CreateVectorOfStructs(fills);
    flatbuffers::Offset<wire::Paste> paste;
    if (edit.paste) {
      std::vector<std::byte> payload;
      encode(edit.paste->voxels, payload);
      const auto bytes =
          b.CreateVector(reinterpret_cast<const std::uint8_t*>(payload.data()), payload.size());
      const wire::Voxel origin = wire_voxel(edit.paste->origin);
      paste = wire::CreatePaste(b, &origin, bytes, edit.paste->with_air);
    }
    const auto subject = edit.subject.empty() ? 0 : b.CreateString(edit.subject);
    return wire::CreateEdit(b, id, writes, open.sequence, guards, fill_list, paste, subject);
  });
}

protocol::Frame ping_frame(std::uint64_t nonce) {
  return protocol::make_frame([&](auto& b) { return wire::CreatePing(b, nonce); });
}

wire::ChunkRequest wire_request(std::uint32_t id, const ChunkRequest& request) {
  const auto known = request.known.value_or(ContentHash{});
  return {id, wire_key(request.key), request.known.has_value(), wire::Hash128{known.low, known.high}};
}

std::size_t chunk_requests_per_frame(std::uint32_t frame_bytes) {
  return fitting(frame_bytes, sizeof(wire::ChunkRequest));
}

std::size_t known_per_frame(std::uint32_t frame_bytes) {
  constexpr std::uint32_t kViewBytes = 256;  // includes a ring of each level
  return frame_bytes < kViewBytes ? 0 : fitting(frame_bytes - kViewBytes, sizeof(wire::KnownChunk));
}

std::size_t columns_per_frame(std::uint32_t frame_bytes) {
  return fitting(frame_bytes, sizeof(wire::ColumnPos));
}

}  // namespace talus::client
