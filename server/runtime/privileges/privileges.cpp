#include "runtime/privileges/privileges.h"

#include <grp.h>
#include <linux/capability.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <system_error>

#include <fmt/format.h>

namespace talus::server {
namespace {

tl::unexpected<std::string> failed(std::string_view user, std::string_view what, int error) {
  return tl::make_unexpected(
      fmt::format("user: cannot switch to {}: {}: {}", user, what, std::generic_category().message(error)));
}

bool is(const Account& account) {
  uid_t real = 0, effective = 0, saved = 0;
  gid_t real_group = 0, effective_group = 0, saved_group = 0;
  if (::getresuid(&real, &effective, &saved) != 0) return false;
  if (::getresgid(&real_group, &effective_group, &saved_group) != 0) return false;
  return real == account.uid && effective == account.uid && saved == account.uid &&
         real_group == account.gid && effective_group == account.gid && saved_group == account.gid;
}

/// Drops inheritable and ambient capabilities. The kernel drops the others when the user changes.
void drop_capabilities() {
  __user_cap_header_struct header{_LINUX_CAPABILITY_VERSION_3, 0};
  const std::array<__user_cap_data_struct, _LINUX_CAPABILITY_U32S_3> none{};
  ::prctl(PR_CAP_AMBIENT, PR_CAP_AMBIENT_CLEAR_ALL, 0, 0, 0);
  ::syscall(SYS_capset, &header, none.data());
}

bool has_capabilities() {
  __user_cap_header_struct header{_LINUX_CAPABILITY_VERSION_3, 0};
  std::array<__user_cap_data_struct, _LINUX_CAPABILITY_U32S_3> sets{};
  if (::syscall(SYS_capget, &header, sets.data()) != 0) return true;
  return std::any_of(sets.begin(), sets.end(),
                     [](const auto& set) { return (set.effective | set.permitted | set.inheritable) != 0; });
}

bool is_in_root_group() {
  std::array<gid_t, 65536> groups{};
  const int count = ::getgroups(static_cast<int>(groups.size()), groups.data());
  return count < 0 || std::find(groups.begin(), groups.begin() + count, gid_t{0}) != groups.begin() + count;
}

}  // namespace

bool runs_as_root() {
  return ::geteuid() == 0;
}

tl::expected<void, std::string> set_no_new_privs() {
  if (::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0) return {};
  return tl::make_unexpected(
      fmt::format("cannot set no_new_privs: {}", std::generic_category().message(errno)));
}

tl::expected<void, std::string> switch_user(const Account& account) {
  if (!runs_as_root()) {
    if (is(account)) return {};
    return tl::make_unexpected(fmt::format(
        "user: only root can switch to {}; start talusd as root, or as that user with user = \"\"",
        account.name));
  }
  // Groups first, because only root may change them.
  if (::setgroups(account.groups.size(), account.groups.data()) != 0)
    return failed(account.name, "groups", errno);
  if (::setresgid(account.gid, account.gid, account.gid) != 0) return failed(account.name, "group", errno);
  if (::setresuid(account.uid, account.uid, account.uid) != 0) return failed(account.name, "user", errno);
  drop_capabilities();
  const bool way_back = ::setuid(0) == 0 || ::seteuid(0) == 0 || ::setgid(0) == 0 || ::setegid(0) == 0;
  if (way_back || !is(account) || has_capabilities() || is_in_root_group()) {
    return tl::make_unexpected(fmt::format(
        "user: switched to {}, but privileges of root are left; does this process run with unusual "
        "securebits or in a user namespace?",
        account.name));
  }
  return hide_memory();  // if fs.suid_dumpable is not 0, switching exposed it
}

tl::expected<void, std::string> hide_memory() {
  if (::prctl(PR_SET_DUMPABLE, 0, 0, 0, 0) == 0 && ::prctl(PR_GET_DUMPABLE, 0, 0, 0, 0) == 0) return {};
  return tl::make_unexpected(std::string{"cannot keep the process's memory out of core dumps and debuggers"});
}

}  // namespace talus::server
