// The file store.toml of a data directory: which store it is, and of which world.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include <talus/voxel/content_hash.h>

namespace talus::store {

struct StoreIdentity {
  ContentHash store_id;
  ContentHash fingerprint;  // of the world
  bool operator==(const StoreIdentity&) const = default;
};

[[nodiscard]] ContentHash random_store_id();

/// 32 hexadecimal digits, as to_string(ContentHash) prints them.
[[nodiscard]] std::optional<ContentHash> parse_hash(std::string_view text);

/// What the file holds.
[[nodiscard]] std::string store_text(const StoreIdentity& identity);

/// An error is one line: it cannot be read, or talusd did not write it.
[[nodiscard]] tl::expected<StoreIdentity, std::string> read_store_identity(const std::filesystem::path& file);

}  // namespace talus::store
