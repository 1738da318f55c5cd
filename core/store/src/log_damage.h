// Finds damage in RocksDB's log and manifest, and tells a torn end from damage in the middle.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace rocksdb {
class Env;
}

namespace talus::store {

struct LogDamage {
  std::string file;          // its name in the database's directory
  std::uint64_t offset = 0;  // end of the last whole record
  /// True if a power cut can have caused the damage: no sync had ended since the damaged record was written.
  /// False proves that a synced record is damaged.
  bool is_torn = false;
  /// First entry of a whole batch behind the damage. If it does not follow the last entry before the damage,
  /// a synced batch is damaged.
  std::optional<std::uint64_t> entry_behind;
};

/// Returns the numbers of the log files in `directory`, rising.
[[nodiscard]] std::vector<std::uint64_t> log_numbers(rocksdb::Env& env, const std::string& directory);

/// Reads the logs in `directory` from number `first_log` on. Returns the first damage; nullopt if each record
/// is whole and follows the one before.
[[nodiscard]] std::optional<LogDamage> find_log_damage(rocksdb::Env& env, const std::string& directory,
                                                       std::uint64_t first_log);

/// Like find_log_damage(), for the manifest that CURRENT names. RocksDB writes a group of records there
/// before each sync.
[[nodiscard]] std::optional<LogDamage> find_manifest_damage(rocksdb::Env& env, const std::string& directory);

}  // namespace talus::store
