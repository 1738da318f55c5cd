#include "web/columns_body.h"

#include <algorithm>
#include <span>
#include <utility>

namespace talus::server::web {
namespace {

constexpr std::uint8_t kVersion = 1;

template <typename Integer>
void append_little(std::string& body, Integer number) {
  const auto bits = static_cast<std::make_unsigned_t<Integer>>(number);
  for (std::size_t i = 0; i < sizeof(Integer); ++i) body.push_back(static_cast<char>(bits >> (8 * i)));
}

}  // namespace

void add_chunk(std::vector<ChunkRun>& runs, std::int32_t y, EncodedChunkPtr chunk) {
  const auto same = [](const EncodedChunk& a, const EncodedChunk& b) {
    return a.hash() == b.hash() && std::ranges::equal(a.payload(), b.payload());
  };
  if (!runs.empty() && same(*runs.back().chunk, *chunk)) {
    ++runs.back().count;
  } else {
    runs.push_back({y, 1, std::move(chunk)});
  }
}

void append_column(std::string& body, const std::vector<ChunkRun>& runs) {
  append_little(body, kVersion);
  append_little(body, std::uint8_t{0});
  append_little(body, static_cast<std::uint16_t>(runs.size()));
  for (const ChunkRun& run : runs) {
    const std::span<const std::byte> payload = run.chunk->payload();
    append_little(body, run.first_y);
    append_little(body, run.count);
    append_little(body, static_cast<std::uint32_t>(payload.size()));
    body.append(reinterpret_cast<const char*>(payload.data()), payload.size());
  }
}

void append_square_head(std::string& body, std::int32_t edge) {
  append_little(body, kVersion);
  append_little(body, static_cast<std::uint8_t>(edge));
  append_little(body, std::uint16_t{0});
}

void append_edited_columns(std::string& body, const std::vector<EditedColumn>& columns) {
  append_little(body, kVersion);
  append_little(body, std::uint8_t{0});
  append_little(body, static_cast<std::uint16_t>(columns.size()));
  for (const EditedColumn& column : columns) {
    append_little(body, column.place);
    append_little(body, column.revision);
  }
}

void append_length(std::string& body, std::uint32_t bytes) {
  append_little(body, bytes);
}

}  // namespace talus::server::web
