#include "session/replies.h"

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

}  // namespace

protocol::Frame welcome_frame(const Greeting& greeting, const WorldInfo& world, const Limits& limits) {
  return protocol::make_frame([&](flatbuffers::FlatBufferBuilder& builder) {
    std::vector<flatbuffers::Offset<wire::Material>> materials;
    for (const terrain::Material& material : world.materials) {
      const auto name = builder.CreateString(material.name);
      materials.push_back(wire::CreateMaterial(builder, to_integer(material.id), name,
                                               packed(material.colour), phase_of(material.kind)));
    }
    const auto all_materials = builder.CreateVector(materials);
    const auto said_limits =
        wire::CreateLimits(builder, static_cast<std::uint32_t>(limits.frame_bytes),
                           static_cast<std::uint32_t>(limits.requests_in_flight),
                           static_cast<std::uint32_t>(limits.heights_per_request),
                           static_cast<std::uint16_t>(limits.view_horizontal_radius),
                           static_cast<std::uint16_t>(limits.view_vertical_radius),
                           static_cast<std::uint32_t>(limits.view_chunks), greeting.window_bytes,
                           static_cast<std::uint32_t>(limits.idle_timeout.count()));
    const auto server = builder.CreateString(world.server);

    const wire::Hash128 fingerprint{world.fingerprint.low, world.fingerprint.high};
    const wire::Hash128 store_id{world.store_id.low, world.store_id.high};
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
    return welcome.Finish();
  });
}

protocol::Frame error_frame(wire::ErrorCode code, std::string_view text, std::uint32_t request_id,
                            std::uint32_t retry_after_ms) {
  return protocol::make_frame([&](flatbuffers::FlatBufferBuilder& builder) {
    const auto line = builder.CreateString(text.data(), text.size());
    return wire::CreateError(builder, code, line, request_id, retry_after_ms);
  });
}

protocol::Frame unchanged_frame(std::uint32_t request_id, ChunkKey key, ContentHash hash) {
  return protocol::make_frame([&](flatbuffers::FlatBufferBuilder& builder) {
    const wire::ChunkKey wire_key{key.coord.x, key.coord.y, key.coord.z,
                                  static_cast<std::uint8_t>(key.lod.value())};
    const wire::Hash128 wire_hash{hash.low, hash.high};
    return wire::CreateUnchanged(builder, request_id, &wire_key, 0, &wire_hash);
  });
}

protocol::Frame column_frame(ChunkKey column, const std::vector<wire::UniformRun>& runs) {
  return protocol::make_frame([&](flatbuffers::FlatBufferBuilder& builder) {
    const auto wire_runs = builder.CreateVectorOfStructs(runs);
    return wire::CreateColumn(builder, column.coord.x, column.coord.z,
                              static_cast<std::uint8_t>(column.lod.value()), 0, wire_runs);
  });
}

protocol::Frame heights_frame(std::uint32_t request_id, std::span<const std::int32_t> heights) {
  return protocol::make_frame([&](flatbuffers::FlatBufferBuilder& builder) {
    const auto values = builder.CreateVector(heights.data(), heights.size());
    return wire::CreateHeights(builder, request_id, values);
  });
}

protocol::Frame pong_frame(std::uint64_t nonce) {
  return protocol::make_frame(
      [&](flatbuffers::FlatBufferBuilder& builder) { return wire::CreatePong(builder, nonce); });
}

protocol::Frame go_away_frame(std::string_view reason, std::uint32_t retry_after_ms) {
  return protocol::make_frame([&](flatbuffers::FlatBufferBuilder& builder) {
    const auto line = builder.CreateString(reason.data(), reason.size());
    return wire::CreateGoAway(builder, line, retry_after_ms);
  });
}

}  // namespace talus::server
