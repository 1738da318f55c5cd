#include <talus/store/id_check.h>

#include <system_error>

#include <fmt/format.h>

#include <talus/edits/levels.h>
#include <talus/store/acknowledged_file.h>
#include <talus/store/store_identity.h>

namespace talus::store {

tl::expected<void, std::string> check_store_id(const std::filesystem::path& directory,
                                               const StoreMeta& meta) {
  std::error_code code;
  if (!std::filesystem::exists(directory / "acknowledged", code)) return {};
  const auto identity = read_store_identity(directory / "store.toml");
  if (!identity) return tl::unexpected{identity.error()};
  if (identity->store_id == meta.store_id) return {};
  return tl::unexpected{
      fmt::format("edits {}: {}", directory.string(), ids_differ(meta.store_id, identity->store_id))};
}

tl::expected<void, std::string> check_whole_store(const std::filesystem::path& directory,
                                                  const StoreMeta& meta) {
  auto one = check_store_id(directory, meta);
  return one ? check_acknowledged(directory, meta) : one;
}

tl::expected<void, std::string> check_opens(const std::filesystem::path& directory, const StoreMeta& meta) {
  const auto identity = read_store_identity(directory / "store.toml");
  if (!identity) return tl::unexpected{identity.error()};
  if (identity->fingerprint != meta.fingerprint) {
    return tl::unexpected{fmt::format(
        "edits {}: they belong to the world with fingerprint {}; store.toml has {}; put back the directory's "
        "own store.toml",
        directory.string(), to_string(meta.fingerprint), to_string(identity->fingerprint))};
  }
  if (const auto other = level_rule_differs(meta)) {
    return tl::unexpected{fmt::format("edits {}: {}", directory.string(), *other)};
  }
  return {};
}

std::optional<std::string> level_rule_differs(const StoreMeta& meta) {
  if (meta.level_rule == edits::kLevelRule) return std::nullopt;
  return fmt::format(
      "its coarse levels were made by rule {}; this talusd has rule {}; run a talusd with that rule, or give "
      "--data another directory",
      meta.level_rule, edits::kLevelRule);
}

std::string ids_differ(ContentHash of_database, ContentHash of_store_toml) {
  return fmt::format(
      "the edits belong to store {0}; this directory's store.toml has {1}; if \"talusd store leave-cluster\" "
      "or \"fork\" of an older talusd was interrupted here, write store_id = \"{0}\" into store.toml; else "
      "put back the directory's own edits, or give --data another directory",
      to_string(of_database), to_string(of_store_toml));
}

}  // namespace talus::store
