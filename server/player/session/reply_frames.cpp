#include "player/session/reply_frames.h"

#include <talus/edits/runs.h>

namespace talus::server {
namespace {

wire::Phase phase_of(terrain::MaterialKind kind) {
  switch (kind) {
    case terrain::MaterialKind::air:
      return wire::Phase::gas;
    case terrain::MaterialKind::water:
      return wire::Phase::liquid;
    default:
      return wire::Phase::solid;
  }
}

std::uint32_t packed(terrain::Colour colour) {
  return (std::uint32_t{colour.red} << 16) | (std::uint32_t{colour.green} << 8) | colour.blue;
}

std::uint32_t on_wire(std::chrono::milliseconds time) {
  return static_cast<std::uint32_t>(time.count());
}

wire::Hash128 on_wire(ContentHash hash) {
  return {hash.low, hash.high};
}

wire::ChunkKey on_wire(ChunkKey key) {
  return {key.coord.x, key.coord.y, key.coord.z, static_cast<std::uint8_t>(key.lod.value())};
}

auto rates_table(flatbuffers::FlatBufferBuilder& builder, const RateSet& rates,
                 std::chrono::milliseconds burst) {
  return wire::CreateRates(builder, rates.chunks.per_second, rates.bytes.per_second,
                           rates.requests.per_second, on_wire(burst));
}

}  // namespace

protocol::Frame welcome_frame(const Greeting& greeting, const WorldInfo& world, const SessionLimits& limits,
                              const RateLimits& rates) {
  return protocol::make_frame([&](flatbuffers::FlatBufferBuilder& builder) {
    std::vector<flatbuffers::Offset<wire::Material>> materials;
    for (const terrain::Material& material : world.materials) {
      const auto name = builder.CreateString(material.name);
      materials.push_back(wire::CreateMaterial(builder, to_integer(material.id), name,
                                               packed(material.colour), phase_of(material.kind)));
    }
    const auto all_materials = builder.CreateVector(materials);
    const auto session_rates = rates_table(builder, rates.session, rates.burst);
    const auto address_rates = rates_table(builder, rates.address, rates.burst);
    const auto said_limits =
        wire::CreateLimits(builder, limits.frame_bytes, limits.requests_in_flight, limits.heights_per_request,
                           limits.view_horizontal_radius, limits.view_vertical_radius, limits.view_chunks,
                           greeting.window_bytes, on_wire(limits.idle_timeout), session_rates, address_rates,
                           /*view_horizon=*/true, limits.view_base);
    const auto server = builder.CreateString(world.server);
    const auto looks = builder.CreateVectorOfStrings(world.looks);
    const auto fields = builder.CreateVectorOfStrings(world.fields);
    const auto world_file = world.world_file.empty() ? 0 : builder.CreateString(world.world_file);

    const wire::Hash128 fingerprint = on_wire(world.fingerprint);
    const wire::Hash128 store_id = on_wire(world.store_id);
    const wire::Voxel spawn{world.spawn.x, world.spawn.y, world.spawn.z};
    wire::WelcomeBuilder welcome{builder};
    welcome.add_protocol(greeting.protocol);
    welcome.add_codec(greeting.codec);
    welcome.add_fingerprint(&fingerprint);
    welcome.add_store_id(&store_id);
    welcome.add_chunk_size(kChunkSize);
    welcome.add_materials(all_materials);
    welcome.add_min_y(world.heights.low);
    welcome.add_max_y(world.heights.high);
    welcome.add_spawn(&spawn);
    welcome.add_limits(said_limits);
    welcome.add_server(server);
    welcome.add_looks(looks);
    welcome.add_fields(fields);
    welcome.add_world_file(world_file);
    return welcome.Finish();
  });
}

protocol::Frame error_frame(wire::ErrorCode code, std::string_view text, const Subject& subject,
                            std::chrono::milliseconds retry_after) {
  using About = wire::ErrorAbout;
  const auto number_of = [&](auto... kinds) {
    return ((subject.about == kinds) || ...) ? subject.number : 0;
  };
  // Clients that do not know `about` look for the id of a duplicate_id in `request_id`.
  const std::uint32_t request_id =
      code == wire::ErrorCode::duplicate_id ? subject.number : number_of(About::request);
  const wire::ChunkKey chunk = on_wire(subject.chunk);
  return protocol::make_frame([&](flatbuffers::FlatBufferBuilder& builder) {
    const auto line = builder.CreateString(text.data(), text.size());
    return wire::CreateError(builder, code, line, request_id, on_wire(retry_after), subject.about,
                             number_of(About::repeated_request), number_of(About::view, About::view_chunk),
                             subject.about == About::view_chunk ? &chunk : nullptr);
  });
}

protocol::Frame unchanged_frame(std::uint32_t request_id, ChunkKey key, const EncodedChunk& chunk) {
  return protocol::make_frame([&](flatbuffers::FlatBufferBuilder& builder) {
    const wire::ChunkKey wire_key = on_wire(key);
    const wire::Hash128 wire_hash = on_wire(chunk.hash());
    return wire::CreateUnchanged(builder, request_id, &wire_key, chunk.revision(), &wire_hash);
  });
}

protocol::Frame edit_broadcast_frame(ChunkKey key, std::uint64_t previous, const ChangedVoxels& changed) {
  std::vector<std::byte> runs;
  edits::encode_runs(changed.voxels, runs);
  return protocol::make_frame([&](flatbuffers::FlatBufferBuilder& builder) {
    const wire::ChunkKey wire_key = on_wire(key);
    const auto bytes = builder.CreateVector(reinterpret_cast<const std::uint8_t*>(runs.data()), runs.size());
    return wire::CreateEditBroadcast(builder, &wire_key, changed.revision, previous, 0, bytes);
  });
}

protocol::Frame chunk_frame(std::uint32_t request_id, ChunkKey key, const EncodedChunk& chunk) {
  protocol::Frame frame;
  frame.reserve(chunk.frame_bytes());
  chunk.append_frame(frame, request_id, key);
  return frame;
}

protocol::Frame column_frame(ChunkKey column, const std::vector<wire::UniformRun>& runs) {
  // Rows with edits are not in any run.
  return protocol::make_frame([&](flatbuffers::FlatBufferBuilder& builder) {
    const auto wire_runs = builder.CreateVectorOfStructs(runs);
    return wire::CreateUniformColumn(builder, column.coord.x, column.coord.z,
                                     static_cast<std::uint8_t>(column.lod.value()), kBaseRevision, wire_runs);
  });
}

protocol::Frame view_complete_frame(std::uint32_t number) {
  return protocol::make_frame(
      [&](flatbuffers::FlatBufferBuilder& builder) { return wire::CreateViewComplete(builder, number); });
}

protocol::Frame heights_frame(std::uint32_t request_id, const HeightsResult& found) {
  return protocol::make_frame([&](flatbuffers::FlatBufferBuilder& builder) {
    const auto heights = builder.CreateVector(found.heights_fx);
    const auto looks = found.looks.empty() ? 0 : builder.CreateVector(found.looks);
    const auto values = found.values.empty() ? 0 : builder.CreateVector(found.values);
    return wire::CreateHeights(builder, request_id, heights, looks, values);
  });
}

protocol::Frame file_part_frame(std::uint32_t request_id, std::uint64_t size, std::string_view bytes) {
  return protocol::make_frame([&](flatbuffers::FlatBufferBuilder& builder) {
    const auto part = builder.CreateVector(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
    return wire::CreateFilePart(builder, request_id, size, part);
  });
}

protocol::Frame attached_frame(const EditorSession& editor, std::uint64_t voxels_per_second) {
  return protocol::make_frame([&](flatbuffers::FlatBufferBuilder& builder) {
    const wire::Hash128 id{editor.editor.low, editor.editor.high};
    const auto limits = wire::CreateEditLimits(
        builder, static_cast<std::uint32_t>(edits::kMaxVoxels), static_cast<std::uint32_t>(edits::kMaxChunks),
        static_cast<std::uint32_t>(edits::kKeptResults), voxels_per_second);
    return wire::CreateAttached(builder, &id, editor.epoch, editor.last_sequence, editor.known,
                                editor.revision, limits);
  });
}

protocol::Frame edit_result_frame(std::uint32_t request_id, const edits::EditResult& result) {
  return protocol::make_frame([&](flatbuffers::FlatBufferBuilder& builder) {
    return wire::CreateEditResult(builder, request_id, result.revision, result.changed);
  });
}

protocol::Frame pong_frame(std::uint64_t nonce) {
  return protocol::make_frame(
      [&](flatbuffers::FlatBufferBuilder& builder) { return wire::CreatePong(builder, nonce); });
}

protocol::Frame go_away_frame(std::string_view reason, std::chrono::milliseconds retry_after) {
  return protocol::make_frame([&](flatbuffers::FlatBufferBuilder& builder) {
    const auto line = builder.CreateString(reason.data(), reason.size());
    return wire::CreateGoAway(builder, line, on_wire(retry_after));
  });
}

}  // namespace talus::server
