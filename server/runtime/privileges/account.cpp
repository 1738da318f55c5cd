#include "runtime/privileges/account.h"

#include <grp.h>
#include <pwd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include "runtime/log/escape.h"

namespace talus::server {
namespace {

struct Entry {
  uid_t uid;
  gid_t gid;
  std::string name;
};

template <typename Ask>
std::optional<Entry> entry_of(Ask&& ask) {
  std::vector<char> texts(1024);
  passwd entry{};
  passwd* found = nullptr;
  while (ask(&entry, texts.data(), texts.size(), &found) == ERANGE) texts.resize(2 * texts.size());
  if (found == nullptr) return std::nullopt;
  return Entry{entry.pw_uid, entry.pw_gid, entry.pw_name};
}

std::vector<gid_t> groups_of(const Entry& entry) {
  std::vector<gid_t> groups(64);
  int count = static_cast<int>(groups.size());
  while (::getgrouplist(entry.name.c_str(), entry.gid, groups.data(), &count) < 0) {
    groups.resize(static_cast<std::size_t>(count));
  }
  groups.resize(static_cast<std::size_t>(count));
  return groups;
}

/// The largest id means "no change" to the system.
std::optional<std::uint32_t> id_of(std::string_view text) {
  std::uint32_t id = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), id);
  const bool whole = !text.empty() && error == std::errc{} && stop == text.data() + text.size();
  return whole && id != std::numeric_limits<std::uint32_t>::max() ? std::optional{id} : std::nullopt;
}

}  // namespace

tl::expected<Account, std::string> find_account(std::string_view text) {
  const auto wrong = [&](std::string_view why) {
    return tl::make_unexpected(fmt::format(
        "user: \"{}\" {}; give the NAME of a user other than root, UID or UID:GID", escaped(text), why));
  };
  Account account{std::string{text}, 0, 0, {}};
  const std::size_t colon = text.find(':');
  if (const auto uid = id_of(text.substr(0, colon))) {
    account.uid = *uid;
    if (colon != std::string_view::npos) {
      const auto gid = id_of(text.substr(colon + 1));
      if (!gid) return wrong("has no group id after the colon");
      account.gid = *gid;
    } else {
      const auto entry = entry_of([&](auto... out) { return ::getpwuid_r(*uid, out...); });
      if (!entry) return wrong("has no entry in the user database, which would name its group");
      account.gid = entry->gid;
    }
  } else {
    const auto entry = entry_of([&](passwd* one, char* texts, std::size_t size, passwd** found) {
      return ::getpwnam_r(account.name.c_str(), one, texts, size, found);
    });
    if (!entry) return wrong("is not a user of this system");
    account.uid = entry->uid;
    account.gid = entry->gid;
    account.groups = groups_of(*entry);
  }
  if (account.uid == 0) return wrong("is root");
  if (account.gid == 0 || std::count(account.groups.begin(), account.groups.end(), gid_t{0}) != 0) {
    return wrong("is in root's group");
  }
  return account;
}

}  // namespace talus::server
