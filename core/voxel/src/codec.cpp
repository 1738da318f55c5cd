#include <talus/voxel/codec.h>

#include <memory>

#include "layered.h"
#include "palette.h"

namespace talus {
namespace {

enum class Encoding : std::uint8_t { layered, palette, raw };

constexpr std::size_t kHeaderBytes = 2;

// Layers that code this well are kept without trying the palette: it takes tens of times as long, and was
// smaller for a quarter of the sample worlds' chunks of levels 0 and 2, by some 20 bytes.
constexpr std::size_t kGoodBytes = 1024;

void put_header(Encoding encoding, std::vector<std::byte>& out) {
  out.push_back(std::byte{kCodecVersion});
  out.push_back(static_cast<std::byte>(encoding));
}

void encode_raw(std::span<const MaterialId, kChunkVolume> voxels, std::vector<std::byte>& out) {
  out.reserve(out.size() + sizeof(DenseVoxels));
  for (const MaterialId voxel : voxels) {
    out.push_back(static_cast<std::byte>(to_integer(voxel) & 0xFF));
    out.push_back(static_cast<std::byte>(to_integer(voxel) >> 8));
  }
}

tl::expected<Chunk, DecodeError> decode_raw(std::span<const std::byte> body) {
  if (body.size() < sizeof(DenseVoxels)) return tl::unexpected{DecodeError::truncated};
  if (body.size() > sizeof(DenseVoxels)) return tl::unexpected{DecodeError::too_long};
  const auto voxels = std::make_unique_for_overwrite<DenseVoxels>();
  for (std::size_t i = 0; i < voxels->size(); ++i) {
    const auto low = std::to_integer<unsigned>(body[2 * i]);
    const auto high = std::to_integer<unsigned>(body[2 * i + 1]);
    (*voxels)[i] = MaterialId{static_cast<std::uint16_t>(low | (high << 8))};
  }
  return Chunk::from_dense(*voxels);
}

}  // namespace

std::string_view describe(DecodeError error) {
  switch (error) {
    case DecodeError::empty:
      return "the chunk payload is empty; it needs at least a codec version and an encoding";
    case DecodeError::unknown_version:
      return "the chunk payload's first byte is no codec version known here; this library reads versions 2 "
             "and 3";
    case DecodeError::unknown_encoding:
      return "the chunk payload's second byte names no encoding; 0 is layered, 1 palette, 2 raw";
    case DecodeError::truncated:
      return "the chunk payload ends before the chunk does; it must be passed whole";
    case DecodeError::too_long:
      return "the chunk payload goes on after the chunk's end; it must be passed without other bytes";
    case DecodeError::bad_materials:
      return "the chunk payload's list of materials is empty, too long or out of order";
    case DecodeError::bad_number:
      return "the chunk payload holds a number that is past its range or not in its shortest form";
    case DecodeError::bad_ending:
      return "the chunk payload's last bytes are not those that end its chunk; it was changed on its way";
  }
  return "unknown error";
}

void encode(const Chunk& chunk, std::vector<std::byte>& out) {
  const std::size_t start = out.size();
  std::size_t limit = sizeof(DenseVoxels) + 1;
  if (const Layers* layers = chunk.layers()) {
    put_header(Encoding::layered, out);
    if (codec::encode_layered(*layers, out)) {
      if (out.size() - start <= kGoodBytes) return;
      limit = out.size() - start - kHeaderBytes;
    } else {
      out.resize(start);
    }
  }
  const auto voxels = std::make_unique_for_overwrite<DenseVoxels>();
  chunk.copy_to(*voxels);
  std::vector<std::byte> palette;
  put_header(Encoding::palette, palette);
  if (codec::encode_palette(*voxels, limit, palette)) {
    out.resize(start);
    out.insert(out.end(), palette.begin(), palette.end());
    return;
  }
  if (out.size() > start) return;
  put_header(Encoding::raw, out);
  encode_raw(*voxels, out);
}

tl::expected<Chunk, DecodeError> decode(std::span<const std::byte> payload) {
  if (payload.empty()) return tl::unexpected{DecodeError::empty};
  const auto version = std::to_integer<unsigned>(payload[0]);
  if (version < kOldestCodecVersion || version > kCodecVersion)
    return tl::unexpected{DecodeError::unknown_version};
  if (payload.size() < kHeaderBytes) return tl::unexpected{DecodeError::truncated};
  if (payload.size() > kMaxPayloadBytes) return tl::unexpected{DecodeError::too_long};
  const std::span<const std::byte> body = payload.subspan(kHeaderBytes);
  switch (static_cast<Encoding>(payload[1])) {
    case Encoding::layered:
      return version == 2 ? codec::decode_layered_v2(body) : codec::decode_layered(body);
    case Encoding::palette:
      return codec::decode_palette(body);
    case Encoding::raw:
      return decode_raw(body);
  }
  return tl::unexpected{DecodeError::unknown_encoding};
}

}  // namespace talus
