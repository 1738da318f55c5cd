// Any bytes given as values of the store of edits: refused, or what would be written as these very bytes. The
// checksum is made right first, as no mutation would find it.
#include <cstdlib>
#include <iostream>
#include <string_view>
#include <vector>

#include <xxhash.h>

#include <talus/store/keys.h>
#include <talus/store/log_records.h>
#include <talus/store/records.h>

namespace {

using namespace talus;
using namespace talus::store;

void require(bool holds, std::string_view what) {
  if (holds) return;
  std::cerr << "decode_store: " << what << '\n';
  std::abort();
}

Bytes sealed(Bytes value, std::uint64_t seed) {
  const std::uint64_t hash = XXH3_64bits_withSeed(value.data(), value.size(), seed);
  for (int i = 0; i < 8; ++i) value.push_back(static_cast<std::byte>(hash >> (8 * i)));
  return value;
}
Bytes sealed(const Bytes& value, const std::string& key) {
  return sealed(value, XXH3_64bits(key.data(), key.size()));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto* const first = reinterpret_cast<const std::byte*>(data);
  const Bytes raw(first, first + size);
  Bytes again;

  const Bytes batch = sealed(raw, 42);
  std::uint64_t link = 42;
  if (const auto read = decode_records(batch, link)) {
    encode(*read, 42, again);
    require(again == batch, "a batch of the log has one encoding");
    std::uint64_t alone = 0;
    require(decode_records_alone(batch, alone) == read && alone == link, "a batch alone is the same");
  }
  const std::string chunk = chunk_key({{1, -2, 3}, Lod::of(1)});
  const Bytes chunk_value = sealed(raw, chunk);
  if (const auto read = decode_chunk_value(chunk, chunk_value)) {
    encode(chunk, read->revision, read->voxels, again);
    require(again == chunk_value, "a chunk has one encoding");
    require(decode_chunk_revision(chunk, chunk_value) == read->revision, "a chunk has one revision");
  }
  const std::string editor = editor_key({1, 2});
  const Bytes editor_value = sealed(raw, editor);
  if (const auto read = decode_editor(editor, editor_value)) {
    encode(editor, read->position, read->editor, again);
    require(again == editor_value, "an editor has one encoding");
  }
  if (const auto changes = decode_changes(raw)) {
    encode(*changes, again);
    require(again == raw, "changes have one encoding");
  }
  (void)decode_meta(sealed(raw, meta_key()));
  (void)decode_history(history_key(1), sealed(raw, history_key(1)));
  const std::string_view text{reinterpret_cast<const char*>(data), size};
  if (const auto key = chunk_of_key(text)) require(chunk_key(*key) == text, "a key has one encoding");
  return 0;
}
