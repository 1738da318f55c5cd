#include "chunk_files.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <system_error>

#include <talus/files/atomic_file.h>
#include <talus/files/npy_file.h>
#include <talus/files/read_file.h>
#include <talus/voxel/codec.h>
#include <talus/world_files/world_files.h>
#include <zstd.h>

namespace talus::tools {
namespace {

static_assert(std::endian::native == std::endian::little, "voxels are read as they lie in memory");

constexpr std::string_view kWanted =
    "it must be a .npy array of 32 x 32 x 32 uint8 or uint16, [y][z][x], or a .vox file of one model of at "
    "most "
    "32 voxels a side";

// Above the size of any readable file; .vox files include palettes and scene graphs.
constexpr std::size_t kMaxFileBytes = std::size_t{1} << 22U;

using Bytes = std::string;

bool wide(const DenseVoxels& voxels) {
  return std::any_of(voxels.begin(), voxels.end(), [](MaterialId id) { return to_integer(id) > 255; });
}

std::uint32_t little_endian(const char* bytes) {
  std::uint32_t value = 0;
  std::memcpy(&value, bytes, sizeof value);
  return value;
}

/// The value of `key` in the dictionary of an array's header, without spaces; a tuple is complete.
std::string value_of(const std::string& header, const std::string& key) {
  const std::size_t at = header.find("'" + key + "':");
  if (at == std::string::npos) return {};
  std::string value;
  for (std::size_t i = at + key.size() + 3; i < header.size(); ++i) {
    const bool in_tuple = value.find('(') != std::string::npos && value.find(')') == std::string::npos;
    if (header[i] == '}' || (header[i] == ',' && !in_tuple)) break;
    if (header[i] != ' ') value += header[i];
  }
  return value;
}

std::optional<Chunk> chunk_of_npy(const Bytes& bytes) {
  if (bytes.size() < 12) return std::nullopt;
  const bool first_version = bytes[6] == 1;
  std::size_t length = std::size_t{static_cast<std::uint8_t>(bytes[8])} |
                       std::size_t{static_cast<std::uint8_t>(bytes[9])} << 8U;
  std::size_t start = 10;
  if (!first_version) {
    length = little_endian(bytes.data() + 8);
    start = 12;
  }
  if (length > bytes.size() - start) return std::nullopt;
  const std::string header{bytes.data() + start, length};
  const std::string type = value_of(header, "descr");
  const bool narrow = type == "'|u1'" || type == "'<u1'";
  if (!narrow && type != "'<u2'") return std::nullopt;
  if (value_of(header, "shape") != "(32,32,32)" || value_of(header, "fortran_order") != "False") {
    return std::nullopt;
  }
  const std::size_t item = narrow ? 1 : 2;
  if (bytes.size() - start - length != kChunkVolume * item) return std::nullopt;
  const char* const items = bytes.data() + start + length;
  const auto voxels = std::make_unique<DenseVoxels>();
  for (std::size_t i = 0; i < voxels->size(); ++i) {
    std::uint16_t id = 0;
    std::memcpy(&id, items + i * item, item);
    (*voxels)[i] = MaterialId{id};
  }
  return Chunk::from_dense(*voxels);
}

tl::expected<Chunk, std::string> chunk_of_vox(const Bytes& bytes) {
  const world_files::ModelBounds bounds{kChunkSize, kChunkSize, 1};
  const auto models = world_files::decode_vox(std::as_bytes(std::span{bytes}), bounds);
  if (!models) return tl::unexpected{models.error()};
  const auto voxels = std::make_unique<DenseVoxels>();
  for (const auto& [x, y, z, colour] : models->front().voxels) {
    (*voxels)[voxel_index({x, y, z})] = MaterialId{colour};
  }
  return Chunk::from_dense(*voxels);
}

}  // namespace

Expected<Chunk> read_voxels(const std::string& path) {
  const auto bytes = files::read_regular_file(path, kMaxFileBytes);
  if (!bytes) return tl::unexpected{Failure{bytes.error()}};
  const std::string_view text{*bytes};
  std::optional<Chunk> chunk;
  if (text.starts_with("\x93NUMPY")) chunk = chunk_of_npy(*bytes);
  if (text.starts_with("VOX ")) {
    auto found = chunk_of_vox(*bytes);
    if (!found) return failed(path + ": " + found.error());
    chunk = *std::move(found);
  }
  if (!chunk) return failed(path + ": no chunk of voxels; " + std::string{kWanted});
  return *std::move(chunk);
}

Expected<std::vector<std::byte>> read_payload(const std::string& path) {
  const auto bytes = files::read_regular_file(path, kMaxPayloadBytes);
  if (!bytes && bytes.error().code == std::errc::file_too_large) {
    return failed(path + ": " + std::string{describe(DecodeError::too_long)});
  }
  if (!bytes) return tl::unexpected{Failure{bytes.error()}};
  const auto* const first = reinterpret_cast<const std::byte*>(bytes->data());
  return std::vector<std::byte>{first, first + bytes->size()};
}

Expected<void> write_voxels(const Chunk& chunk, const std::string& path) {
  const auto voxels = std::make_unique<DenseVoxels>();
  chunk.copy_to(*voxels);
  const bool is_wide = wide(*voxels);
  auto file = files::NpyFile::create(path, is_wide ? files::NpyType::uint16 : files::NpyType::uint8);
  if (!file) return tl::unexpected{Failure{file.error()}};
  std::vector<std::uint8_t> narrow;
  std::vector<std::uint16_t> ids;
  for (const MaterialId id : *voxels) {
    narrow.push_back(static_cast<std::uint8_t>(to_integer(id)));
    ids.push_back(to_integer(id));
  }
  const auto written = is_wide ? file->write(0, std::span<const std::uint16_t>{ids})
                               : file->write(0, std::span<const std::uint8_t>{narrow});
  if (!written) return outcome_of(written);
  constexpr std::array<std::size_t, 3> kShape{kChunkSize, kChunkSize, kChunkSize};
  if (const auto finished = file->finish(kShape); !finished) return outcome_of(finished);
  return outcome_of(file->commit());
}

Expected<void> write_payload(std::span<const std::byte> payload, const std::string& path) {
  return outcome_of(files::write_file(path, payload));
}

std::size_t zstd_bytes(const Chunk& chunk) {
  const auto voxels = std::make_unique<DenseVoxels>();
  chunk.copy_to(*voxels);
  std::vector<char> bytes;
  const bool is_wide = wide(*voxels);
  for (const MaterialId id : *voxels) {
    bytes.push_back(static_cast<char>(to_integer(id) & 0xFF));
    if (is_wide) bytes.push_back(static_cast<char>(to_integer(id) >> 8));
  }
  std::vector<char> out(ZSTD_compressBound(bytes.size()));
  return ZSTD_compress(out.data(), out.size(), bytes.data(), bytes.size(), 3);
}

}  // namespace talus::tools
