// The file store.toml of a data directory: the id of its store and the fingerprint of its world.
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
  ContentHash fingerprint;  // the world's
  bool operator==(const StoreIdentity&) const = default;
};

[[nodiscard]] ContentHash random_store_id();

/// 32 hexadecimal digits, as to_string(ContentHash) prints them.
[[nodiscard]] std::optional<ContentHash> parse_hash(std::string_view text);

/// Text of the file.
[[nodiscard]] std::string store_text(const StoreIdentity& identity);

/// An error is one line: unreadable, or not written by talusd.
[[nodiscard]] tl::expected<StoreIdentity, std::string> read_store_identity(const std::filesystem::path& file);

}  // namespace talus::store
