// Whom the system knows a process as.
#pragma once

#include <sys/types.h>

#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

namespace talus::server {

struct Account {
  std::string name;  // as it was given
  uid_t uid = 0;
  gid_t gid = 0;
  std::vector<gid_t> groups;  // besides gid
};

/// A NAME with all groups that it is in, or a UID, or UID:GID, with the one group alone. Root is none of
/// them. An error is one line.
[[nodiscard]] tl::expected<Account, std::string> find_account(std::string_view text);

}  // namespace talus::server
