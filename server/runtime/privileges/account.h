// The user, group and supplementary groups of a process.
#pragma once

#include <sys/types.h>

#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

namespace talus::server {

struct Account {
  std::string name;  // as given to find_account()
  uid_t uid = 0;
  gid_t gid = 0;
  std::vector<gid_t> groups;  // supplementary groups
};

/// Accepts NAME, with all groups of that user; UID, with only that user's primary group; or UID:GID. Rejects
/// root and root's group. An error is one line that begins with "user: ".
[[nodiscard]] tl::expected<Account, std::string> find_account(std::string_view text);

}  // namespace talus::server
