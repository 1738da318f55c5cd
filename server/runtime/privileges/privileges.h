// Querying and dropping the process's privileges. Call these functions before the first thread starts.
#pragma once

#include <string>

#include <tl/expected.hpp>

#include "runtime/privileges/account.h"

namespace talus::server {

[[nodiscard]] bool runs_as_root();

/// Sets no_new_privs: programs run by this process cannot gain privileges. An error is one line.
[[nodiscard]] tl::expected<void, std::string> set_no_new_privs();

/// Switches from root to this user permanently: groups, group, user and capabilities; then verifies that root
/// cannot be regained, and hides the memory. Does nothing if the process already runs as this user. An error
/// is one line; then the process must end, because it may have switched in part.
[[nodiscard]] tl::expected<void, std::string> switch_user(const Account& account);

/// Disables core dumps, and debugger and /proc access by the same user, until the user changes: the memory
/// holds keys. An error is one line.
[[nodiscard]] tl::expected<void, std::string> hide_memory();

}  // namespace talus::server
