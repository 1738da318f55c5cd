// What the process may do to the system, and giving it up. Call all of it before the first thread starts.
#pragma once

#include <string>

#include <tl/expected.hpp>

#include "privileges/account.h"

namespace talus::server {

[[nodiscard]] bool runs_as_root();

/// From here on no program that this process runs has more rights than it. An error is one line.
[[nodiscard]] tl::expected<void, std::string> renounce_new_privileges();

/// Root becomes this user, for good: user, groups and capabilities, and it is looked whether there is a way
/// back. Who is this user already stays as he is. An error is one line, after which the process must end.
[[nodiscard]] tl::expected<void, std::string> become(const Account& account);

/// No core dump, and no look into the memory by others of the same user: it holds keys.
void hide_memory();

}  // namespace talus::server
