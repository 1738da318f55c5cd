// Text manifest of a store's backup: its files with their checksums. server/commands/store/FORMAT.md
// specifies every byte. Pure.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include <talus/edits/batch.h>
#include <talus/store/store_identity.h>

namespace talus::store {

inline constexpr std::string_view kManifestName = "manifest";
inline constexpr std::size_t kMaxManifestBytes = std::size_t{16} << 20U;

struct BackupManifest {
  struct File {
    std::string name;  // "db/000012.sst"
    std::uint64_t bytes = 0;
    ContentHash hash;  // XXH3-128 of the file's bytes
    bool operator==(const File&) const = default;
  };
  StoreIdentity identity;
  edits::Head head;
  std::vector<File> files;

  /// Total size of the files. Saturates at the type's maximum.
  [[nodiscard]] std::uint64_t bytes() const;
  bool operator==(const BackupManifest&) const = default;
};

[[nodiscard]] std::string encode(const BackupManifest& manifest);
/// Accepts any text. A name that leads out of the backup is an error. An error is one line.
[[nodiscard]] tl::expected<BackupManifest, std::string> decode_manifest(std::string_view text);

/// True for "acknowledged", "store.toml" and files of the database. Rejects names that lead out of the store.
[[nodiscard]] bool is_store_file(std::string_view name);

}  // namespace talus::store
