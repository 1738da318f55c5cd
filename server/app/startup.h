// Steps between the command line and the first client.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include <talus/store/data_directory.h>
#include <talus/terrain/world.h>
#include <talus/voxel/content_hash.h>

#include "app/world_file.h"
#include "config/command_line.h"
#include "net/tls_context.h"
#include "runtime/log/logger.h"
#include "runtime/privileges/account.h"

namespace talus::server {

/// Returns the user named by the configuration; nullopt if it names none.
[[nodiscard]] tl::expected<std::optional<Account>, std::string> configured_account(const Config& config);

/// Drops root privileges, then opens the data directory as the remaining user; nullopt if it is not
/// configured. Call before the first thread starts.
[[nodiscard]] tl::expected<std::optional<store::DataDirectory>, std::string> drop_privileges_and_open_data(
    const Config& config, const std::optional<Account>& account, ContentHash fingerprint);

/// Writes the world's file and seed into world.txt of the data directory, for people: store.toml has the
/// fingerprint alone. Logs a failure.
void note_world(const Config& config, const terrain::World& world, LogWriter& log);

/// Returns warnings for the log about how the server was started.
[[nodiscard]] std::vector<std::string> startup_warnings(const Command& command,
                                                        const std::vector<std::string>& of_keys,
                                                        const std::optional<TlsIdentity>& tls,
                                                        const ServedWorld& world);

}  // namespace talus::server
