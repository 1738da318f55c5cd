// Any bytes given as a file of edits: refused, or read as what writes back as the same edits. Once as they
// are, and once as the contents of blocks whose checksums are right, as no mutation would find them.
#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <optional>
#include <string_view>
#include <vector>

#include <xxhash.h>

#include <talus/store/bytes.h>

#include "commands/store/portable_file.h"

namespace {

using namespace talus;
using namespace talus::server;

void require(bool holds, std::string_view what) {
  if (holds) return;
  std::cerr << "read_portable: " << what << '\n';
  std::abort();
}

struct PortableContents {
  PortableHeader header;
  std::vector<PortableChunk> chunks;
};

std::optional<PortableContents> read(const store::Bytes& bytes) {
  std::size_t at = 0;
  auto reader = PortableReader::open([&](std::span<std::byte> into) {
    require(into.size() <= kMaxPortableBlock, "no more than a block is asked for");
    const std::size_t count = std::min(into.size(), bytes.size() - at);
    std::copy_n(bytes.begin() + static_cast<std::ptrdiff_t>(at), count, into.begin());
    at += count;
    return tl::expected<std::size_t, std::string>{count};
  });
  if (!reader) return std::nullopt;
  PortableContents all{reader->header(), {}};
  for (;;) {
    auto chunk = reader->next();
    if (!chunk) return std::nullopt;
    if (!*chunk) return all;
    require(!(*chunk)->voxels.empty(), "no chunk is empty");
    all.chunks.push_back(**std::move(chunk));
  }
}

store::Bytes written(const PortableContents& all) {
  store::Bytes bytes;
  PortableWriter writer{[&](std::span<const std::byte> piece) -> PortableWriter::Status {
    bytes.insert(bytes.end(), piece.begin(), piece.end());
    return {};
  }};
  (void)writer.begin(all.header);
  for (const PortableChunk& chunk : all.chunks) (void)writer.add(chunk.chunk, chunk.voxels);
  (void)writer.end();
  return bytes;
}

void check(const store::Bytes& bytes) {
  const auto all = read(bytes);
  if (!all) return;
  const auto again = read(written(*all));
  require(again && again->header == all->header && again->chunks == all->chunks, "what is read is written");
}

/// Blocks of the pieces, each as long as its first byte says, with right checksums.
store::Bytes in_blocks(const store::Bytes& pieces) {
  store::Bytes file;
  store::ByteWriter writer{file};
  writer.bytes(std::as_bytes(std::span{std::string_view{"talusedt"}}));
  writer.fixed32(kPortableVersion);
  std::uint64_t link = 0;
  for (std::size_t at = 0; at < pieces.size();) {
    const std::size_t wanted = std::to_integer<std::size_t>(pieces[at++]);
    const auto block = std::span{pieces}.subspan(at, std::min(wanted, pieces.size() - at));
    at += block.size();
    writer.fixed32(static_cast<std::uint32_t>(block.size()));
    writer.bytes(block);
    link = XXH3_64bits_withSeed(block.data(), block.size(), link);
    writer.fixed64(link);
  }
  return file;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto* const first = reinterpret_cast<const std::byte*>(data);
  const store::Bytes raw(first, first + size);
  check(raw);
  check(in_blocks(raw));
  return 0;
}
