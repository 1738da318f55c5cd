// Dropping privileges. What changes the process runs in a child process.
#include "runtime/privileges/privileges.h"

#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <catch2/catch.hpp>

#include "in_child.h"

using namespace talus::server;

namespace {

bool switching_shows_memory = false;

bool root_is_needed() {
  if (::geteuid() == 0) return false;
  WARN("only root can drop privileges: not tested");
  return true;
}

std::string account_error(const std::string& text) {
  const auto account = find_account(text);
  REQUIRE_FALSE(account.has_value());
  CHECK(account.error().find('\n') == std::string::npos);
  CHECK_THAT(account.error(), Catch::StartsWith("user: \"") && Catch::Contains("UID:GID"));
  return account.error();
}

}  // namespace

// Under the thread sanitizer a function in libc's place breaks what the sanitizer has there.
#ifndef __SANITIZE_THREAD__
/// In libc's place: what a system does whose fs.suid_dumpable is 1.
extern "C" int setresuid(uid_t real, uid_t effective, uid_t saved) noexcept {
  const auto done = ::syscall(SYS_setresuid, real, effective, saved);
  if (done == 0 && switching_shows_memory) ::prctl(PR_SET_DUMPABLE, 1, 0, 0, 0);
  return static_cast<int>(done);
}
#endif

TEST_CASE("a user is found by name, by number, and by numbers that no name has") {
  const auto nobody = find_account("nobody");
  REQUIRE(nobody.has_value());
  CHECK(nobody->uid != 0);
  CHECK(find_account(std::to_string(nobody->uid))->gid == nobody->gid);
  const auto numbers = find_account("4780:4781");
  REQUIRE(numbers.has_value());
  CHECK(numbers->uid == 4780);
  CHECK(numbers->gid == 4781);
  CHECK(numbers->groups.empty());
}

TEST_CASE("root in any spelling, and a user that does not exist, is refused") {
  for (const char* text : {"root", "0", "0:0", "0:4780"})
    CHECK_THAT(account_error(text), Catch::Contains("root"));
  CHECK_THAT(account_error("4780:0"), Catch::Contains("root's group"));
  for (const char* text : {"no-such-user", "", ":", "4780:", "4780:x", "-1:5", "4294967295:5", "5:4294967295",
                           "99999999999:5", "nobody:nogroup", "\x1b[2J"}) {
    CAPTURE(text);
    CHECK(account_error(text).find('\x1b') == std::string::npos);
  }
}

TEST_CASE("after switching the process has the user's ids and groups alone, and no way back") {
  if (root_is_needed()) return;
  const int wrong = in_child([] {
    if (!switch_user({"4780:4781", 4780, 4781, {4782}})) return 1;
    uid_t real = 0, effective = 0, saved = 0;
    if (::getresuid(&real, &effective, &saved) != 0 || real != 4780 || effective != 4780 || saved != 4780)
      return 2;
    gid_t groups[8] = {};
    if (::getgroups(8, groups) != 1 || groups[0] != 4782) return 3;
    if (::setuid(0) == 0 || ::seteuid(0) == 0 || ::setresuid(0, 0, 0) == 0 || ::setgid(0) == 0) return 4;
    if (::access("/etc/shadow", R_OK) == 0) return 5;
    return switch_user({"4780:4781", 4780, 4781, {4782}}) ? 0 : 6;  // it is that user already
  });
  CHECK(wrong == 0);
}

TEST_CASE("a user other than root cannot switch") {
  if (root_is_needed()) return;
  const int wrong = in_child([] {
    if (::setuid(4780) != 0) return 1;
    const auto done = switch_user({"4790:4790", 4790, 4790, {}});
    return !done && done.error().find("only root can switch to 4790:4790") != std::string::npos ? 0 : 2;
  });
  CHECK(wrong == 0);
}

TEST_CASE("no_new_privs is set and the memory is hidden") {
  const int wrong = in_child([] {
    if (!set_no_new_privs() || ::prctl(PR_GET_NO_NEW_PRIVS, 0, 0, 0, 0) != 1) return 1;
    if (!hide_memory()) return 2;
    return ::prctl(PR_GET_DUMPABLE, 0, 0, 0, 0) == 0 ? 0 : 3;
  });
  CHECK(wrong == 0);
}

TEST_CASE("after switching users the memory is hidden, even if the system would show it") {
  if (root_is_needed()) return;
  const int wrong = in_child([] {
    if (!hide_memory()) return 1;
    switching_shows_memory = true;
    if (!switch_user({"4780:4781", 4780, 4781, {}})) return 2;
    return ::prctl(PR_GET_DUMPABLE, 0, 0, 0, 0) == 0 ? 0 : 3;
  });
  CHECK(wrong == 0);
}
