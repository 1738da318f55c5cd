// Keys of the edit store; FORMAT.md specifies every byte.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <talus/edits/editors.h>
#include <talus/voxel/coords.h>

namespace talus::store {

/// The first byte of a key.
enum class KeyKind : char { meta = 'm', editor = 'e', log = 'l', chunk = 'c', material = 'n', history = 'h' };

[[nodiscard]] std::string meta_key();
[[nodiscard]] std::string editor_key(edits::EditorId id);
/// Key of a batch's entries, by the position of the last.
[[nodiscard]] std::string log_key(std::uint64_t position);
[[nodiscard]] std::string chunk_key(ChunkKey chunk);
[[nodiscard]] std::string material_key(std::string_view name);
[[nodiscard]] std::string history_key(std::uint64_t first);

[[nodiscard]] std::optional<edits::EditorId> editor_of_key(std::string_view key);
[[nodiscard]] std::optional<std::uint64_t> position_of_key(std::string_view key);  // log and history keys
[[nodiscard]] std::optional<ChunkKey> chunk_of_key(std::string_view key);
[[nodiscard]] std::optional<std::string_view> material_of_key(std::string_view key);

}  // namespace talus::store
