#include "messages.h"

namespace talus::e2e {
namespace {

using flatbuffers::FlatBufferBuilder;

wire::ChunkKey to_wire(ChunkKey key) {
  return {key.coord.x, key.coord.y, key.coord.z, static_cast<std::uint8_t>(key.lod.value())};
}

}  // namespace

protocol::Frame hello(const HelloFields& fields) {
  return protocol::make_frame([&](FlatBufferBuilder& builder) {
    const auto codecs = builder.CreateVector(fields.codecs);
    const auto client = builder.CreateString(fields.client);
    const auto token = builder.CreateString(fields.token);
    return wire::CreateHello(builder, fields.oldest, fields.newest, codecs, token, client,
                             fields.window_bytes);
  });
}

protocol::Frame view(const ViewFields& fields) {
  return protocol::make_frame([&](FlatBufferBuilder& builder) {
    const auto rings = builder.CreateVectorOfStructs(fields.rings);
    const wire::Voxel centre{fields.centre.x, fields.centre.y, fields.centre.z};
    const wire::Direction direction{0, 0, 0};
    return wire::CreateView(builder, &centre, &direction, fields.horizontal_radius, fields.vertical_radius,
                            rings, 0, fields.number, fields.horizon, fields.has_base);
  });
}

wire::ChunkRequest chunk_request(std::uint32_t id, ChunkKey key) {
  return {id, to_wire(key), false, {}};
}

wire::ChunkRequest chunk_request(std::uint32_t id, ChunkKey key, ContentHash known) {
  return {id, to_wire(key), true, {known.low, known.high}};
}

protocol::Frame get_chunks(const std::vector<wire::ChunkRequest>& requests) {
  return protocol::make_frame([&](FlatBufferBuilder& builder) {
    return wire::CreateGetChunks(builder, builder.CreateVectorOfStructs(requests));
  });
}

protocol::Frame cancel(const std::vector<std::uint32_t>& ids) {
  return protocol::make_frame(
      [&](FlatBufferBuilder& builder) { return wire::CreateCancel(builder, builder.CreateVector(ids)); });
}

protocol::Frame get_heights(std::uint32_t id, const std::vector<wire::ColumnPos>& columns) {
  return protocol::make_frame([&](FlatBufferBuilder& builder) {
    return wire::CreateGetHeights(builder, id, builder.CreateVectorOfStructs(columns));
  });
}

protocol::Frame get_file(std::uint32_t id, const std::string& name, std::uint64_t offset) {
  return protocol::make_frame([&](FlatBufferBuilder& builder) {
    return wire::CreateGetFile(builder, id, builder.CreateString(name), offset);
  });
}

protocol::Frame credit(std::uint64_t total_bytes) {
  return protocol::make_frame(
      [&](FlatBufferBuilder& builder) { return wire::CreateCredit(builder, total_bytes); });
}

protocol::Frame edit(std::uint32_t id) {
  return protocol::make_frame([&](FlatBufferBuilder& builder) { return wire::CreateEdit(builder, id); });
}

protocol::Frame ping(std::uint64_t nonce) {
  return protocol::make_frame([&](FlatBufferBuilder& builder) { return wire::CreatePing(builder, nonce); });
}

ChunkKey key_of(const wire::ChunkKey& key) {
  return {{key.x(), key.y(), key.z()}, Lod::of(key.lod())};
}

ContentHash hash_of(const wire::Hash128& hash) {
  return {hash.low(), hash.high()};
}

}  // namespace talus::e2e
