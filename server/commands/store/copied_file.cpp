#include "commands/store/copied_file.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include <talus/files/atomic_file.h>
#include <talus/store/regular_files.h>
#include <xxhash.h>

namespace talus::server {
namespace {

constexpr std::size_t kPieceBytes = std::size_t{1} << 20U;

/// Calls `piece` with each piece and its offset.
template <typename Piece>
tl::expected<CopiedFile, std::string> read_pieces(const std::filesystem::path& path, std::uint64_t max_bytes,
                                                  ProgressBar& progress, const Piece& piece) {
  const auto file = store::RegularFile::open(path);
  if (!file) return tl::unexpected{file.error()};
  const std::unique_ptr<XXH3_state_t, XXH_errorcode (*)(XXH3_state_t*)> state{XXH3_createState(),
                                                                              XXH3_freeState};
  XXH3_128bits_reset(state.get());
  std::vector<std::byte> bytes(kPieceBytes);
  CopiedFile copied;
  // Ignores bytes appended meanwhile.
  const std::uint64_t wanted = std::min(max_bytes, file->bytes());
  copied.all = wanted == file->bytes();
  while (copied.bytes < wanted) {
    const std::size_t next = std::min<std::uint64_t>(bytes.size(), wanted - copied.bytes);
    const auto got = file->read(std::span{bytes}.first(next));
    if (!got) return tl::unexpected{got.error()};
    if (*got == 0) break;
    const auto all = std::span{std::as_const(bytes)}.first(*got);
    XXH3_128bits_update(state.get(), all.data(), all.size());
    if (auto done = piece(copied.bytes, all); !done) return tl::unexpected{done.error()};
    copied.bytes += *got;
    progress.advance(*got);
  }
  const XXH128_hash_t hash = XXH3_128bits_digest(state.get());
  copied.hash = {hash.low64, hash.high64};
  return copied;
}

}  // namespace

tl::expected<CopiedFile, std::string> copy_file(const std::filesystem::path& from,
                                                const std::filesystem::path& to, std::uint64_t max_bytes,
                                                ProgressBar& progress) {
  auto target = files::AtomicFile::create(to);
  if (!target) return tl::unexpected{target.error().message()};
  auto copied =
      read_pieces(from, max_bytes, progress, [&](std::uint64_t offset, std::span<const std::byte> bytes) {
        return target->write_at(offset, bytes).map_error([](const auto& error) { return error.message(); });
      });
  if (!copied) return copied;
  if (auto committed = target->commit(); !committed) return tl::unexpected{committed.error().message()};
  return copied;
}

tl::expected<CopiedFile, std::string> hash_file(const std::filesystem::path& file, ProgressBar& progress) {
  return read_pieces(file, UINT64_MAX, progress, [](std::uint64_t, std::span<const std::byte>) {
    return tl::expected<void, std::string>{};
  });
}

}  // namespace talus::server
