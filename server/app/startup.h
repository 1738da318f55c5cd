// Steps between the command line and the first client.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include <talus/store/data_directory.h>
#include <talus/voxel/content_hash.h>

#include "config/command_line.h"
#include "net/tls_context.h"
#include "runtime/privileges/account.h"

namespace talus::server {

/// The user that the configuration names; none where it names none.
[[nodiscard]] tl::expected<std::optional<Account>, std::string> configured_account(const Config& config);

/// Gives up what root may do, and opens the data directory as the user that is left; none where the
/// configuration has none. Before the first thread.
[[nodiscard]] tl::expected<std::optional<store::DataDirectory>, std::string> drop_privileges_and_open_data(
    const Config& config, const std::optional<Account>& account, ContentHash fingerprint);

/// Lines for the log: what an operator should know of how the server was started.
[[nodiscard]] std::vector<std::string> startup_warnings(const Command& command,
                                                        const std::vector<std::string>& of_keys,
                                                        const std::optional<TlsIdentity>& tls);

}  // namespace talus::server
