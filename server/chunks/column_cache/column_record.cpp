#include "chunks/column_cache/column_record.h"

#include <xxhash.h>

#include <limits>
#include <utility>

#include <talus/store/bytes.h>

namespace talus::server {
namespace {

constexpr std::size_t kSumBytes = 8;
constexpr std::uint64_t kUniform = 1;  // flag of an entry

std::uint64_t sum_of(ChunkKey column, std::span<const std::byte> body) {
  const std::string key = column_key(column);
  return XXH3_64bits_withSeed(body.data(), body.size(), XXH3_64bits(key.data(), key.size()));
}

/// Each bit of `value` followed by a zero.
constexpr std::uint64_t spread(std::uint32_t value) {
  std::uint64_t bits = value;
  bits = (bits | bits << 16) & 0x0000ffff0000ffffU;
  bits = (bits | bits << 8) & 0x00ff00ff00ff00ffU;
  bits = (bits | bits << 4) & 0x0f0f0f0f0f0f0f0fU;
  bits = (bits | bits << 2) & 0x3333333333333333U;
  return (bits | bits << 1) & 0x5555555555555555U;
}

constexpr std::uint32_t from_lowest(std::int32_t value) {
  return static_cast<std::uint32_t>(value) ^ 0x80000000U;
}

}  // namespace

std::string column_key(ChunkKey column) {
  std::string key{"c"};
  key.push_back(static_cast<char>(column.lod.value()));
  const std::uint64_t place = spread(from_lowest(column.coord.x)) | spread(from_lowest(column.coord.z)) << 1;
  for (int shift = 56; shift >= 0; shift -= 8) key.push_back(static_cast<char>(place >> shift));
  return key;
}

void encode(ChunkKey column, const ColumnRecord& record, std::vector<std::byte>& out) {
  out.clear();
  store::ByteWriter writer{out};
  writer.fixed32(static_cast<std::uint32_t>(record.rows.first));
  writer.varint(static_cast<std::uint64_t>(std::int64_t{record.rows.last} - record.rows.first + 1));
  writer.varint(to_integer(record.rows.below));
  writer.varint(record.chunks.size());
  for (const auto& [y, chunk] : record.chunks) {
    writer.varint(static_cast<std::uint64_t>(std::int64_t{y} - record.rows.first));
    writer.varint(chunk->uniform() ? kUniform : 0);
    writer.fixed64(chunk->hash().low);
    writer.fixed64(chunk->hash().high);
    writer.counted(chunk->payload());
  }
  writer.fixed64(sum_of(column, out));
}

std::optional<ColumnRecord> decode_column(ChunkKey column, std::span<const std::byte> value) {
  if (value.size() < kSumBytes) return std::nullopt;
  const auto body = value.first(value.size() - kSumBytes);
  if (store::ByteReader{value.last(kSumBytes)}.fixed64() != sum_of(column, body)) return std::nullopt;
  store::ByteReader reader{body};
  ColumnRecord record;
  record.rows.first = static_cast<std::int32_t>(reader.fixed32());
  const std::uint64_t rows = reader.varint(std::numeric_limits<std::uint32_t>::max());
  const std::int64_t last = record.rows.first + static_cast<std::int64_t>(rows) - 1;
  if (last > std::numeric_limits<std::int32_t>::max()) return std::nullopt;
  record.rows.last = static_cast<std::int32_t>(last);
  record.rows.below = MaterialId{static_cast<std::uint16_t>(reader.varint(UINT16_MAX))};
  const std::size_t count = reader.count();
  if (count > rows) return std::nullopt;
  std::int64_t before = std::int64_t{record.rows.first} - 1;
  for (std::size_t i = 0; i < count && reader.ok(); ++i) {
    const std::int64_t y = record.rows.first + static_cast<std::int64_t>(reader.varint(rows));
    const std::uint64_t flags = reader.varint(kUniform);
    ContentHash hash;
    hash.low = reader.fixed64();
    hash.high = reader.fixed64();
    const auto payload = reader.counted();
    if (!reader.ok() || payload.empty() || y <= before || y > last) return std::nullopt;
    before = y;
    record.chunks.push_back(
        {static_cast<std::int32_t>(y),
         std::make_shared<const EncodedChunk>(hash, payload, kBaseRevision, (flags & kUniform) != 0)});
  }
  if (!reader.ended()) return std::nullopt;
  return record;
}

}  // namespace talus::server
