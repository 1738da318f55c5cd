#include <talus/store/keys.h>

#include <array>

namespace talus::store {
namespace {

/// Big endian, so that keys sort by number.
void put_ordered(std::uint64_t value, int bytes, std::string& key) {
  std::array<char, 8> all;
  for (int i = 0; i < bytes; ++i)
    all[static_cast<std::size_t>(i)] = static_cast<char>(value >> (8 * (bytes - 1 - i)));
  key.append(all.data(), static_cast<std::size_t>(bytes));
}
std::uint64_t get_ordered(std::string_view bytes) {
  std::uint64_t value = 0;
  for (const char byte : bytes) value = (value << 8) | static_cast<unsigned char>(byte);
  return value;
}

std::string begin_key(KeyKind kind) {
  return std::string(1, static_cast<char>(kind));
}

bool is_key(std::string_view key, KeyKind kind, std::size_t bytes) {
  return key.size() == 1 + bytes && key.front() == static_cast<char>(kind);
}

/// Flips the sign bit, so that coordinates sort.
constexpr std::uint32_t kSign = 0x8000'0000;
std::uint32_t ordered(std::int32_t at) {
  return static_cast<std::uint32_t>(at) ^ kSign;
}
std::int32_t unordered(std::uint64_t value) {
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(value) ^ kSign);
}

}  // namespace

std::string meta_key() {
  return begin_key(KeyKind::meta);
}
std::string editor_key(edits::EditorId id) {
  std::string key = begin_key(KeyKind::editor);
  put_ordered(id.high, 8, key);
  put_ordered(id.low, 8, key);
  return key;
}
std::string log_key(std::uint64_t position) {
  std::string key = begin_key(KeyKind::log);
  put_ordered(position, 8, key);
  return key;
}
std::string chunk_key(ChunkKey chunk) {
  std::string key = begin_key(KeyKind::chunk);
  put_ordered(static_cast<std::uint64_t>(chunk.lod.value()), 1, key);
  for (const std::int32_t at : {chunk.coord.x, chunk.coord.z, chunk.coord.y})
    put_ordered(ordered(at), 4, key);
  return key;
}
std::string material_key(std::string_view name) {
  return begin_key(KeyKind::material) + std::string{name};
}
std::string history_key(std::uint64_t first) {
  std::string key = begin_key(KeyKind::history);
  put_ordered(first, 8, key);
  return key;
}

std::optional<edits::EditorId> editor_of_key(std::string_view key) {
  if (!is_key(key, KeyKind::editor, 16)) return std::nullopt;
  return edits::EditorId{.low = get_ordered(key.substr(9, 8)), .high = get_ordered(key.substr(1, 8))};
}
std::optional<std::uint64_t> position_of_key(std::string_view key) {
  if (!is_key(key, KeyKind::log, 8) && !is_key(key, KeyKind::history, 8)) return std::nullopt;
  return get_ordered(key.substr(1, 8));
}
std::optional<ChunkKey> chunk_of_key(std::string_view key) {
  if (!is_key(key, KeyKind::chunk, 13)) return std::nullopt;
  const auto lod = Lod::checked(static_cast<std::int64_t>(get_ordered(key.substr(1, 1))));
  if (!lod) return std::nullopt;
  const auto at = [&](std::size_t from) { return unordered(get_ordered(key.substr(from, 4))); };
  const auto chunk = checked_chunk(at(2), at(10), at(6), *lod);
  return chunk ? std::optional{*chunk} : std::nullopt;
}
std::optional<std::string_view> material_of_key(std::string_view key) {
  if (key.size() < 2 || key.front() != static_cast<char>(KeyKind::material)) return std::nullopt;
  return key.substr(1);
}

}  // namespace talus::store
