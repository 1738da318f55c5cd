// What clients say, as frames.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <talus/protocol/limits.h>
#include <talus/protocol/message.h>
#include <talus/voxel/codec.h>
#include <talus/voxel/content_hash.h>
#include <talus/voxel/coords.h>

namespace talus::e2e {

struct HelloFields {
  std::uint16_t oldest = protocol::kOldestProtocol;
  std::uint16_t newest = protocol::kProtocolVersion;
  std::vector<std::uint8_t> codecs{kCodecVersion};
  std::uint64_t window_bytes = 0;
  std::string client = "raw client";
  std::string token{};
};
[[nodiscard]] protocol::Frame hello(const HelloFields& fields = {});

struct ViewFields {
  VoxelPos centre{};
  std::uint16_t horizontal_radius = 0;
  std::uint16_t vertical_radius = 0;
  std::vector<wire::LodRing> rings{};
  std::uint32_t number = 0;
  bool horizon = false;
  bool has_base = false;
};
[[nodiscard]] protocol::Frame view(const ViewFields& fields);

[[nodiscard]] wire::ChunkRequest chunk_request(std::uint32_t id, ChunkKey key);
[[nodiscard]] wire::ChunkRequest chunk_request(std::uint32_t id, ChunkKey key, ContentHash known);
[[nodiscard]] protocol::Frame get_chunks(const std::vector<wire::ChunkRequest>& requests);
[[nodiscard]] protocol::Frame cancel(const std::vector<std::uint32_t>& ids);
[[nodiscard]] protocol::Frame get_heights(std::uint32_t id, const std::vector<wire::ColumnPos>& columns);
/// The world's own file if `name` is empty.
[[nodiscard]] protocol::Frame get_file(std::uint32_t id, const std::string& name, std::uint64_t offset);
[[nodiscard]] protocol::Frame credit(std::uint64_t total_bytes);
[[nodiscard]] protocol::Frame edit(std::uint32_t id);
[[nodiscard]] protocol::Frame ping(std::uint64_t nonce);

/// The key and hash of a Chunk or Unchanged.
[[nodiscard]] ChunkKey key_of(const wire::ChunkKey& key);
[[nodiscard]] ContentHash hash_of(const wire::Hash128& hash);

/// A chunk of level 0.
[[nodiscard]] inline ChunkKey at(std::int32_t x, std::int32_t y, std::int32_t z) {
  return {{x, y, z}, Lod{}};
}

}  // namespace talus::e2e
