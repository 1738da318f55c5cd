// The process's privileges, and dropping them. Call these functions before the first thread starts.
#pragma once

#include <string>

#include <tl/expected.hpp>

#include "runtime/privileges/account.h"

namespace talus::server {

[[nodiscard]] bool runs_as_root();

/// Sets no_new_privs: no program that this process runs gets more privileges than it has. An error is one
/// line.
[[nodiscard]] tl::expected<void, std::string> set_no_new_privs();

/// Switches from root to this user for good: groups, group, user and capabilities; then checks that there is
/// no way back, and hides the memory. Does nothing where the process already runs as this user. An error is
/// one line; the process must end then, because it may have switched in part.
[[nodiscard]] tl::expected<void, std::string> switch_user(const Account& account);

/// No core dump, and no debugger or /proc access by the same user, until the user changes: the memory holds
/// keys. An error is one line.
[[nodiscard]] tl::expected<void, std::string> hide_memory();

}  // namespace talus::server
