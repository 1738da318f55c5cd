#include <talus/voxel/codec.h>

#include <memory>

#include "layered.h"
#include "runs.h"
#include "volume.h"

namespace talus {
namespace {

constexpr std::uint8_t kLayeredVersion = 3;
constexpr std::byte kLayered{0};  // the only encoding of version 3
enum class Encoding : std::uint8_t { volume = 1, raw = 2, runs = 3 };

constexpr std::size_t kHeaderBytes = 2;

// Layers up to this size are used without trying other encodings, which takes several times as long.
constexpr std::size_t kGoodLayeredBytes = 1024;

// Layers larger than this (without the header) are seldom shorter than a volume: they are tried after it,
// with the volume's size as the limit.
constexpr std::size_t kTriedLayeredBytes = 2048;

// Runs can be shorter only than volumes above this size.
constexpr std::size_t kGoodVolumeBytes = 2048 - kHeaderBytes;

void put_header(Encoding encoding, std::vector<std::byte>& out) {
  out.push_back(std::byte{kCodecVersion});
  out.push_back(static_cast<std::byte>(encoding));
}

void encode_raw(std::span<const MaterialId, kChunkVolume> voxels, std::vector<std::byte>& out) {
  const std::size_t start = out.size();
  out.resize(start + sizeof(DenseVoxels));
  for (std::size_t i = 0; i < voxels.size(); ++i) {
    out[start + 2 * i] = static_cast<std::byte>(to_integer(voxels[i]) & 0xFF);
    out[start + 2 * i + 1] = static_cast<std::byte>(to_integer(voxels[i]) >> 8);
  }
}

/// Appends layers if they take at most `limit` bytes after the header.
bool append_layered(const Layers& layers, std::size_t limit, std::vector<std::byte>& out) {
  const std::size_t start = out.size();
  out.push_back(std::byte{kLayeredVersion});
  out.push_back(kLayered);
  if (codec::encode_layered(layers, limit, out)) return true;
  out.resize(start);
  return false;
}

/// Appends the shortest of volume, runs and raw voxels, or replaces the layers at `start` if one of these is
/// shorter. `untried`: layers of more than kTriedLayeredBytes, or null.
void append_shortest(const DenseVoxels& voxels, const Layers* untried, std::size_t start,
                     std::vector<std::byte>& out) {
  // The last encoding found is the shortest; it is stored behind the one that it replaces.
  std::size_t limit = out.size() > start ? out.size() - start - kHeaderBytes : sizeof(DenseVoxels);
  std::size_t last = out.size();
  const auto take_last = [&] {
    out.erase(out.begin() + static_cast<std::ptrdiff_t>(start),
              out.begin() + static_cast<std::ptrdiff_t>(last));
    last = out.size();
    limit = last - start - kHeaderBytes;
  };
  put_header(Encoding::volume, out);
  std::size_t changes = 0;
  const bool has_volume = codec::encode_volume(voxels, out, codec::volume_kernels(), &changes);
  const std::size_t volume = has_volume ? out.size() - last - kHeaderBytes : sizeof(DenseVoxels);
  if (volume < limit) {
    take_last();
  } else {
    out.resize(last);
  }
  if (untried != nullptr && limit > kTriedLayeredBytes && append_layered(*untried, limit, out)) take_last();
  // Each run takes more than half a byte.
  if (volume > kGoodVolumeBytes && changes / 2 < limit) {
    put_header(Encoding::runs, out);
    if (codec::encode_runs(voxels, limit, out)) {
      take_last();
    } else {
      out.resize(last);
    }
  }
  if (out.size() > start) return;
  put_header(Encoding::raw, out);
  encode_raw(voxels, out);
}

tl::expected<Chunk, DecodeError> decode_raw(std::span<const std::byte> body) {
  if (body.size() < sizeof(DenseVoxels)) return tl::unexpected{DecodeError::truncated};
  if (body.size() > sizeof(DenseVoxels)) return tl::unexpected{DecodeError::too_long};
  const auto voxels = std::make_shared_for_overwrite<DenseVoxels>();
  for (std::size_t i = 0; i < voxels->size(); ++i) {
    const auto low = std::to_integer<unsigned>(body[2 * i]);
    const auto high = std::to_integer<unsigned>(body[2 * i + 1]);
    (*voxels)[i] = MaterialId{static_cast<std::uint16_t>(low | (high << 8))};
  }
  return Chunk::from_dense(std::shared_ptr<const DenseVoxels>{voxels});
}

}  // namespace

std::string_view describe(DecodeError error) {
  switch (error) {
    case DecodeError::empty:
      return "the chunk payload is empty; it needs at least a codec version and an encoding";
    case DecodeError::unknown_version:
      return "the chunk payload's first byte is not a known codec version; this library reads versions 3 and "
             "4";
    case DecodeError::unknown_encoding:
      return "the chunk payload's second byte names no encoding of its version";
    case DecodeError::truncated:
      return "the chunk payload ends before the chunk does; it must be passed whole";
    case DecodeError::too_long:
      return "the chunk payload goes on after the chunk's end; it must be passed without other bytes";
    case DecodeError::bad_materials:
      return "the chunk payload's list of materials is empty, too long or out of order";
    case DecodeError::bad_number:
      return "the chunk payload holds a number that is past its range or not in its shortest form";
    case DecodeError::bad_ending:
      return "the chunk payload's last bytes do not end its chunk; it was changed in transit";
  }
  return "unknown error";
}

void encode(const Chunk& chunk, std::vector<std::byte>& out) {
  const std::size_t start = out.size();
  const Layers* untried = chunk.layers();
  if (untried != nullptr && append_layered(*untried, kTriedLayeredBytes, out)) {
    if (out.size() - start <= kGoodLayeredBytes) return;
    untried = nullptr;
  }
  if (const DenseVoxels* voxels = chunk.dense()) {
    append_shortest(*voxels, untried, start, out);
    return;
  }
  const auto voxels = std::make_unique_for_overwrite<DenseVoxels>();
  chunk.copy_to(*voxels);
  append_shortest(*voxels, untried, start, out);
}

tl::expected<Chunk, DecodeError> decode(std::span<const std::byte> payload) {
  if (payload.empty()) return tl::unexpected{DecodeError::empty};
  const auto version = std::to_integer<std::uint8_t>(payload[0]);
  if (version != kLayeredVersion && version != kCodecVersion)
    return tl::unexpected{DecodeError::unknown_version};
  if (payload.size() < kHeaderBytes) return tl::unexpected{DecodeError::truncated};
  if (payload.size() > kMaxPayloadBytes) return tl::unexpected{DecodeError::too_long};
  const std::span<const std::byte> body = payload.subspan(kHeaderBytes);
  if (version == kLayeredVersion) {
    if (payload[1] != kLayered) return tl::unexpected{DecodeError::unknown_encoding};
    return codec::decode_layered(body);
  }
  switch (static_cast<Encoding>(payload[1])) {
    case Encoding::volume:
      return codec::decode_volume(body);
    case Encoding::raw:
      return decode_raw(body);
    case Encoding::runs:
      return codec::decode_runs(body);
  }
  return tl::unexpected{DecodeError::unknown_encoding};
}

}  // namespace talus
