#include "commands/store/portable_file.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <xxhash.h>

#include <talus/edits/runs.h>
#include <talus/store/bytes.h>
#include <talus/store/keys.h>

namespace talus::server {
namespace {

using Status = tl::expected<void, std::string>;

constexpr std::string_view kMagic = "talusedt";
/// Size at which a block is written; even with the largest chunk it stays far below kMaxPortableBlock.
constexpr std::size_t kBlockBytes = std::size_t{64} << 10U;

enum class Block : std::uint8_t { header = 1, chunks = 2, end = 3 };

tl::unexpected<std::string> damaged(std::string_view what) {
  return tl::unexpected{fmt::format("{}; the file is damaged: export it again", what)};
}

std::uint64_t zigzag_of(std::int32_t value) {
  return static_cast<std::uint32_t>((static_cast<std::uint32_t>(value) << 1U) ^
                                    static_cast<std::uint32_t>(value >> 31));
}
std::int32_t of_zigzag(std::uint64_t value) {
  const auto bits = static_cast<std::uint32_t>(value);
  return static_cast<std::int32_t>((bits >> 1U) ^ (~(bits & 1U) + 1U));
}

void put_128(std::uint64_t low, std::uint64_t high, store::ByteWriter& out) {
  out.fixed64(low);
  out.fixed64(high);
}

}  // namespace

Status PortableWriter::write_block() {
  store::Bytes framed;
  store::ByteWriter writer{framed};
  writer.fixed32(static_cast<std::uint32_t>(block_.size()));
  writer.bytes(block_);
  link_ = XXH3_64bits_withSeed(block_.data(), block_.size(), link_);
  writer.fixed64(link_);
  block_.clear();
  return sink_(framed);
}

Status PortableWriter::begin(const PortableHeader& header) {
  store::Bytes first;
  store::ByteWriter before{first};
  before.bytes(std::as_bytes(std::span{kMagic}));
  before.fixed32(kPortableVersion);
  if (auto done = sink_(first); !done) return done;
  store::ByteWriter writer{block_};
  writer.byte(static_cast<std::uint8_t>(Block::header));
  put_128(header.fingerprint.low, header.fingerprint.high, writer);
  put_128(header.store_id.low, header.store_id.high, writer);
  writer.varint(header.head.position);
  writer.varint(header.head.revision);
  writer.varint(static_cast<std::uint64_t>(header.head.time_ms));
  put_128(header.head.hash.low, header.head.hash.high, writer);
  writer.varint(header.materials.size());
  for (const auto& [name, id] : header.materials) {
    if (name.empty() || name.size() > kMaxMaterialName) {
      return tl::unexpected{fmt::format("material {} has a name of {} bytes; a file of edits takes 1 to {}",
                                        to_integer(id), name.size(), kMaxMaterialName)};
    }
    writer.counted(name);
    writer.varint(to_integer(id));
  }
  if (block_.size() > kMaxPortableBlock) {
    return tl::unexpected{fmt::format("the names of its {} materials take {} bytes; a file of edits takes {}",
                                      header.materials.size(), block_.size(), kMaxPortableBlock)};
  }
  return write_block();
}

Status PortableWriter::add(ChunkCoord chunk, std::span<const Override> voxels) {
  if (voxels.empty()) return {};
  std::string key = store::chunk_key({chunk, Lod{}});
  assert(last_ < key);
  last_ = std::move(key);
  ++chunks_;
  voxels_ += voxels.size();
  hash_.add(chunk, voxels);
  store::ByteWriter writer{block_};
  if (block_.empty()) writer.byte(static_cast<std::uint8_t>(Block::chunks));
  for (const std::int32_t at : {chunk.x, chunk.z, chunk.y}) writer.varint(zigzag_of(at));
  store::Bytes runs;
  edits::encode_runs(voxels, runs);
  writer.counted(runs);
  return block_.size() < kBlockBytes ? Status{} : write_block();
}

Status PortableWriter::end() {
  if (!block_.empty()) {
    if (auto done = write_block(); !done) return done;
  }
  store::ByteWriter writer{block_};
  writer.byte(static_cast<std::uint8_t>(Block::end));
  writer.varint(chunks_);
  writer.varint(voxels_);
  put_128(hash_.low, hash_.high, writer);
  return write_block();
}

Status PortableReader::read(std::span<std::byte> into) {
  const auto got = source_(into);
  if (!got) return tl::unexpected{got.error()};
  if (*got < into.size()) return damaged("it ends early");
  return {};
}

Status PortableReader::read_block() {
  std::array<std::byte, 4> length{};
  if (auto done = read(length); !done) return done;
  const std::uint32_t bytes = store::ByteReader{length}.fixed32();
  if (bytes == 0 || bytes > kMaxPortableBlock) {
    return damaged(fmt::format("a block of {} bytes; it must have 1 to {}", bytes, kMaxPortableBlock));
  }
  block_.resize(bytes);
  at_ = 0;
  if (auto done = read(block_); !done) return done;
  std::array<std::byte, 8> checksum{};
  if (auto done = read(checksum); !done) return done;
  link_ = XXH3_64bits_withSeed(block_.data(), block_.size(), link_);
  if (store::ByteReader{checksum}.fixed64() != link_) return damaged("a block's checksum is wrong");
  return {};
}

tl::expected<PortableReader, std::string> PortableReader::open(Source source) {
  PortableReader reader{std::move(source)};
  std::array<std::byte, kMagic.size() + 4> first{};
  const auto got = reader.source_(first);
  if (!got) return tl::unexpected{got.error()};
  const auto magic = std::as_bytes(std::span{kMagic});
  if (*got < first.size() || !std::ranges::equal(std::span{first}.first(magic.size()), magic)) {
    return tl::unexpected{std::string{
        "it is not a file of edits; give one that talusd store export wrote, or a player's save"}};
  }
  const std::uint32_t version = store::ByteReader{std::span{first}.subspan(magic.size())}.fixed32();
  if (version != kPortableVersion) {
    return tl::unexpected{
        fmt::format("it has version {}; this talusd reads version {}; use the talusd that wrote it", version,
                    kPortableVersion)};
  }
  if (auto done = reader.read_block(); !done) return tl::unexpected{done.error()};
  store::ByteReader in{reader.block_};
  if (in.byte() != static_cast<std::uint8_t>(Block::header)) in.fail();
  PortableHeader& header = reader.header_;
  header.fingerprint.low = in.fixed64();
  header.fingerprint.high = in.fixed64();
  header.store_id.low = in.fixed64();
  header.store_id.high = in.fixed64();
  header.head.position = in.varint();
  header.head.revision = in.varint();
  header.head.time_ms = static_cast<std::int64_t>(in.varint(INT64_MAX));
  header.head.hash.low = in.fixed64();
  header.head.hash.high = in.fixed64();
  const std::uint64_t materials = in.varint(UINT16_MAX + std::uint64_t{1});
  std::string before;
  for (std::uint64_t i = 0; i < materials && in.ok(); ++i) {
    std::string name = in.text(kMaxMaterialName);
    const auto id = static_cast<std::uint16_t>(in.varint(UINT16_MAX));
    if (name.empty() || name <= before) in.fail();
    before = name;
    header.materials.emplace(std::move(name), MaterialId{id});
  }
  if (!in.ended()) return damaged("its header is invalid");
  std::vector<MaterialId> ids;
  for (const auto& [name, id] : header.materials) ids.push_back(id);
  std::ranges::sort(ids);
  if (std::ranges::adjacent_find(ids) != ids.end()) return damaged("two of its materials have one id");
  reader.block_.clear();
  return reader;
}

tl::expected<std::optional<PortableChunk>, std::string> PortableReader::next() {
  if (ended_) return std::nullopt;
  if (at_ == block_.size()) {
    if (auto done = read_block(); !done) return tl::unexpected{done.error()};
    at_ = 1;
    if (block_.front() == static_cast<std::byte>(Block::end)) {
      if (auto done = check_end(); !done) return tl::unexpected{done.error()};
      ended_ = true;
      return std::nullopt;
    }
    if (block_.front() != static_cast<std::byte>(Block::chunks) || block_.size() == 1) {
      return damaged("a block is of no known kind");
    }
  }
  store::ByteReader in{std::span{std::as_const(block_)}.subspan(at_)};
  PortableChunk next;
  for (std::int32_t* const at : {&next.chunk.x, &next.chunk.z, &next.chunk.y})
    *at = of_zigzag(in.varint(UINT32_MAX));
  const auto runs = in.counted();
  auto voxels = edits::decode_runs(runs);
  if (!in.ok() || !voxels || voxels->empty()) return damaged("a chunk is invalid");
  std::string key = store::chunk_key({next.chunk, Lod{}});
  if (!store::chunk_of_key(key) || key <= last_) return damaged("its chunks are not in order");
  last_ = std::move(key);
  at_ = static_cast<std::size_t>(runs.data() + runs.size() - block_.data());
  next.voxels = *std::move(voxels);
  ++chunks_;
  voxels_ += next.voxels.size();
  hash_.add(next.chunk, next.voxels);
  return next;
}

Status PortableReader::check_end() {
  store::ByteReader in{std::span{std::as_const(block_)}.subspan(1)};
  const bool same = in.varint() == chunks_ && in.varint() == voxels_ && in.fixed64() == hash_.low &&
                    in.fixed64() == hash_.high && in.ended();
  if (!same || hash_ != header_.head.hash) return damaged("its edits do not match the figures at its end");
  std::array<std::byte, 1> more{};
  const auto got = source_(more);
  if (!got) return tl::unexpected{got.error()};
  if (*got > 0) return damaged("bytes follow its end");
  return {};
}

}  // namespace talus::server
