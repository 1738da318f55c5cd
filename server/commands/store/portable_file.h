// All edits of a store in one file that any talusd reads, independent of the database; FORMAT.md in this
// folder specifies every byte. Streams in bounded memory. Pure; reads any bytes safely.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include <talus/edits/batch.h>
#include <talus/store/records.h>

namespace talus::server {

inline constexpr std::uint32_t kPortableVersion = 1;
/// Maximum size of a block in bytes.
inline constexpr std::size_t kMaxPortableBlock = std::size_t{1} << 20U;
inline constexpr std::size_t kMaxMaterialName = 256;

struct PortableHeader {
  ContentHash fingerprint;  // the world's
  ContentHash store_id;     // of the exported store
  edits::Head head;         // of the exported store; its hash covers all overrides of the file
  std::map<std::string, MaterialId> materials;
  bool operator==(const PortableHeader&) const = default;
};

struct PortableChunk {
  ChunkCoord chunk;
  std::vector<Override> voxels;  // by ascending index, not empty
  bool operator==(const PortableChunk&) const = default;
};

class PortableWriter {
 public:
  using Status = tl::expected<void, std::string>;
  using Sink = std::function<Status(std::span<const std::byte>)>;

  explicit PortableWriter(Sink sink) : sink_{std::move(sink)} {}
  /// Call first, once. Rejects names that are longer or more than a reader accepts.
  [[nodiscard]] Status begin(const PortableHeader& header);
  /// Chunks of level 0 by ascending x, then z, then y (asserted). Without voxels writes nothing.
  [[nodiscard]] Status add(ChunkCoord chunk, std::span<const Override> voxels);
  /// Call last, once.
  [[nodiscard]] Status end();

  [[nodiscard]] std::uint64_t chunks() const { return chunks_; }
  [[nodiscard]] std::uint64_t voxels() const { return voxels_; }

 private:
  [[nodiscard]] Status write_block();

  Sink sink_;
  store::Bytes block_;
  std::uint64_t link_ = 0;  // checksum of the previous block
  std::string last_;        // key of the previous chunk
  std::uint64_t chunks_ = 0;
  std::uint64_t voxels_ = 0;
  edits::StateHash hash_;
};

class PortableReader {
 public:
  /// Fills the buffer; returns less only at the end.
  using Source = std::function<tl::expected<std::size_t, std::string>(std::span<std::byte>)>;

  /// Reads the header. An error is one line: what is wrong, and the remedy.
  [[nodiscard]] static tl::expected<PortableReader, std::string> open(Source source);

  [[nodiscard]] const PortableHeader& header() const { return header_; }
  /// Returns nullopt at the end, once the whole file is verified.
  [[nodiscard]] tl::expected<std::optional<PortableChunk>, std::string> next();

 private:
  explicit PortableReader(Source source) : source_{std::move(source)} {}
  [[nodiscard]] tl::expected<void, std::string> read(std::span<std::byte> into);
  [[nodiscard]] tl::expected<void, std::string> read_block();
  [[nodiscard]] tl::expected<void, std::string> check_end();

  Source source_;
  PortableHeader header_;
  store::Bytes block_;
  std::size_t at_ = 0;  // position in block_
  std::uint64_t link_ = 0;
  std::string last_;
  bool ended_ = false;
  std::uint64_t chunks_ = 0;
  std::uint64_t voxels_ = 0;
  edits::StateHash hash_;
};

}  // namespace talus::server
