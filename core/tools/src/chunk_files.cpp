#include "chunk_files.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include <talus/files/atomic_file.h>
#include <talus/files/npy_file.h>
#include <talus/files/npy_header.h>
#include <talus/files/path_text.h>
#include <talus/files/read_file.h>
#include <talus/voxel/codec.h>
#include <talus/world_files/world_files.h>
#include <zstd.h>

namespace talus::tools {
namespace {

constexpr std::string_view kNoChunk =
    "no chunk of voxels; it must be a .npy array of 32 x 32 x 32 uint8 or uint16, [y][z][x], or a .vox file "
    "of one model of at most 32 voxels a side";

// Above the size of any readable file; .vox files include palettes and scene graphs.
constexpr std::size_t kMaxFileBytes = std::size_t{1} << 22U;

using Bytes = std::string;

bool wide(const DenseVoxels& voxels) {
  return std::any_of(voxels.begin(), voxels.end(), [](MaterialId id) { return to_integer(id) > 255; });
}

tl::expected<Chunk, std::string> chunk_of_npy(const Bytes& bytes) {
  const auto header = files::read_npy_header(std::as_bytes(std::span{bytes}));
  if (!header) return tl::unexpected{header.error()};
  const bool narrow = header->type == "|u1" || header->type == "<u1";
  const std::vector<std::uint64_t> cube(3, kChunkSize);
  if ((!narrow && header->type != "<u2") || header->shape != cube || header->fortran_order) {
    return tl::unexpected{std::string{kNoChunk}};
  }
  const std::size_t item = narrow ? 1 : 2;
  if (bytes.size() - header->data_at != kChunkVolume * item) return tl::unexpected{std::string{kNoChunk}};
  const char* const items = bytes.data() + header->data_at;
  const auto voxels = std::make_unique<DenseVoxels>();
  for (std::size_t i = 0; i < voxels->size(); ++i) {
    const auto byte = [&](std::size_t at) {
      return std::uint16_t{static_cast<std::uint8_t>(items[i * item + at])};
    };
    (*voxels)[i] = MaterialId{static_cast<std::uint16_t>(narrow ? byte(0) : byte(0) | byte(1) << 8U)};
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
  const auto bytes = files::read_regular_file(files::to_path(path), kMaxFileBytes);
  if (!bytes) return tl::unexpected{Failure{bytes.error()}};
  tl::expected<Chunk, std::string> chunk = tl::unexpected{std::string{kNoChunk}};
  if (files::is_npy(std::as_bytes(std::span{*bytes}))) chunk = chunk_of_npy(*bytes);
  if (bytes->starts_with("VOX ")) chunk = chunk_of_vox(*bytes);
  if (!chunk) return failed(path + ": " + chunk.error());
  return *std::move(chunk);
}

Expected<std::vector<std::byte>> read_payload(const std::string& path) {
  const auto bytes = files::read_regular_file(files::to_path(path), kMaxPayloadBytes);
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
  auto file =
      files::NpyFile::create(files::to_path(path), is_wide ? files::NpyType::uint16 : files::NpyType::uint8);
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
  return outcome_of(files::write_file(files::to_path(path), payload));
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
