#include "incoming.h"

#include <talus/edits/runs.h>
#include <talus/voxel/codec.h>

#include "printable_line.h"

namespace talus::client {
namespace {

constexpr std::size_t kMaxTextBytes = 300;

ErrorKind kind_of(wire::ErrorCode code) {
  switch (code) {
    case wire::ErrorCode::version:
    case wire::ErrorCode::unauthorized:
    case wire::ErrorCode::forbidden:
      return ErrorKind::refused;
    case wire::ErrorCode::malformed:
    case wire::ErrorCode::unexpected:
    case wire::ErrorCode::duplicate_id:
      return ErrorKind::broken_protocol;
    case wire::ErrorCode::too_large:
    case wire::ErrorCode::out_of_range:
      return ErrorKind::out_of_range;
    case wire::ErrorCode::too_many_requests:
    case wire::ErrorCode::overloaded:
      return ErrorKind::overloaded;
    case wire::ErrorCode::cancelled:
      return ErrorKind::cancelled;
    case wire::ErrorCode::conflict:
      return ErrorKind::conflict;
    case wire::ErrorCode::not_applied:
      return ErrorKind::not_applied;
    case wire::ErrorCode::timeout:
      return ErrorKind::timed_out;
    default:
      return ErrorKind::server_failed;
  }
}

Result<Material> read_material(const wire::Material& material) {
  if (material.phase() > wire::Phase::MAX) {
    return tl::unexpected{broken_protocol("Welcome has a material of an unknown phase")};
  }
  return Material{MaterialId{material.id()}, read_text(material.name()), material.colour() & 0xFFFFFFU,
                  static_cast<Phase>(material.phase())};
}

std::vector<std::string> read_texts(
    const flatbuffers::Vector<flatbuffers::Offset<flatbuffers::String>>* texts) {
  std::vector<std::string> read;
  if (texts == nullptr) return read;
  for (const auto* text : *texts) read.push_back(read_text(text));
  return read;
}

std::optional<Rates> read_rates(const wire::Rates* rates) {
  if (rates == nullptr) return std::nullopt;
  return Rates{rates->chunks(), rates->bytes(), rates->requests(),
               std::chrono::milliseconds{rates->burst_ms()}};
}

ServerLimits read_limits(const wire::Limits& limits) {
  return {limits.frame_bytes(),
          limits.requests_in_flight(),
          limits.heights_per_request(),
          limits.view_horizontal_radius(),
          limits.view_vertical_radius(),
          limits.view_chunks(),
          limits.window_bytes(),
          std::chrono::milliseconds{limits.idle_timeout_ms()},
          read_rates(limits.session_rates()),
          read_rates(limits.address_rates()),
          limits.view_horizon(),
          limits.view_base()};
}

}  // namespace

ClientError broken_protocol(std::string what) {
  return {ErrorKind::broken_protocol, "the server broke the protocol: " + std::move(what), {}};
}

std::string read_text(const flatbuffers::String* text) {
  return text == nullptr ? std::string{} : printable_line(text->string_view(), kMaxTextBytes);
}

ContentHash read_hash(const wire::Hash128* hash) {
  return hash == nullptr ? ContentHash{} : ContentHash{hash->low(), hash->high()};
}

Result<WorldInfo> read_welcome(const wire::Welcome& welcome) {
  if (welcome.chunk_size() != kChunkSize) {
    return tl::unexpected{ClientError{ErrorKind::refused,
                                      "the server's chunks have " + std::to_string(welcome.chunk_size()) +
                                          " voxels along an edge; this client reads chunks of 32",
                                      {}}};
  }
  if (welcome.codec() != kCodecVersion) {
    return tl::unexpected{broken_protocol("Welcome picks chunk codec " + std::to_string(welcome.codec()) +
                                          ", which was not offered")};
  }
  if (welcome.fingerprint() == nullptr || welcome.materials() == nullptr || welcome.spawn() == nullptr ||
      welcome.limits() == nullptr) {
    return tl::unexpected{broken_protocol("Welcome lacks fingerprint, materials, spawn or limits")};
  }
  WorldInfo world;
  world.protocol = welcome.protocol();
  world.fingerprint = read_hash(welcome.fingerprint());
  world.store_id = read_hash(welcome.store_id());
  for (const auto* material : *welcome.materials()) {
    auto read = read_material(*material);
    if (!read) return tl::unexpected{read.error()};
    world.materials.push_back(std::move(*read));
  }
  world.min_y = welcome.min_y();
  world.max_y = welcome.max_y();
  if (!is_height_range(world.heights())) {
    return tl::unexpected{broken_protocol("Welcome has heights from " + std::to_string(world.min_y) + " to " +
                                          std::to_string(world.max_y) + "; a world has at most " +
                                          std::to_string(kMaxWorldRows) + " rows")};
  }
  world.spawn = {welcome.spawn()->x(), welcome.spawn()->y(), welcome.spawn()->z()};
  world.limits = read_limits(*welcome.limits());
  world.server = read_text(welcome.server());
  world.looks = read_texts(welcome.looks());
  world.fields = read_texts(welcome.fields());
  return world;
}

Result<ChunkKey> read_key(const wire::ChunkKey* key) {
  if (key == nullptr) return tl::unexpected{broken_protocol("a chunk without coordinates")};
  const auto lod = Lod::checked(key->lod());
  if (!lod) return tl::unexpected{broken_protocol(lod.error().message)};
  auto checked = checked_chunk(key->x(), key->y(), key->z(), *lod);
  if (!checked) return tl::unexpected{broken_protocol(checked.error().message)};
  return *checked;
}

Result<ReceivedChunk> read_chunk(ChunkKey key, const wire::Chunk& message) {
  const auto bad = [&](const std::string& why) {
    return tl::unexpected{ClientError{ErrorKind::bad_chunk, "chunk " + to_string(key) + ": " + why, {}}};
  };
  const auto* payload = message.payload();
  const auto bytes = payload == nullptr ? std::span<const std::byte>{}
                                        : std::as_bytes(std::span{payload->data(), payload->size()});
  auto chunk = decode(bytes);
  if (!chunk) return bad(std::string{describe(chunk.error())});
  const ContentHash promised = read_hash(message.hash());
  const ContentHash found = content_hash(*chunk);
  if (found != promised) {
    return bad("its content has hash " + to_string(found) + " where the server promised " +
               to_string(promised));
  }
  return ReceivedChunk{key, message.revision(), promised, std::make_shared<const Chunk>(std::move(*chunk))};
}

Result<std::vector<Override>> read_runs(const ChunkKey& key, const wire::EditBroadcast& edit) {
  const auto bytes = edit.runs() == nullptr
                         ? std::span<const std::byte>{}
                         : std::as_bytes(std::span{edit.runs()->data(), edit.runs()->size()});
  auto voxels = edits::decode_runs(bytes);
  if (voxels) return *std::move(voxels);
  return tl::unexpected{broken_protocol("an EditBroadcast for chunk " + to_string(key) + ": " +
                                        std::string{describe(voxels.error())})};
}

Result<ReceivedChunk> read_broadcast(const ReceivedChunk& chunk, const wire::EditBroadcast& edit) {
  const auto voxels = read_runs(chunk.key, edit);
  if (!voxels) return tl::unexpected{voxels.error()};
  auto edited = std::make_shared<const Chunk>(chunk.chunk->with_overrides(*voxels));
  const ContentHash hash = content_hash(*edited);
  return ReceivedChunk{chunk.key, edit.revision(), hash, std::move(edited)};
}

ClientError read_error(const wire::Error& error) {
  const std::string text = read_text(error.text());
  return {kind_of(error.code()),
          "the server says: " + (text.empty() ? std::string{wire::EnumNameErrorCode(error.code())} : text),
          std::chrono::milliseconds{error.retry_after_ms()}};
}

}  // namespace talus::client
