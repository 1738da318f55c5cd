// All edits of a store in one file that any talusd reads, whatever its database: FORMAT.md of this folder has
// every byte. Written and read as a stream, in memory that no number of chunks makes larger. Pure; any bytes
// are safe to read.
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
/// A block has at most so many bytes.
inline constexpr std::size_t kMaxPortableBlock = std::size_t{1} << 20U;
inline constexpr std::size_t kMaxMaterialName = 256;

struct PortableHeader {
  ContentHash fingerprint;  // of the world
  ContentHash store_id;     // that it came from
  edits::Head head;         // of that store; its hash is that of all overrides of the file
  std::map<std::string, MaterialId> materials;
  bool operator==(const PortableHeader&) const = default;
};

struct PortableChunk {
  ChunkCoord chunk;
  std::vector<Override> voxels;  // by rising index, not empty
  bool operator==(const PortableChunk&) const = default;
};

class PortableWriter {
 public:
  using Done = tl::expected<void, std::string>;
  using Sink = std::function<Done(std::span<const std::byte>)>;

  explicit PortableWriter(Sink sink) : sink_{std::move(sink)} {}
  /// First, once. Refuses names that are more or longer than a reader takes.
  [[nodiscard]] Done begin(const PortableHeader& header);
  /// Of level 0, by rising x, then z, then y (asserted); without voxels nothing is written.
  [[nodiscard]] Done add(ChunkCoord chunk, std::span<const Override> voxels);
  /// Last, once.
  [[nodiscard]] Done end();

  [[nodiscard]] std::uint64_t chunks() const { return chunks_; }
  [[nodiscard]] std::uint64_t voxels() const { return voxels_; }

 private:
  [[nodiscard]] Done write_block();

  Sink sink_;
  store::Bytes block_;
  std::uint64_t link_ = 0;  // the checksum of the block before
  std::string last_;        // key of the chunk before
  std::uint64_t chunks_ = 0;
  std::uint64_t voxels_ = 0;
  edits::StateHash hash_;
};

class PortableReader {
 public:
  /// Fills as much as it can; less only at the end.
  using Source = std::function<tl::expected<std::size_t, std::string>(std::span<std::byte>)>;

  /// Reads the header. An error is one line: what is wrong, and what would be right.
  [[nodiscard]] static tl::expected<PortableReader, std::string> open(Source source);

  [[nodiscard]] const PortableHeader& header() const { return header_; }
  /// Nothing at the end, when all of the file was sound.
  [[nodiscard]] tl::expected<std::optional<PortableChunk>, std::string> next();

 private:
  explicit PortableReader(Source source) : source_{std::move(source)} {}
  [[nodiscard]] tl::expected<void, std::string> read(std::span<std::byte> into);
  [[nodiscard]] tl::expected<void, std::string> read_block();
  [[nodiscard]] tl::expected<void, std::string> check_end();

  Source source_;
  PortableHeader header_;
  store::Bytes block_;
  std::size_t at_ = 0;  // in block_
  std::uint64_t link_ = 0;
  std::string last_;
  bool ended_ = false;
  std::uint64_t chunks_ = 0;
  std::uint64_t voxels_ = 0;
  edits::StateHash hash_;
};

}  // namespace talus::server
